// The camera and the light, through their libraries and a session.
#include <cmath>
#include <memory>
#include <optional>
#include <tuple>

#include <gtest/gtest.h>

#include <lumen/interactor.h>

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
  Bounds bounds{glm::vec3(-1), glm::vec3(1)};
  std::optional<glm::vec3> surface;
  double now = 0;
  bool animated = false, blender = false, still = true;

  explicit FakeView(Interactor& camera) : camera_of(camera) {}
  glm::ivec2 size() const override { return {800, 600}; }
  const Camera& camera() const override { return current = camera_of.camera(); }
  Bounds scene() const override { return bounds; }
  Bounds selection() const override { return bounds; }
  std::optional<glm::vec3> surface_at(glm::vec2) override { return surface; }
  std::string instance_at(glm::vec2) override { return {}; }
  bool blender_keys() const override { return blender; }
  double time() const override { return now; }
  bool reduced_motion() const override { return still; }
  void animate() override { animated = true; }
};

struct Interactors : testing::Test {
  lumenshop::Registry registry{{lumenshop::Installation::find().plugins()}, nullptr};
  std::unique_ptr<lumenshop::Session> session;
  Interactor *orbit = nullptr, *light = nullptr;

  void SetUp() override {
    registry.load_all();
    if (!registry.has("interactor.orbit") || !registry.has("interactor.light")) GTEST_SKIP() << "the interactors' libraries are not built";
    session = std::make_unique<lumenshop::Session>(registry);
    orbit = session->add("interactor.orbit", "orbit").as<Interactor>(Kind::interactor);
    light = session->add("interactor.light", "light").as<Interactor>(Kind::interactor);
    orbit->scene_changed({glm::vec3(-1), glm::vec3(1)}, 800.0f / 600);
  }
  template <class T> T value(const std::string& path) const {
    const auto [instance, slot] = session->resolve(path);
    return std::get<T>(instance->read(slot));
  }
  bool is_set(const std::string& path) const {
    const auto [instance, slot] = session->resolve(path);
    return instance->is_set(slot);
  }
  /// Where a world point is on the screen, pixels, and how far it is.
  static glm::vec3 seen(const Camera& camera, glm::vec3 world) {
    const glm::vec3 eye = camera.view * glm::vec4(world, 1);
    const float half = camera.orthographic ? camera.height / 2 : -eye.z * std::tan(glm::radians(camera.field_of_view) / 2);
    return {400 + eye.x / half * 300, 300 - eye.y / half * 300, -eye.z};
  }
  static void drag(Interactor& interactor, FakeView& view, InputEvent event, glm::vec2 from, glm::vec2 to) {
    event.type = Type::press;
    event.position = from;
    ASSERT_TRUE(interactor.input(event, view));
    event.type = Type::move;
    event.position = to;
    interactor.input(event, view);
    event.type = Type::release;
    interactor.input(event, view);
  }
};

TEST_F(Interactors, TheSceneIsFramedWithoutSettingAnything) {
  const Camera camera = orbit->camera();
  EXPECT_EQ(camera.pivot, glm::vec3(0));
  EXPECT_NEAR(camera.distance, 1 + 1.05f / std::tan(glm::radians(15.0f)), 1e-3f) << "the box's near face fills the view but for the margin";
  EXPECT_FALSE(is_set("orbit.distance"));
  EXPECT_FALSE(is_set("orbit.pivot"));
  orbit->scene_changed({glm::vec3(9), glm::vec3(11)}, 0.5f);
  EXPECT_EQ(orbit->camera().pivot, glm::vec3(10)) << "what nobody set follows the scene";
  EXPECT_GT(orbit->camera().distance, camera.distance * 1.7f) << "a narrow view needs more distance";
}

TEST_F(Interactors, TheDefaultViewLooksAlongYWithZUp) {
  const Camera camera = orbit->camera();
  EXPECT_LT(seen(camera, {0, -1, 0}).z, seen(camera, {0, 1, 0}).z) << "what has the smaller y is nearer";
  EXPECT_LT(seen(camera, {0, 0, 1}).y, 300) << "z is up";
  EXPECT_GT(seen(camera, {1, 0, 0}).x, 400) << "x is right";
}

TEST_F(Interactors, DraggingTurnsWhatIsNearTheEyeAlongWithThePointer) {
  FakeView view(*orbit);
  const glm::vec3 near_point(0, -1, 0);
  drag(*orbit, view, {.button = Button::left}, {400, 300}, {460, 300});
  EXPECT_GT(seen(orbit->camera(), near_point).x, 405);
  EXPECT_NEAR(seen(orbit->camera(), near_point).y, 300, 0.5);
  EXPECT_NEAR(glm::length(value<glm::quat>("orbit.rotation")), 1, 1e-5f);
}

TEST_F(Interactors, DraggingBackUndoesTheTurn) {
  FakeView view(*orbit);
  const glm::quat before = value<glm::quat>("orbit.rotation");
  InputEvent event{.type = Type::press, .button = Button::left, .position = {300, 200}};
  orbit->input(event, view);
  event.type = Type::move;
  for (const glm::vec2 position : {glm::vec2(500, 250), glm::vec2(620, 500), glm::vec2(300, 200)}) {
    event.position = position;
    orbit->input(event, view);
  }
  EXPECT_NEAR(std::abs(glm::dot(before, value<glm::quat>("orbit.rotation"))), 1, 1e-6f);
}

TEST_F(Interactors, PanningKeepsThePivotUnderThePointer) {
  FakeView view(*orbit);
  const glm::vec3 before = seen(orbit->camera(), {0, 0, 0});
  drag(*orbit, view, {.button = Button::middle}, {400, 300}, {500, 350});
  const glm::vec3 after = seen(orbit->camera(), {0, 0, 0});
  EXPECT_NEAR(after.x - before.x, 100, 0.1);
  EXPECT_NEAR(after.y - before.y, 50, 0.1);
}

TEST_F(Interactors, TheWheelZoomsTowardThePointer) {
  FakeView view(*orbit);
  const float distance = orbit->camera().distance;
  // A point of the pivot's plane, away from the center.
  const glm::vec3 point(0.5f, 0, 0.25f);
  const glm::vec3 before = seen(orbit->camera(), point);
  orbit->input({.type = Type::wheel, .position = glm::vec2(before), .wheel = 3}, view);
  const glm::vec3 after = seen(orbit->camera(), point);
  EXPECT_NEAR(after.x, before.x, 0.2);
  EXPECT_NEAR(after.y, before.y, 0.2);
  EXPECT_NEAR(orbit->camera().distance, distance * std::pow(0.9f, 3), 1e-3f);
}

TEST_F(Interactors, StandardViewsLookAlongTheAxes) {
  FakeView view(*orbit);
  const auto toward_eye = [&] { return glm::vec3(glm::inverse(orbit->camera().view)[2]); };
  const std::tuple<const char*, bool, glm::vec3> views[] = {{"1", false, {0, -1, 0}}, {"1", true, {0, 1, 0}}, {"3", false, {1, 0, 0}},
                                                            {"3", true, {-1, 0, 0}}, {"7", false, {0, 0, 1}}, {"7", true, {0, 0, -1}}};
  for (const auto& [key, control, direction] : views) {
    ASSERT_TRUE(orbit->input({.type = Type::key, .control = control, .key = key}, view));
    EXPECT_NEAR(glm::distance(toward_eye(), direction), 0, 1e-4f) << key << (control ? " with Ctrl" : "");
  }
}

TEST_F(Interactors, JumpsEaseForAFifthOfASecond) {
  FakeView view(*orbit);
  view.still = false;
  view.now = 10;
  orbit->input({.type = Type::key, .key = "7"}, view);
  EXPECT_TRUE(view.animated);
  view.now = 10.1;
  view.animated = false;
  orbit->tick(view);
  EXPECT_TRUE(view.animated);
  const float half = glm::inverse(orbit->camera().view)[2].z;
  EXPECT_GT(half, 0.2f);
  EXPECT_LT(half, 0.95f);
  view.now = 10.21;
  view.animated = false;
  orbit->tick(view);
  EXPECT_FALSE(view.animated);
  EXPECT_NEAR(glm::inverse(orbit->camera().view)[2].z, 1, 1e-5f);
}

TEST_F(Interactors, TheProjectionChangesWithoutASizeJump) {
  FakeView view(*orbit);
  const glm::vec3 before = seen(orbit->camera(), {1, 0, 1});
  orbit->input({.type = Type::key, .key = "5"}, view);
  ASSERT_TRUE(orbit->camera().orthographic);
  EXPECT_NEAR(seen(orbit->camera(), {1, 0, 1}).x, before.x, 0.1);
  orbit->input({.type = Type::key, .key = "5"}, view);
  EXPECT_FALSE(orbit->camera().orthographic);
  EXPECT_NEAR(seen(orbit->camera(), {1, 0, 1}).x, before.x, 0.1);
}

TEST_F(Interactors, ADoubleClickSetsThePivotOrFits) {
  FakeView view(*orbit);
  view.surface = glm::vec3(0.3f, -0.5f, 0.1f);
  orbit->input({.type = Type::double_click, .button = Button::left, .position = {450, 200}}, view);
  EXPECT_EQ(orbit->camera().pivot, glm::vec3(0.3f, -0.5f, 0.1f));
  view.surface.reset();
  orbit->input({.type = Type::double_click, .button = Button::left, .position = {10, 10}}, view);
  EXPECT_EQ(orbit->camera().pivot, glm::vec3(0));
}

TEST_F(Interactors, TheBlenderPresetOrbitsWithTheMiddleButton) {
  FakeView view(*orbit);
  view.blender = true;
  EXPECT_FALSE(orbit->input({.type = Type::press, .button = Button::left}, view));
  const glm::quat before = value<glm::quat>("orbit.rotation");
  drag(*orbit, view, {.button = Button::middle}, {400, 300}, {460, 330});
  EXPECT_LT(std::abs(glm::dot(before, value<glm::quat>("orbit.rotation"))), 0.9999f);
}

TEST_F(Interactors, TheLightTurnsWithLHeldAlone) {
  FakeView view(*orbit);
  EXPECT_FALSE(light->input({.type = Type::press, .button = Button::left}, view));
  session->set("light.direction", Value(glm::vec3(0, -2, 0)));
  drag(*light, view, {.button = Button::left, .held = "L"}, {400, 300}, {500, 300});
  const glm::vec3 direction = value<glm::vec3>("light.direction");
  EXPECT_GT(direction.x, 0.2f) << "toward the eye before, it follows the pointer to the right";
  EXPECT_NEAR(direction.z, 0, 1e-4f);
  EXPECT_NEAR(glm::length(direction), 2, 1e-4f) << "its length is the person's";
  EXPECT_NEAR(glm::length(light->light(orbit->camera()).direction), 1, 1e-5f);
}

TEST_F(Interactors, TheLightShowsItsSphereWhileItTurnsAndSavesNothingOfIt) {
  FakeView view(*orbit);
  EXPECT_TRUE(light->writes().empty());
  InputEvent event{.type = Type::press, .button = Button::left, .position = {400, 300}, .held = "L"};
  ASSERT_TRUE(light->input(event, view));
  session->update();
  EXPECT_TRUE(value<bool>("light.sphere"));
  ASSERT_EQ(light->writes().size(), 1u);
  EXPECT_EQ(light->writes()[0]->layer(), "color");
  event.type = Type::release;
  light->input(event, view);
  session->update();
  EXPECT_FALSE(value<bool>("light.sphere"));
  EXPECT_FALSE(is_set("light.sphere"));
  EXPECT_TRUE(light->writes().empty() && light->reads().empty()) << "it takes no part in the picture";
}

TEST_F(Interactors, AKeyShowsTheLightsSphereForAMoment) {
  FakeView view(*orbit);
  view.now = 5;
  ASSERT_TRUE(light->input({.type = Type::key, .key = "6", .held = "L"}, view));
  EXPECT_TRUE(value<bool>("light.sphere"));
  view.now = 5.5;
  view.animated = false;
  light->tick(view);
  EXPECT_TRUE(view.animated);
  view.now = 6;
  view.animated = false;
  light->tick(view);
  EXPECT_FALSE(view.animated);
  EXPECT_FALSE(value<bool>("light.sphere"));
}

TEST_F(Interactors, AnAttachedLightFollowsTheEye) {
  session->set("light.attached", Value(true));
  session->set("light.direction", Value(glm::vec3(0, 0, 1)));
  FakeView view(*orbit);
  orbit->input({.type = Type::key, .key = "3"}, view);
  EXPECT_NEAR(glm::distance(light->light(orbit->camera()).direction, glm::vec3(1, 0, 0)), 0, 1e-4f);
}

TEST_F(Interactors, ALightGivesColorTimesIntensityAndItsFalloff) {
  session->set("light.kind", Value(Choice{"point"}));
  session->set("light.falloff", Value(Choice{"quadratic"}));
  session->set("light.color", Value(Color(1, 0.5f, 0.25f)));
  session->set("light.intensity", Value(2.0f));
  const Light given = light->light({});
  EXPECT_TRUE(given.point);
  EXPECT_EQ(given.falloff, Light::Falloff::quadratic);
  EXPECT_EQ(given.color, glm::vec3(2, 1, 0.5f));
}

}  // namespace
