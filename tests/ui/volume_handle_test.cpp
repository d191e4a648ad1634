// The handles of a cut volume: what dragging them sets, in one undo step, and what their picture shows.
#include <cmath>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include <lumen/interactor.h>
#include <lumen/testing.h>

#include "installation.h"
#include "model/session.h"
#include "modules/registry.h"

namespace {

using namespace lumen;
using lumen::testing::Pixels;
using Type = InputEvent::Type;
using Button = InputEvent::Button;

/// Parallel along +y, z up: 100 pixels per world unit about the origin in the middle of 800 x 600.
struct FixedView : ViewInput {
  Camera eye{.orthographic = true, .height = 6, .distance = 10};
  FixedView() { eye.view = glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, -10, 1)); }
  glm::ivec2 size() const override { return {800, 600}; }
  const Camera& camera() const override { return eye; }
  Bounds scene() const override { return {glm::vec3(-1), glm::vec3(1)}; }
  Bounds selection() const override { return scene(); }
  std::optional<glm::vec3> surface_at(glm::vec2) override { return std::nullopt; }
  std::string instance_at(glm::vec2) override { return {}; }
  bool blender_keys() const override { return false; }
  double time() const override { return 0; }
  void animate() override {}
};

struct VolumeHandle : ::testing::Test {
  lumenshop::Registry registry{{lumenshop::Installation::find().plugins()}, nullptr};
  std::unique_ptr<lumenshop::Session> session;
  Interactor* handle = nullptr;
  FixedView view;

  void SetUp() override {
    registry.load_all();
    session = std::make_unique<lumenshop::Session>(registry);
    session->load(lumenshop::Json::parse(R"({"lumenshop": 1,
      "plugins": {"cut": {"type": "splitter.volume", "center": [0, 0, 0], "radius": 1, "size": [1, 2, 3], "length": 2, "angle": 90},
                  "handle": {"type": "interactor.volume_handle", "volume": "cut"}},
      "views": {"main": {"interactors": ["handle"]}}})"), lumenshop::Installation::find().root);
    session->update();
    handle = session->find("handle")->as<Interactor>(Kind::interactor);
    ASSERT_TRUE(session->problems().empty()) << session->problems().front().message;
  }
  template <class T> T value(const std::string& path) const {
    const auto [instance, slot] = session->resolve(path);
    return std::get<T>(instance->read(slot));
  }
  void shape(const char* kind) {
    session->set("cut.shape", Choice{kind});
    session->update();
  }
  /// From and to places of the plane y = 0, x and z; as the window does it: one edit. Whether it was claimed.
  bool drag(glm::vec2 from, glm::vec2 to) {
    const auto pixel = [](glm::vec2 place) { return glm::vec2(400 + 100 * place.x, 300 - 100 * place.y); };
    session->begin_edit();
    const bool claimed = handle->input({.type = Type::press, .button = Button::left, .position = pixel(from)}, view);
    for (const float share : {0.5f, 1.0f}) {
      if (claimed) handle->input({.type = Type::move, .button = Button::left, .position = pixel(glm::mix(from, to, share))}, view);
      session->update();
    }
    if (claimed) handle->input({.type = Type::release, .button = Button::left, .position = pixel(to)}, view);
    session->end_edit();
    return claimed;
  }
  void expect_center(glm::vec3 expected) const { EXPECT_NEAR(glm::distance(value<glm::vec3>("cut.center"), expected), 0, 1e-4f); }
};

TEST_F(VolumeHandle, TheMiddleMovesTheVolumeInOneUndoStep) {
  ASSERT_TRUE(drag({0, 0}, {0.7f, -0.4f}));
  expect_center({0.7f, 0, -0.4f});
  session->history().undo();
  session->update();
  expect_center({0, 0, 0});
}

TEST_F(VolumeHandle, TheRimOfASphereSetsItsRadius) {
  ASSERT_TRUE(drag({1, 0}, {1.5f, 0}));
  EXPECT_NEAR(value<float>("cut.radius"), 1.5f, 1e-4f);
  expect_center({0, 0, 0});
  ASSERT_TRUE(drag({0, -1.5f}, {0, -0.25f}));
  EXPECT_NEAR(value<float>("cut.radius"), 0.25f, 1e-4f);
  ASSERT_TRUE(drag({0.25f, 0}, {-3, 0}));
  EXPECT_EQ(value<float>("cut.radius"), 0) << "never less than nothing";
}

TEST_F(VolumeHandle, AFaceOfABoxMovesAlone) {
  shape("box");
  ASSERT_TRUE(drag({0.5f, 0}, {1.5f, 0}));
  EXPECT_NEAR(glm::distance(value<glm::vec3>("cut.size"), glm::vec3(2, 2, 3)), 0, 1e-4f);
  expect_center({0.5f, 0, 0});
  ASSERT_TRUE(drag({0.5f, -1.5f}, {0.5f, -1.0f}));
  EXPECT_NEAR(glm::distance(value<glm::vec3>("cut.size"), glm::vec3(2, 2, 2.5f)), 0, 1e-4f);
  expect_center({0.5f, 0, 0.25f});
  session->history().undo();
  session->update();
  EXPECT_NEAR(glm::distance(value<glm::vec3>("cut.size"), glm::vec3(2, 2, 3)), 0, 1e-4f);
  expect_center({0.5f, 0, 0});
}

TEST_F(VolumeHandle, ATubeHasARadiusAndALength) {
  shape("tube");
  ASSERT_TRUE(drag({1, 0}, {0.6f, 0}));
  EXPECT_NEAR(value<float>("cut.radius"), 0.6f, 1e-4f);
  ASSERT_TRUE(drag({0, 1}, {0, 2}));
  EXPECT_NEAR(value<float>("cut.length"), 3, 1e-4f);
  expect_center({0, 0, 0.5f});
}

TEST_F(VolumeHandle, AWedgeOpensByItsRim) {
  shape("wedge");
  // Its axis toward the eye: own x, y, z are world x, z, -y.
  session->set("cut.rotation", Value(glm::angleAxis(glm::radians(90.0f), glm::vec3(1, 0, 0))));
  session->update();
  const float half = std::sqrt(0.5f);
  ASSERT_TRUE(drag({half, half}, {0.5f, std::sqrt(0.75f)}));
  EXPECT_NEAR(value<float>("cut.angle"), 120, 1e-2f);
}

TEST_F(VolumeHandle, ElsewhereTheCameraHasThePointer) {
  EXPECT_FALSE(drag({0.5f, 0.5f}, {1, 1}));
  EXPECT_FALSE(handle->input({.type = Type::wheel, .position = {400, 300}, .wheel = 1}, view));
}

TEST(VolumeHandlePicture, ShowsTheOutlineAndTheHandles) {
  lumen::testing::Scene scene({220, 220});
  scene.surface("plate", lumen::testing::moved(*lumen::testing::rectangle(), {0, 0, -3}));
  const Pixels plain = scene.picture();
  scene.add("splitter.volume", "cut", R"({"center": [0, 0, 0], "radius": 0.8})");
  scene.add("interactor.volume_handle", "handle", R"({"volume": "cut"})");
  const Pixels shown = scene.picture();
  for (const float angle : {0.3f, 1.2f, 2.9f, 4.0f}) {
    const int x = int(110 + 80 * std::cos(angle)), y = int(110 - 80 * std::sin(angle));
    EXPECT_GT(shown.rgb(x, y).g, 0.4f) << "the circle, at " << angle;
    const glm::ivec2 within(110 + (x - 110) / 2, 110 + (y - 110) / 2);
    EXPECT_NEAR(glm::distance(shown.rgba(within.x, within.y), plain.rgba(within.x, within.y)), 0, 1e-3f) << "nothing is drawn there";
  }
  for (const glm::ivec2 place : {glm::ivec2(110, 110), glm::ivec2(190, 110), glm::ivec2(110, 190)}) EXPECT_EQ(shown.rgb(place.x, place.y), glm::vec3(1));
  EXPECT_TRUE(scene.problems().empty());
}

}  // namespace
