// Picking: which part and which values a click finds, and what it selects.
#include <memory>

#include <gtest/gtest.h>

#include <lumen/components.h>
#include <lumen/interactor.h>
#include <lumen/mesh.h>
#include <lumen/splitter.h>

#include "installation.h"
#include "model/session.h"
#include "modules/registry.h"
#include "plugins/data_session.h"
#include "plugins/solids_of_revolution.h"

namespace {

using namespace lumen;

struct FakeView : ViewInput {
  std::optional<Picked> under;
  std::vector<std::string> asked;
  Camera current;
  glm::ivec2 size() const override { return {800, 600}; }
  const Camera& camera() const override { return current; }
  Bounds scene() const override { return {}; }
  Bounds selection() const override { return {}; }
  std::optional<glm::vec3> surface_at(glm::vec2) override { return std::nullopt; }
  std::string instance_at(glm::vec2) override { return {}; }
  std::optional<Picked> pick(glm::vec2, const std::vector<std::string>& renderers) override {
    asked = renderers;
    return under;
  }
  bool blender_keys() const override { return false; }
  double time() const override { return 0; }
  void animate() override {}
};

/// Adds a tetrahedron of this size at a corner: triangles that face outward, or inward.
void add_tetrahedron(std::vector<glm::vec3>& positions, std::vector<glm::uvec3>& triangles, glm::vec3 corner, float size, bool inward = false) {
  const auto first = std::uint32_t(positions.size());
  for (const glm::vec3 at : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) positions.push_back(corner + size * at);
  for (glm::uvec3 t : {glm::uvec3(0, 2, 1), glm::uvec3(0, 1, 3), glm::uvec3(0, 3, 2), glm::uvec3(1, 2, 3)}) {
    if (inward) std::swap(t.y, t.z);
    triangles.push_back(t + first);
  }
}

/// Component 0: a large tetrahedron; 1: a small one within it, turned inside out; 2: one beside them.
std::shared_ptr<Mesh> three_parts() {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  add_tetrahedron(positions, triangles, {0, 0, 0}, 4);
  add_tetrahedron(positions, triangles, {0.5f, 0.5f, 0.5f}, 1, true);
  add_tetrahedron(positions, triangles, {9, 0, 0}, 2);
  std::vector<float> slope, pair, label;
  for (const glm::vec3 p : positions) {
    slope.push_back(p.x + 2 * p.y + 3 * p.z);
    pair.push_back(p.x);
    pair.push_back(-p.y);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) label.push_back(float(100 + i));
  auto mesh = std::make_shared<Mesh>();
  mesh->origin = "test";
  mesh->positions = positions;
  mesh->triangles = triangles;
  mesh->attributes = {{"slope", Attribute::On::points, 1, slope},
                      {"pair", Attribute::On::points, 2, pair}, {"label", Attribute::On::cells, 1, label}};
  mesh->finish();
  return mesh;
}

struct Pick : testing::Test {
  lumenshop::Registry registry{{lumenshop::Installation::find().plugins()}, nullptr};
  std::unique_ptr<lumenshop::Session> session;
  Interactor* pick = nullptr;
  FakeView view;
  std::shared_ptr<Mesh> mesh = three_parts();

  void SetUp() override {
    registry.load_all();
    session = std::make_unique<lumenshop::Session>(registry);
    pick = session->add("interactor.pick", "pick").as<Interactor>(Kind::interactor);
    ASSERT_NE(pick, nullptr);
  }
  template <class T> T value(const std::string& property) const {
    const auto [instance, slot] = session->resolve("pick." + property);
    return std::get<T>(instance->read(slot));
  }
  bool click(bool shift = false, bool control = false) {
    const bool claimed = pick->input({.type = InputEvent::Type::click, .button = InputEvent::Button::left, .shift = shift, .control = control}, view);
    session->update();
    return claimed;
  }
  /// The surface at a place of a cell (object space).
  void look_at(int cell, glm::vec3 place, glm::mat4 object_to_world = glm::mat4(1), glm::mat4 moved = glm::mat4(1)) {
    view.under = Picked{.renderer = "vessel", .part = 1, .moved = moved, .cell = cell,
                        .position = moved * object_to_world * glm::vec4(place, 1), .mesh = mesh, .object_to_world = object_to_world};
  }
};

TEST_F(Pick, TellsThePartAndTheValuesUnderThePointer) {
  look_at(8, {9.5f, 0.25f, 0});  // the third tetrahedron's face z = 0
  EXPECT_TRUE(click());
  EXPECT_EQ(value<std::string>("renderer"), "vessel");
  EXPECT_EQ(value<int>("part"), 1);
  EXPECT_EQ(value<int>("component"), 2);
  EXPECT_EQ(value<int>("cell"), 8);
  EXPECT_EQ(value<glm::vec3>("position"), glm::vec3(9.5f, 0.25f, 0));
  EXPECT_EQ(value<std::vector<int>>("selection"), std::vector<int>{2});
  const std::vector<std::string> values = {"slope = 10", "pair = (9.5, -0.25)", "label = 108"};
  EXPECT_EQ(value<std::vector<std::string>>("values"), values) << "arrays of points are linear over the triangle";
}

TEST_F(Pick, FindsThePlaceBeforeTheSplitAndTheTransform) {
  glm::mat4 scaled(2), moved(1);
  scaled[3] = {5, 6, 7, 1};
  moved[3] = {0, 0, -30, 1};
  look_at(8, {9.5f, 0.25f, 0}, scaled, moved);
  click();
  EXPECT_EQ(value<std::vector<std::string>>("values")[0], "slope = 10");
}

TEST_F(Pick, FindsTheTriangleOfAPolygon) {
  auto square = std::make_shared<Mesh>();
  square->origin = "square";
  square->positions = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square->triangles = std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}};
  square->triangle_cells = std::vector<std::uint32_t>{0, 0};
  square->attributes = {{"corner", Attribute::On::points, 1, std::vector<float>{0, 0, 0, 8}}};
  square->finish();
  mesh = square;
  look_at(0, {0.25f, 0.75f, 0});
  click();
  EXPECT_EQ(value<std::vector<std::string>>("values")[0], "corner = 4") << "in the second triangle the weight of its corner is y - x";
}

TEST_F(Pick, OfACapFindsTheInnermostPartThatItCloses) {
  for (const auto& [place, component] : {std::pair(glm::vec3(0.7f), 1), std::pair(glm::vec3(0.3f), 0), std::pair(glm::vec3(9.3f, 0.3f, 0.3f), 2), std::pair(glm::vec3(-1), -1)}) {
    look_at(-1, place);
    click();
    EXPECT_EQ(value<int>("component"), component);
    EXPECT_TRUE(value<std::vector<std::string>>("values").empty());
    EXPECT_EQ(value<std::vector<int>>("selection"), component < 0 ? std::vector<int>() : std::vector<int>{component});
  }
}

TEST_F(Pick, OfAWeldedSurfaceKeepsThePartsThatFilterPartsHasFound) {
  lumenshop::DataSession made;
  made.given("dumbbell", solids::dumbbell());
  made.add("filter.parts", "parts");
  made.session.link("parts.mesh", "dumbbell.mesh");
  made.run();
  const auto found = made.data<Mesh>("parts.result");
  ASSERT_TRUE(found) << made.messages("parts");
  mesh = std::make_shared<Mesh>(*found);
  ASSERT_EQ(connected_parts(*mesh).count, 1u);
  const auto cell_at = [&](float low, float high) {  // a triangle between two heights
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i)
      if (const float z = mesh->positions[mesh->triangles[i].x].z; z > low && z < high) return int(i);
    return -1;
  };
  const int small_ball = cell_at(4.2f, 4.4f), tube = cell_at(2.0f, 2.2f);
  look_at(small_ball, mesh->positions[mesh->triangles[std::size_t(small_ball)].x]);
  click();
  EXPECT_EQ(value<std::vector<int>>("selection"), std::vector<int>{1});
  look_at(tube, mesh->positions[mesh->triangles[std::size_t(tube)].x]);
  click(true);
  EXPECT_EQ(value<std::vector<int>>("selection"), (std::vector<int>{1, 2}));

  auto* cut = session->add("splitter.plane", "cut").as<Splitter>(Kind::splitter);
  session->link("cut.whole", "pick.selection");
  session->set("cut.axis", Value(glm::vec3(0, 1, 0)));
  session->set("cut.angle", Value(90.0f));
  session->update();
  const Split split = cut->split({.mesh = mesh, .object_to_world = glm::mat4(1), .bounds = mesh->bounds(), .camera = view.current});
  ASSERT_EQ(split.parts.size(), 3u);
  for (std::size_t i = 0; i < mesh->triangles.size(); ++i) EXPECT_EQ((*split.groups)[i] == 1, mesh->attribute(lumen::part_array)->values[i] > 0);
  for (const Part& part : split.parts) EXPECT_FALSE(part.openings) << "ball and tube are open where they leave each other";
}

TEST_F(Pick, ModifiedClicksAddAndRemoveAndTheBackgroundEmpties) {
  const auto selection = [&] { return value<std::vector<int>>("selection"); };
  look_at(0, {1, 1, 0});
  click();
  look_at(8, {9.5f, 0.25f, 0});
  click(true);
  EXPECT_EQ(selection(), (std::vector<int>{0, 2}));
  look_at(0, {1, 1, 0});
  click(false, true);
  EXPECT_EQ(selection(), std::vector<int>{2});
  view.under.reset();
  EXPECT_FALSE(click(true));
  EXPECT_EQ(selection(), std::vector<int>{2}) << "a modified click beside everything is a miss";
  EXPECT_FALSE(click());
  EXPECT_TRUE(selection().empty());
  EXPECT_TRUE(value<std::string>("renderer").empty());
  look_at(5, {1, 1, 0});
  click();
  EXPECT_EQ(selection(), std::vector<int>{1});
}

TEST_F(Pick, LeavesPressesToOthersAndAsksForItsSurfaces) {
  look_at(0, {1, 1, 0});
  for (const InputEvent::Type type : {InputEvent::Type::press, InputEvent::Type::move, InputEvent::Type::release, InputEvent::Type::double_click})
    EXPECT_FALSE(pick->input({.type = type, .button = InputEvent::Button::left}, view));
  EXPECT_FALSE(pick->input({.type = InputEvent::Type::click, .button = InputEvent::Button::left, .held = "L"}, view)) << "the light's";
  EXPECT_TRUE(value<std::string>("renderer").empty());
  click();
  EXPECT_TRUE(view.asked.empty());
  session->set("pick.surfaces", Value(References{{"vessel"}}));
  click();
  EXPECT_EQ(view.asked, std::vector<std::string>{"vessel"});
}

TEST_F(Pick, ABackgroundClickWithNothingPickedChangesNothing) {
  const auto before = session->to_json();
  click();
  EXPECT_EQ(session->to_json(), before);
}

TEST_F(Pick, ItsLabelSaysWhatWasPicked) {
  EXPECT_TRUE(pick->labels().empty());
  look_at(8, {9.5f, 0.25f, 0});
  click();
  ASSERT_EQ(pick->labels().size(), 1u);
  EXPECT_EQ(pick->labels()[0].position, glm::vec3(9.5f, 0.25f, 0));
  EXPECT_EQ(pick->labels()[0].text, "vessel, component 2, cell 8\nslope = 10\npair = (9.5, -0.25)\nlabel = 108");
  session->set("pick.show_values", Value(false));
  EXPECT_TRUE(pick->labels().empty());
}

}  // namespace
