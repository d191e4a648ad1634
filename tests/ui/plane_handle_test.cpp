// The plane's handle: what it claims, and how a drag moves and turns the plane of a splitter.
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <lumen/interactor.h>
#include <lumen/testing.h>

#include "installation.h"
#include "model/session.h"
#include "modules/registry.h"

namespace {

using namespace lumen;
using Type = InputEvent::Type;
using Button = InputEvent::Button;

struct FakeView : ViewInput {
  Interactor& camera_of;
  mutable Camera current;
  Cursor cursor = Cursor::arrow;

  explicit FakeView(Interactor& camera) : camera_of(camera) {}
  glm::ivec2 size() const override { return {800, 600}; }
  const Camera& camera() const override { return current = camera_of.camera(); }
  Bounds scene() const override { return {glm::vec3(-1), glm::vec3(1)}; }
  Bounds selection() const override { return scene(); }
  std::optional<glm::vec3> surface_at(glm::vec2) override { return std::nullopt; }
  std::string instance_at(glm::vec2) override { return {}; }
  void set_cursor(Cursor shape) override { cursor = shape; }
  bool blender_keys() const override { return false; }
  double time() const override { return 0; }
  void animate() override {}
};

/// Looking along +y with z up, in parallel, 100 pixels per world unit; the arrow is 120 pixels long and the rings have a radius of
/// 84. The plane's normal is +x, its own x axis is -z, its y axis y; its middle is seen at (450, 275).
struct PlaneHandle : ::testing::Test {
  lumenshop::Registry registry{{lumenshop::Installation::find().plugins()}, nullptr};
  std::unique_ptr<lumenshop::Session> session;
  Interactor *orbit = nullptr, *handle = nullptr;
  std::unique_ptr<FakeView> view;
  static constexpr glm::vec2 middle{450, 275};
  static constexpr float ring = 84;

  void SetUp() override {
    registry.load_all();
    session = std::make_unique<lumenshop::Session>(registry);
    session->load(lumenshop::Json::parse(R"({"lumenshop": 1,
      "plugins": {"eye": {"type": "interactor.orbit", "projection": "orthographic", "height": 6, "distance": 10},
                  "cut": {"type": "splitter.plane", "translation": [0.5, 0, 0.25], "axis": [0, 1, 0], "angle": 90},
                  "handle": {"type": "interactor.plane_handle", "plane": "cut", "size": 0.2}},
      "views": {"main": {"camera": "eye", "interactors": ["handle", "eye"]}}})"), lumenshop::Installation::find().root);
    session->update();
    orbit = session->find("eye")->as<Interactor>(Kind::interactor);
    handle = session->find("handle")->as<Interactor>(Kind::interactor);
    view = std::make_unique<FakeView>(*orbit);
    ASSERT_TRUE(session->problems().empty()) << session->problems().front().message;
  }
  template <class T> T value(const std::string& path) const {
    const auto [instance, slot] = session->resolve(path);
    return std::get<T>(instance->read(slot));
  }
  glm::vec3 normal() const {
    const auto axis = glm::normalize(value<glm::vec3>("cut.axis"));
    return glm::angleAxis(glm::radians(value<float>("cut.angle")), axis) * glm::vec3(0, 0, 1);
  }
  bool send(Type type, glm::vec2 position, bool shift = false, bool control = false) const {
    const bool claimed = handle->input({.type = type, .button = Button::left, .position = position, .shift = shift, .control = control}, *view);
    session->update();
    return claimed;
  }
  void drag(glm::vec2 from, glm::vec2 to, bool control = false) const {
    ASSERT_TRUE(send(Type::press, from));
    send(Type::move, 0.5f * (from + to), false, control);
    send(Type::move, to, false, control);
    ASSERT_TRUE(send(Type::release, to));
  }
  /// On the ring about y, clockwise from the top.
  static glm::vec2 on_ring(float degrees) { return middle + ring * glm::vec2(std::sin(glm::radians(degrees)), -std::cos(glm::radians(degrees))); }
  static void expect_near(glm::vec3 value, glm::vec3 wanted, float tolerance = 1e-4f) {
    EXPECT_NEAR(glm::distance(value, wanted), 0, tolerance) << value.x << ", " << value.y << ", " << value.z;
  }
};

TEST_F(PlaneHandle, TheArrowMovesThePlaneAlongItsNormalAlone) {
  drag({530, 275}, {570, 305});
  expect_near(value<glm::vec3>("cut.translation"), {0.9f, 0, 0.25f});
  EXPECT_EQ(value<float>("cut.angle"), 90);
  EXPECT_EQ(value<glm::vec3>("handle.translation"), value<glm::vec3>("cut.translation"));
}

TEST_F(PlaneHandle, TheMiddleMovesThePlaneWithThePointer) {
  drag(middle, middle + glm::vec2(20, -30));
  expect_near(value<glm::vec3>("cut.translation"), {0.7f, 0, 0.55f});
}

TEST_F(PlaneHandle, ARingTurnsThePlaneByTheAngleOfThePointer) {
  drag(on_ring(0), on_ring(30));
  expect_near(normal(), {std::cos(glm::radians(30.0f)), 0, -std::sin(glm::radians(30.0f))});
  expect_near(value<glm::vec3>("cut.axis"), {0, 1, 0});
  EXPECT_NEAR(value<float>("cut.angle"), 120, 1e-3f);
  expect_near(value<glm::vec3>("cut.translation"), {0.5f, 0, 0.25f});
}

TEST_F(PlaneHandle, ARingSeenFromTheSideTurnsWithItsNearestPoint) {
  drag({390, 275}, {410, 275});  // the ring about the plane's x axis, which is -z: a line on the screen
  const float angle = 20 / ring;
  expect_near(normal(), {std::cos(angle), std::sin(angle), 0});
}

TEST_F(PlaneHandle, TurningGoesOnBeyondHalfATurn) {
  ASSERT_TRUE(send(Type::press, on_ring(0)));
  glm::vec3 axis_before = value<glm::vec3>("cut.axis");
  for (float turned = 10; turned <= 360; turned += 10) {
    send(Type::move, on_ring(turned));
    const float angle = value<float>("cut.angle"), whole = 90 + turned;
    const glm::vec3 axis = value<glm::vec3>("cut.axis");
    expect_near(normal(), {std::sin(glm::radians(whole)), 0, std::cos(glm::radians(whole))}, 1e-3f);
    expect_near(axis, axis_before, 1e-3f);
    EXPECT_LE(std::abs(angle), 180);
    EXPECT_NEAR(std::remainder(angle - whole, 360.0f), 0, 1e-2f) << "about the same axis all the way";
    axis_before = axis;
  }
  send(Type::release, on_ring(360));
}

TEST_F(PlaneHandle, AnObliqueAxisChangesSmoothlyWhileItTurnsAboutAnother) {
  session->set("cut.axis", Value(glm::vec3(0.3f, 0.2f, -0.6f)));
  session->set("cut.angle", Value(170.0f));
  session->update();
  // Whatever ring is there: its points go round.
  glm::vec2 held(0);
  for (float degrees = 0; degrees < 360 && held == glm::vec2(0); degrees += 5)
    for (const float radius : {40.0f, 55.0f, 70.0f, 80.0f}) {
      const glm::vec2 at = middle + radius * glm::vec2(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)));
      send(Type::move, at);
      const auto hovered = value<Choice>("handle.hovered");
      if (hovered == "ring_x" || hovered == "ring_y") held = at;
    }
  ASSERT_NE(held, glm::vec2(0));
  ASSERT_TRUE(send(Type::press, held));
  glm::vec3 normal_before = normal(), axis_before = glm::normalize(value<glm::vec3>("cut.axis"));
  for (int step = 1; step <= 120; ++step) {
    const float angle = glm::radians(3.0f * float(step));
    const glm::vec2 arm = held - middle;
    send(Type::move, middle + glm::vec2(std::cos(angle) * arm.x - std::sin(angle) * arm.y, std::sin(angle) * arm.x + std::cos(angle) * arm.y));
    EXPECT_LT(glm::distance(normal(), normal_before), 0.4f) << step;
    EXPECT_GT(glm::dot(value<glm::vec3>("cut.axis"), axis_before), 0) << step;
    EXPECT_LE(std::abs(value<float>("cut.angle")), 180);
    normal_before = normal();
    axis_before = value<glm::vec3>("cut.axis");
  }
  send(Type::release, held);
}

TEST_F(PlaneHandle, CtrlSnapsAndShiftGoesSlowly) {
  drag(on_ring(0), on_ring(37), true);
  EXPECT_NEAR(value<float>("cut.angle"), 120, 1e-3f) << "30 degrees, the nearest multiple of 15";
  session->set("cut.angle", Value(90.0f));
  session->update();
  drag({530, 275}, {530 + 26, 275}, true);
  expect_near(value<glm::vec3>("cut.translation"), {0.8f, 0, 0.25f});
  ASSERT_TRUE(send(Type::press, {560, 275}));
  send(Type::move, {660, 275}, true);
  expect_near(value<glm::vec3>("cut.translation"), {0.9f, 0, 0.25f});
  send(Type::move, {670, 275});
  expect_near(value<glm::vec3>("cut.translation"), {1, 0, 0.25f});
  send(Type::release, {670, 275});
}

TEST_F(PlaneHandle, GoingBackUndoesTheDrag) {
  for (const glm::vec2 from : {glm::vec2(530, 275), glm::vec2(390, 275), middle, on_ring(0)}) {
    ASSERT_TRUE(send(Type::press, from));
    send(Type::move, from + glm::vec2(15, 40));
    send(Type::move, from);
    send(Type::release, from);
    expect_near(value<glm::vec3>("cut.translation"), {0.5f, 0, 0.25f});
    expect_near(normal(), {1, 0, 0});
    expect_near(value<glm::vec3>("cut.axis"), {0, 1, 0});
  }
}

TEST_F(PlaneHandle, ADoubleClickTurnsTheNearerSideToTheEye) {
  ASSERT_TRUE(send(Type::double_click, {530, 275}));
  expect_near(normal(), {0, -1, 0});
  session->set("cut.axis", Value(glm::vec3(-1, 0, 0)));
  session->set("cut.angle", Value(60.0f));  // its normal is (0, sin 60, cos 60): it faces away
  session->update();
  ASSERT_TRUE(send(Type::double_click, middle));
  expect_near(normal(), {0, 1, 0});
  EXPECT_FALSE(send(Type::double_click, {100, 100}));
}

TEST_F(PlaneHandle, ClaimsItsLinesAloneAtAnyZoom) {
  for (const float height : {6.0f, 60.0f, 0.6f}) {
    session->set("eye.height", Value(height));
    session->set("cut.translation", Value(glm::vec3(0)));
    session->update();
    const glm::vec2 center(400, 300);
    const glm::vec2 on[] = {{110, 0}, {110, 7}, {0, -84}, {-59, 59}, {0, 0}}, beside[] = {{130, 0}, {110, 10}, {0, -94}, {-45, 45}, {200, 200}};
    for (const glm::vec2 at : on) EXPECT_TRUE(send(Type::move, center + at)) << height << ": " << at.x << ", " << at.y;
    for (const glm::vec2 at : beside) EXPECT_FALSE(send(Type::press, center + at)) << height << ": " << at.x << ", " << at.y;
  }
}

TEST_F(PlaneHandle, HoveringMarksAPartAndSetsNothing) {
  const auto before = session->to_json();
  const std::tuple<glm::vec2, const char*, Cursor> places[] = {{{530, 275}, "arrow", Cursor::hand}, {on_ring(-45), "ring_y", Cursor::hand}, {{390, 275}, "ring_x", Cursor::hand},
                                                               {middle, "middle", Cursor::move}, {{100, 100}, "none", Cursor::arrow}};
  for (const auto& [at, part, cursor] : places) {
    view->cursor = Cursor::arrow;
    EXPECT_EQ(send(Type::move, at), std::string(part) != "none");
    EXPECT_EQ(value<Choice>("handle.hovered").name, part);
    EXPECT_EQ(view->cursor, cursor);
  }
  EXPECT_EQ(session->to_json(), before);
}

TEST_F(PlaneHandle, InPerspectiveTheMiddleFollowsThePointerAlongTheArrow) {
  session->set("eye.projection", Value(Choice{"perspective"}));
  session->set("cut.translation", Value(glm::vec3(1.5f, 0.5f, -0.8f)));
  session->set("cut.axis", Value(glm::vec3(0.2f, 1, 0.4f)));
  session->set("cut.angle", Value(60.0f));
  session->update();
  const auto seen = [&](glm::vec3 world) {
    const Camera& camera = view->camera();
    const glm::vec3 eye = camera.view * glm::vec4(world, 1);
    return glm::vec2(400, 300) + 300 / (-eye.z * std::tan(glm::radians(camera.field_of_view) / 2)) * glm::vec2(eye.x, -eye.y);
  };
  const glm::vec3 center = value<glm::vec3>("cut.translation");
  const glm::vec2 start = seen(center), along = glm::normalize(seen(center + 0.001f * normal()) - start);
  for (const float way : {35.0f, -50.0f}) {
    const glm::vec2 from = seen(value<glm::vec3>("cut.translation")), held = from + 60.0f * along;
    drag(held, held + way * along);
    EXPECT_NEAR(glm::distance(seen(value<glm::vec3>("cut.translation")), from + way * along), 0, 0.05f);
  }
  EXPECT_NEAR(glm::length(glm::cross(value<glm::vec3>("cut.translation") - center, normal())), 0, 1e-4f) << "it stays on the line along the normal";
}

TEST_F(PlaneHandle, WithoutAPlaneItHasItsOwnThatOthersLinkTo) {
  session->set("handle.plane", Value(Reference{}));
  session->update();
  session->link("cut.translation", "handle.translation");
  session->update();
  drag({530, 275}, {580, 275});
  expect_near(value<glm::vec3>("handle.translation"), {1, 0, 0.25f});
  expect_near(value<glm::vec3>("cut.translation"), {1, 0, 0.25f});
}

// --- its picture, over a gray wall: 200 x 100 pixels, 50 per world unit.

TEST(PlaneHandlePicture, IsDrawnWhereItIsHeld) {
  lumen::testing::Scene scene({200, 100});
  scene.set("camera.height", "2");
  scene.add("ambient.constant", "ambient");
  scene.surface("wall", lumen::testing::rectangle(8, 8), R"({"ambient": "ambient", "ambient_color": [0.25, 0.25, 0.25]})");
  const lumen::testing::Pixels before = scene.picture();
  scene.add("interactor.plane_handle", "handle", R"({"size": 0.4, "translation": [0.5, 0.2, -1], "axis": [0, 1, 0], "angle": 90})");
  const lumen::testing::Pixels after = scene.picture();
  // The middle at (125, 40), the arrow to (165, 40), a ring of radius 28.
  EXPECT_GT(after.rgb(145, 40).g, 0.45f) << "the shaft";
  EXPECT_GT(after.rgb(158, 40).g, 0.6f) << "the head";
  EXPECT_GT(std::max({after.rgb(125, 40 - 29).g, after.rgb(125, 40 - 28).g, after.rgb(125, 40 - 27).g}), 0.3f) << "the ring about the plane's x axis";
  EXPECT_NEAR(after.rgb(110, 25).g, 0.25f, 1e-4f) << "within the ring the wall";
  EXPECT_EQ(after.rgb(30, 50), before.rgb(30, 50));
  scene.set("handle.hovered", "arrow");
  const lumen::testing::Pixels hot = scene.picture();
  EXPECT_LT(hot.rgb(145, 40).b, 0.5f * hot.rgb(145, 40).r) << "what is hovered is amber";
  EXPECT_EQ(scene.runs("geometry"), 1) << "the handle lies over the picture";
  EXPECT_TRUE(scene.problems().empty());
}

}  // namespace
