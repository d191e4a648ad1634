// interactor.explode: what the pointer and the keys do to the parts of a splitter.explode.
#include <memory>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <lumen/interactor.h>
#include <lumen/splitter.h>
#include <lumen/testing.h>

#include "installation.h"
#include "model/session.h"
#include "modules/registry.h"

namespace {

using namespace lumen;
using Type = InputEvent::Type;
using Button = InputEvent::Button;

/// Two balls side by side; the pointer is on what `under` says. 100 pixels are a world unit.
struct FakeView : ViewInput {
  Camera looking{.view = glm::translate(glm::mat4(1), {0, 0, -10}), .orthographic = true, .height = 6, .distance = 10};
  std::shared_ptr<const Mesh> mesh = lumen::testing::joined({lumen::testing::moved(*lumen::testing::sphere(8), {-1.5f, 0, 0}), lumen::testing::moved(*lumen::testing::sphere(8), {1.5f, 0, 0})});
  std::optional<int> under;  ///< part
  double now = 0;
  bool animated = false, still = false;

  glm::ivec2 size() const override { return {800, 600}; }
  const Camera& camera() const override { return looking; }
  Bounds scene() const override { return mesh->bounds(); }
  Bounds selection() const override { return scene(); }
  std::optional<glm::vec3> surface_at(glm::vec2) override { return under ? std::optional(glm::vec3(*under == 0 ? -1.5f : 1.5f, 0, 1)) : std::nullopt; }
  std::string instance_at(glm::vec2) override { return under ? "balls" : ""; }
  std::optional<Picked> pick(glm::vec2 pixel, const std::vector<std::string>&) override {
    if (!under) return std::nullopt;
    return Picked{.renderer = "balls", .part = *under, .cell = *under == 0 ? 0 : int(mesh->triangles.size()) - 1, .position = *surface_at(pixel), .mesh = mesh};
  }
  bool blender_keys() const override { return false; }
  double time() const override { return now; }
  bool reduced_motion() const override { return still; }
  void animate() override { animated = true; }
};

struct ExplodeHand : ::testing::Test {
  lumenshop::Registry registry{{lumenshop::Installation::find().plugins()}, nullptr};
  std::unique_ptr<lumenshop::Session> session;
  Interactor* hand = nullptr;
  FakeView view;

  void SetUp() override {
    registry.load_all();
    load(R"({"type": "splitter.explode", "degree": 0})");
  }
  void load(const std::string& splitter) {
    session = std::make_unique<lumenshop::Session>(registry);
    session->load(lumenshop::Json::parse(R"({"lumenshop": 1, "plugins": {"hand": {"type": "interactor.explode", "splitter": "parts", "duration": 1},
      "parts": )" + splitter + R"(}, "views": {"main": {"interactors": ["hand"]}}})"), lumenshop::Installation::find().root);
    for (int i = 0; i < 3; ++i) session->update();
    hand = session->find("hand")->as<Interactor>(Kind::interactor);
  }
  template <class T> T value(const std::string& path) const {
    const auto [instance, slot] = session->resolve(path);
    return std::get<T>(instance->read(slot));
  }
  /// How far the splitter takes the part.
  float moved(std::size_t part) {
    session->update();
    const Split split = session->find("parts")->as<Splitter>(Kind::splitter)->split({.mesh = view.mesh, .bounds = view.mesh->bounds(), .camera = view.looking});
    session->update();
    return glm::length(glm::vec3(split.parts.at(part).transform[3]));
  }
  bool send(InputEvent event) {
    const bool claimed = hand->input(event, view);
    session->update();
    return claimed;
  }
  void point_at(std::optional<int> part, glm::vec2 position) {
    view.under = part;
    send({.type = Type::move, .position = position});
  }
  bool click(int part) {
    view.under = part;
    const bool claimed = send({.type = Type::press, .button = Button::left, .position = {100, 100}});
    send({.type = Type::release, .button = Button::left, .position = {100, 100}});
    return claimed;
  }
  /// Frames of a tenth of a second until nothing moves.
  int ticks() {
    int count = 0;
    while (std::exchange(view.animated, false) && ++count < 100) {
      view.now += 0.1;
      hand->tick(view);
      session->update();
    }
    return count;
  }
};

TEST_F(ExplodeHand, APartUnderThePointerComesOutAndGoesBackWhenThePointerLeaves) {
  EXPECT_EQ(moved(1), 0);
  point_at(1, {500, 300});
  EXPECT_NEAR(ticks(), 10, 1) << "a second long";
  EXPECT_GT(moved(1), 0.1f);
  EXPECT_EQ(moved(0), 0);
  point_at(std::nullopt, {505, 300});
  EXPECT_EQ(ticks(), 0) << "it does not go to and fro where it has left the pointer";
  point_at(std::nullopt, {540, 300});
  ticks();
  EXPECT_EQ(moved(1), 0);
  EXPECT_TRUE(value<std::vector<float>>("hand.riffled").empty());
  EXPECT_FALSE(session->find("parts")->is_set(session->find("parts")->slot_of("pulled"))) << "what the pointer only passed is not saved";
}

TEST_F(ExplodeHand, ReducedMotionJumps) {
  view.still = true;
  point_at(0, {300, 300});
  EXPECT_EQ(ticks(), 1);
  EXPECT_EQ(value<std::vector<float>>("parts.riffled"), std::vector<float>{1});
}

TEST_F(ExplodeHand, AClickKeepsAPartOutAndTheNextLetsItGo) {
  EXPECT_TRUE(click(1));
  EXPECT_EQ(value<std::vector<float>>("parts.pulled"), (std::vector<float>{0, 1}));
  const float out = moved(1);
  EXPECT_GT(out, 0.1f);
  point_at(std::nullopt, {10, 10});
  ticks();
  EXPECT_EQ(moved(1), out);
  EXPECT_TRUE(click(1));
  EXPECT_EQ(moved(1), 0);
}

TEST_F(ExplodeHand, AClickKeepsThePartThatHasComeOutFromUnderThePointer) {
  point_at(1, {500, 300});
  ticks();
  // It is gone from there: what is behind it, or nothing, is under the pointer by now.
  for (const std::optional<int> behind : {std::optional<int>(), std::optional(0)}) {
    point_at(behind, {502, 301});
    EXPECT_TRUE(send({.type = Type::press, .button = Button::left, .position = {502, 301}}));
    send({.type = Type::release, .button = Button::left, .position = {502, 301}});
    EXPECT_EQ(value<std::vector<float>>("parts.pulled"), behind ? std::vector<float>{} : (std::vector<float>{0, 1}));
  }
}

TEST_F(ExplodeHand, ADragSlidesAPartAlongItsWay) {
  load(R"({"type": "splitter.explode", "degree": 0, "layout": "graph"})");
  moved(0);
  const auto ways = value<std::vector<float>>("hand.ways");
  ASSERT_EQ(ways.size(), 6u);
  const int part = ways[0] != 0 ? 0 : 1;  // the other one stays
  const float way = ways[std::size_t(3 * part)];
  ASSERT_GT(std::abs(way), 0.1f);
  view.under = part;
  EXPECT_TRUE(send({.type = Type::press, .button = Button::left, .position = {400, 300}}));
  // A quarter of its way, and something across, which does not matter.
  send({.type = Type::move, .button = Button::left, .position = {400 + 25 * way, 320}});
  EXPECT_NEAR(value<std::vector<float>>("parts.pulled").at(std::size_t(part)), 0.25f, 1e-4f);
  EXPECT_NEAR(moved(std::size_t(part)), 0.25f * std::abs(way), 1e-4f);
  send({.type = Type::move, .button = Button::left, .position = {400 + 500 * way, 320}});
  EXPECT_EQ(value<std::vector<float>>("parts.pulled").at(std::size_t(part)), 1);
  EXPECT_TRUE(send({.type = Type::release, .button = Button::left, .position = {400 + 500 * way, 320}}));
  EXPECT_EQ(value<std::vector<float>>("parts.pulled").at(std::size_t(part)), 1) << "the end of a drag is no click";
}

TEST_F(ExplodeHand, ETakesAllApartAndPutsAllTogether) {
  EXPECT_TRUE(send({.type = Type::key, .key = "E"}));
  ticks();
  EXPECT_EQ(value<float>("parts.degree"), 1);
  EXPECT_TRUE(send({.type = Type::key, .key = "E"}));
  EXPECT_NEAR(ticks(), 10, 1);
  EXPECT_EQ(value<float>("parts.degree"), 0);
  click(0);
  EXPECT_TRUE(send({.type = Type::key, .shift = true, .key = "E"}));
  EXPECT_EQ(moved(0), 0);
  EXPECT_FALSE(send({.type = Type::key, .key = "F"}));
}

TEST_F(ExplodeHand, LeavesTheCameraWhatIsTheCameras) {
  view.under = 1;
  EXPECT_FALSE(send({.type = Type::press, .button = Button::left, .shift = true}));
  EXPECT_FALSE(send({.type = Type::press, .button = Button::left, .control = true}));
  EXPECT_FALSE(send({.type = Type::press, .button = Button::middle}));
  EXPECT_FALSE(send({.type = Type::press, .button = Button::left, .held = "L"}));
  EXPECT_FALSE(send({.type = Type::wheel, .wheel = 1}));
  view.under.reset();
  EXPECT_FALSE(send({.type = Type::press, .button = Button::left}));
}

TEST_F(ExplodeHand, SaysWhenTheSplitterIsNoneOfItsKind) {
  load(R"({"type": "splitter.plane"})");
  EXPECT_FALSE(session->problems().empty());
  view.under = 1;
  EXPECT_NO_THROW(send({.type = Type::move, .position = {5, 5}}));
  EXPECT_NO_THROW(ticks());
}

TEST_F(ExplodeHand, ASessionThatWasSavedIsAsItWas) {
  click(1);
  const lumenshop::Json saved = session->to_json();
  session = std::make_unique<lumenshop::Session>(registry);
  session->load(saved, lumenshop::Installation::find().root);
  for (int i = 0; i < 3; ++i) session->update();
  EXPECT_GT(moved(1), 0.1f);
  EXPECT_TRUE(session->problems().empty());
}

}  // namespace
