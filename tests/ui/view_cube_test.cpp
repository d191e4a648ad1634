// The view cube: where a click turns the camera, and what its picture shows.
#include <cmath>
#include <memory>
#include <optional>

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/quaternion.hpp>

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

constexpr float half_edge = 0.46f;  // of the cube, in halves of its square

struct FakeView : ViewInput {
  Interactor& camera_of;
  mutable Camera current;
  double now = 0;
  bool animated = false, still = true;

  explicit FakeView(Interactor& camera) : camera_of(camera) {}
  glm::ivec2 size() const override { return {800, 600}; }
  const Camera& camera() const override { return current = camera_of.camera(); }
  Bounds scene() const override { return {glm::vec3(-1), glm::vec3(1)}; }
  Bounds selection() const override { return scene(); }
  std::optional<glm::vec3> surface_at(glm::vec2) override { return std::nullopt; }
  std::string instance_at(glm::vec2) override { return {}; }
  bool blender_keys() const override { return false; }
  double time() const override { return now; }
  bool reduced_motion() const override { return still; }
  void animate() override { animated = true; }
};

struct ViewCube : ::testing::Test {
  lumenshop::Registry registry{{lumenshop::Installation::find().plugins()}, nullptr};
  std::unique_ptr<lumenshop::Session> session;
  Interactor *orbit = nullptr, *cube = nullptr;

  void SetUp() override {
    registry.load_all();
    session = std::make_unique<lumenshop::Session>(registry);
    session->load(lumenshop::Json::parse(R"({"lumenshop": 1,
      "plugins": {"eye": {"type": "interactor.orbit"}, "cube": {"type": "interactor.view_cube", "size": 0.2}},
      "views": {"main": {"camera": "eye", "interactors": ["cube", "eye"]}}})"), lumenshop::Installation::find().root);
    session->update();
    orbit = session->find("eye")->as<Interactor>(Kind::interactor);
    cube = session->find("cube")->as<Interactor>(Kind::interactor);
    ASSERT_TRUE(session->problems().empty()) << session->problems().front().message;
  }
  glm::quat rotation() const {
    const auto [instance, slot] = session->resolve("eye.rotation");
    return std::get<glm::quat>(instance->read(slot));
  }
  /// Where a point of the cube's surface is in the view: the square of 120 pixels is at the top right.
  glm::vec2 pixel_of(glm::vec3 point) const {
    const glm::vec3 eye = rotation() * point;
    return glm::vec2(740, 60) + 60 * half_edge * glm::vec2(eye.x, -eye.y);
  }
  bool click(glm::vec2 pixel, FakeView& view) const {
    const bool claimed = cube->input({.type = Type::press, .button = Button::left, .position = pixel}, view);
    if (claimed) cube->input({.type = Type::release, .button = Button::left, .position = pixel}, view);
    session->update();
    return claimed;
  }
};

TEST_F(ViewCube, EachOfItsPlacesTurnsTheEyeToItsSide) {
  FakeView view(*orbit);
  int places = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        ++places;
        const glm::vec3 place(x, y, z), outward = glm::normalize(place);
        // A view from which the place is seen, turned away from it and rolled.
        const glm::quat facing = glm::rotation(outward, glm::vec3(0, 0, 1));
        session->set("eye.rotation", Value(glm::normalize(glm::angleAxis(0.35f, glm::normalize(glm::vec3(1, 0.3f, 0.8f))) * facing)));
        session->update();
        ASSERT_TRUE(click(pixel_of(place * 0.97f), view)) << x << y << z;
        const glm::vec3 toward_eye = glm::inverse(rotation()) * glm::vec3(0, 0, 1), up = glm::inverse(rotation()) * glm::vec3(0, 1, 0);
        EXPECT_NEAR(glm::distance(toward_eye, outward), 0, 1e-4f) << x << y << z;
        if (x != 0 || y != 0) EXPECT_GT(up.z, 0.5f) << "z is up from " << x << y << z;
        else EXPECT_NEAR(up.y, float(z), 1e-4f);
      }
  EXPECT_EQ(places, 26);
}

TEST_F(ViewCube, ItsFacesAreTheStandardViews) {
  FakeView view(*orbit);
  const std::pair<glm::vec3, InputEvent> faces[] = {
      {{0, -1, 0}, {.type = Type::key, .key = "1"}}, {{0, 1, 0}, {.type = Type::key, .control = true, .key = "1"}},
      {{1, 0, 0}, {.type = Type::key, .key = "3"}},  {{-1, 0, 0}, {.type = Type::key, .control = true, .key = "3"}},
      {{0, 0, 1}, {.type = Type::key, .key = "7"}},  {{0, 0, -1}, {.type = Type::key, .control = true, .key = "7"}}};
  for (const auto& [face, key] : faces) {
    orbit->input(key, view);
    const glm::quat standard = rotation();
    session->set("eye.rotation", Value(glm::normalize(glm::angleAxis(0.4f, glm::normalize(glm::vec3(1, 0.5f, 0.2f))) * standard)));
    session->update();
    ASSERT_TRUE(click(pixel_of(face), view));
    EXPECT_NEAR(std::abs(glm::dot(rotation(), standard)), 1, 1e-5f) << key.key << key.control;
  }
}

TEST_F(ViewCube, OnlyTheCubeItselfTakesClicks) {
  FakeView view(*orbit);
  const glm::quat before = rotation();
  // Seen from the front it fills the middle 0.46 of its square of 120 pixels.
  for (const glm::vec2 beside : {glm::vec2(740, 60 - 29), glm::vec2(740 + 29, 60), glm::vec2(685, 60), glm::vec2(400, 300), glm::vec2(60, 60)}) EXPECT_FALSE(click(beside, view));
  EXPECT_EQ(rotation(), before);
  EXPECT_TRUE(click({740, 60 - 26}, view));
  EXPECT_FALSE(cube->input({.type = Type::press, .button = Button::right, .position = {740, 60}}, view));
  EXPECT_FALSE(cube->input({.type = Type::press, .button = Button::left, .position = {740, 60}, .held = "L"}, view)) << "that turns a light";
  session->set("cube.corner", Value(Choice{"bottom_left"}));
  EXPECT_FALSE(click({740, 60}, view));
  EXPECT_TRUE(click({60, 540}, view));
}

TEST_F(ViewCube, ATurnIsEasedAndEndsThere) {
  FakeView view(*orbit);
  view.still = false;
  const glm::quat before = rotation();
  ASSERT_TRUE(click(pixel_of(glm::vec3(0.95f, -1, 0)), view));
  EXPECT_TRUE(view.animated);
  EXPECT_EQ(rotation(), before);
  view.now = 0.1;
  cube->tick(view);
  session->update();
  const glm::vec3 halfway = glm::inverse(rotation()) * glm::vec3(0, 0, 1);
  EXPECT_NEAR(glm::degrees(std::acos(glm::dot(halfway, glm::vec3(0, -1, 0)))), 22.5, 0.1);
  view.now = 0.3;
  view.animated = false;
  cube->tick(view);
  EXPECT_FALSE(view.animated);
  EXPECT_NEAR(glm::distance(glm::inverse(rotation()) * glm::vec3(0, 0, 1), glm::normalize(glm::vec3(1, -1, 0))), 0, 1e-5f);
}

TEST_F(ViewCube, DraggingTurnsAndReleasingDoesNotLookFromThere) {
  FakeView view(*orbit);
  const glm::quat before = rotation();
  ASSERT_TRUE(cube->input({.type = Type::press, .button = Button::left, .position = {740, 60}}, view));
  cube->input({.type = Type::move, .button = Button::left, .position = {755, 60}}, view);
  session->update();
  const glm::quat dragged = rotation();
  EXPECT_LT(std::abs(glm::dot(dragged, before)), 0.999f);
  // What was in front follows the pointer.
  EXPECT_GT((dragged * glm::vec3(0, -1, 0)).x, 0.1f);
  cube->input({.type = Type::move, .button = Button::left, .position = {740, 60}}, view);
  EXPECT_NEAR(std::abs(glm::dot(rotation(), before)), 1, 1e-6f) << "going back undoes it";
  cube->input({.type = Type::move, .button = Button::left, .position = {755, 60}}, view);
  cube->input({.type = Type::release, .button = Button::left, .position = {755, 60}}, view);
  EXPECT_NEAR(std::abs(glm::dot(rotation(), dragged)), 1, 1e-6f);
}

TEST_F(ViewCube, HoveringMarksAPlaceWithoutSettingAnything) {
  FakeView view(*orbit);
  const auto hovered = [&] {
    const auto [instance, slot] = session->resolve("cube.hovered");
    EXPECT_FALSE(instance->is_set(slot));
    return std::get<int>(instance->read(slot));
  };
  EXPECT_TRUE(cube->input({.type = Type::move, .position = {740, 60}}, view));
  EXPECT_EQ(hovered(), 0 + 9 + 0 + 1) << "x 0, y -1, z 0: 9 (x + 1) + 3 (y + 1) + z + 1";
  EXPECT_FALSE(cube->input({.type = Type::move, .position = {400, 300}}, view));
  EXPECT_EQ(hovered(), 13);
}

TEST_F(ViewCube, TheCameraCanBeNamed) {
  session->add("interactor.orbit", "other");
  session->set("cube.camera", Value(Reference{"other"}));
  session->update();
  FakeView view(*session->find("other")->as<Interactor>(Kind::interactor));
  const glm::quat before = rotation();
  ASSERT_TRUE(click({740, 60 - 26}, view));
  EXPECT_EQ(rotation(), before);
  EXPECT_NEAR(glm::distance(glm::inverse(std::get<glm::quat>(session->find("other")->read(session->find("other")->slot_of("rotation")))) * glm::vec3(0, 0, 1),
                            glm::normalize(glm::vec3(0, -1, 1))), 0, 1e-5f);
}

// --- its picture: a square of 100 pixels at the top right of 200 x 100.

struct Shown : lumen::testing::Scene {
  Shown() : Scene({200, 100}) {
    add("interactor.view_cube", "cube", R"({"size": 1, "opacity": 1})");
    surface("ball", lumen::testing::sphere(16, 0.1f));
    set("camera.pivot", "[1.5, 0, 0]");  // beside the square
  }
};

TEST(ViewCubePicture, EachSideShowsItsAxissColorWhenTheSceneIsTurnedToIt) {
  Shown scene;
  const glm::vec3 sides[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  float bright[3] = {};
  for (const glm::vec3 side : sides) {
    scene.set_value("camera.rotation", Value(glm::rotation(side, glm::vec3(0, 0, 1))));
    const glm::vec3 color = scene.picture().rgb(150 + 17, 50 + 17);  // beside the letter
    const int axis = side.x != 0 ? 0 : side.y != 0 ? 1 : 2;
    for (int other = 0; other < 3; ++other)
      if (other != axis) { EXPECT_GT(color[axis], color[other] + 0.05f) << side.x << side.y << side.z; }
    if (side[axis] > 0) bright[axis] = color[axis];
    else EXPECT_LT(color[axis], bright[axis] - 0.05f) << "the negative side is darker";
  }
  EXPECT_TRUE(scene.problems().empty());
}

TEST(ViewCubePicture, ItsOutlineIsTheTurnedCubes) {
  Shown scene;
  scene.set("cube.lights", "false");
  for (const glm::quat& rotation : {glm::quat(1, 0, 0, 0), glm::angleAxis(0.7f, glm::vec3(0, 1, 0)), glm::angleAxis(1.1f, glm::normalize(glm::vec3(1, 2, 0.5f)))}) {
    scene.set_value("camera.rotation", Value(rotation));
    const Pixels picture = scene.picture();
    for (int y = 0; y < 100; ++y)
      for (int x = 100; x < 200; ++x) {
        // In parallel projection a point is on the cube if the line through it meets all three slabs at once.
        const glm::vec3 from = glm::inverse(rotation) * glm::vec3(glm::vec2(float(x) + 0.5f - 150, 50 - (float(y) + 0.5f)) / (50 * half_edge), 0), along = glm::inverse(rotation) * glm::vec3(0, 0, 1);
        bool on = false, near = false;
        for (float t = -2; t <= 2; t += 0.01f) {
          const glm::vec3 p = glm::abs(from + t * along);
          const float most = std::max(p.x, std::max(p.y, p.z));
          on = on || most <= 0.94f;
          near = near || most <= 1.06f;
        }
        const float alpha = picture.rgba(x, y).a;
        if (on) { EXPECT_EQ(alpha, 1) << x << " " << y; }
        if (!near) { EXPECT_EQ(alpha, 0) << x << " " << y; }
      }
  }
}

TEST(ViewCubePicture, LightsAreWhereTheyShineFromInTheirColors) {
  Shown scene;
  const glm::quat rotation = glm::angleAxis(0.6f, glm::normalize(glm::vec3(1, 1, 0)));
  scene.set_value("camera.rotation", Value(rotation));
  scene.set("front.color", "[1, 0, 0]");
  scene.set("front.direction", "[3, 1, 0.5]");
  scene.add("interactor.light", "lamp", R"({"kind": "point", "position": [-2.5, 8, 1], "color": [0, 0, 1], "intensity": 5})");
  scene.add("interactor.light", "hidden", R"({"color": [0, 1, 0]})");
  scene.set_value("hidden.direction", Value(glm::inverse(rotation) * glm::vec3(0, 0, -1)));
  const Pixels picture = scene.picture();
  const auto at = [&](glm::vec3 direction) {
    const glm::vec3 eye = rotation * glm::normalize(direction);
    return picture.rgb(int(150 + 50 * 0.86f * eye.x), int(50 - 50 * 0.86f * eye.y));
  };
  EXPECT_EQ(at({3, 1, 0.5f}), glm::vec3(1, 0, 0));
  EXPECT_EQ(at({-4, 8, 1}), glm::vec3(0, 0, 1)) << "a strong light keeps its hue";
  for (int y = 0; y < 100; ++y)
    for (int x = 100; x < 200; ++x) EXPECT_FALSE(picture.at(x, y, 1) > 0.9f && picture.at(x, y) < 0.1f) << "the one behind the cube is not seen";
}

TEST(ViewCubePicture, TheRestOfThePictureIsAsItWas) {
  lumen::testing::Scene scene({64, 64});
  scene.add("ambient.constant", "ambient");
  scene.surface("ball", lumen::testing::sphere(), R"({"ambient": "ambient"})");
  scene.add("compositor.background", "behind");
  const Pixels before = scene.picture();
  scene.add("interactor.view_cube", "cube", R"({"size": 0.25})");
  const Pixels after = scene.picture();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      if (x < 48 || y >= 16) { EXPECT_EQ(after.rgba(x, y), before.rgba(x, y)); }
  scene.picture();
  EXPECT_EQ(scene.runs("cube"), 1);
  EXPECT_EQ(scene.runs("geometry"), 1);
}

}  // namespace
