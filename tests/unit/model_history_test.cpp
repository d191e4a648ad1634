// Undo and redo, reloads, and both together.
#include <gtest/gtest.h>

#include "model_fakes.h"

namespace lumenshop {
namespace {

using fakes::Bench;
using fakes::error_of;
using fakes::Scripted;

TEST(History, UndoesAndRedoesValuesLinksAndResets) {
  Bench bench;
  bench.session.set("a.width", 2.0f);
  bench.session.link("a.width", "b.height");
  bench.session.reset("a.width");
  const History& history = bench.session.history();
  EXPECT_EQ(history.steps()[0].title, "a.width default -> 2");
  EXPECT_EQ(history.steps()[1].title, "a.width 2 -> link to b.height");
  EXPECT_EQ(history.position(), 3u);
  bench.session.history().undo();
  EXPECT_EQ(bench.saved("a")["width"]["link"], "b.height");
  bench.session.history().undo();
  EXPECT_EQ(bench.saved("a")["width"], 2);
  bench.session.history().undo();
  EXPECT_FALSE(bench.saved("a").contains("width"));
  EXPECT_FALSE(history.can_undo());
  bench.session.history().jump(3);
  EXPECT_FALSE(bench.saved("a").contains("width"));
  bench.session.history().jump(1);
  EXPECT_EQ(bench.number("a.width"), 2);
  bench.session.set("a.width", 5.0f);
  EXPECT_FALSE(history.can_redo()) << "a new edit ends what could be done again";
}

TEST(History, ADragIsOneStepWithItsFirstBeforeAndLastAfter) {
  Bench bench;
  bench.session.begin_edit();
  bench.session.begin_edit();
  for (int i = 2; i < 50; ++i) bench.session.set("a.width", float(i));
  bench.session.end_edit();
  bench.session.set("a.height", 7.0f);
  bench.session.end_edit();
  ASSERT_EQ(bench.session.history().steps().size(), 1u);
  EXPECT_EQ(bench.session.history().steps()[0].title, "a.width default -> 49 and 1 more");
  bench.session.history().undo();
  EXPECT_EQ(bench.number("a.width"), 1);
  EXPECT_EQ(bench.number("a.height"), 2);
  bench.session.history().redo();
  EXPECT_EQ(bench.number("a.width"), 49);
}

TEST(History, EditsThatChangeNothingAreNoSteps) {
  Bench bench;
  bench.session.set("a.width", 2.0f);
  bench.session.set("a.width", 2.0f);
  bench.session.begin_edit();
  bench.session.set("a.width", 3.0f);
  bench.session.set("a.width", 2.0f);
  bench.session.end_edit();
  bench.session.reset("b.width");
  EXPECT_EQ(bench.session.history().steps().size(), 1u);
}

TEST(History, CancelTakesBackTheOpenEdit) {
  Bench bench;
  bench.session.set("a.width", 2.0f);
  bench.session.begin_edit();
  bench.session.set("a.width", 9.0f);
  bench.session.remove("b");
  bench.session.cancel_edit();
  bench.session.end_edit();
  EXPECT_EQ(bench.number("a.width"), 2);
  EXPECT_NE(bench.session.find("b"), nullptr);
  EXPECT_EQ(bench.session.history().steps().size(), 1u);
}

TEST(History, WritesOfObjectsAreStepsAndCameraMovesHaveTheirOwnStack) {
  Bench bench(R"({"a": {"type": "diffuse.box"}, "orbit": {"type": "interactor.orbit"}, "lamp": {"type": "interactor.light"}})");
  auto& orbit = *static_cast<fakes::Orbit*>(bench.session.find("orbit")->plugin());
  auto& lamp = *static_cast<fakes::Lamp*>(bench.session.find("lamp")->plugin());
  bench.session.set("a.width", 2.0f);
  bench.session.begin_edit();
  orbit.distance.set(10);
  orbit.pivot.set(glm::vec3(1));
  orbit.distance.set(11);
  bench.session.end_edit();
  lamp.direction.set(glm::vec3(1, 0, 0));
  EXPECT_EQ(bench.session.history().steps().size(), 2u);
  bench.session.history().undo();
  EXPECT_EQ(lamp.direction.get(), glm::vec3(0, 0, 1));
  bench.session.history().undo();
  EXPECT_EQ(bench.number("a.width"), 1);
  EXPECT_EQ(orbit.distance, 11.0f) << "undoing edits does not move the camera";
  EXPECT_TRUE(bench.session.history().can_undo_camera());
  bench.session.rename("orbit", "eye");
  bench.session.history().undo_camera();
  EXPECT_EQ(orbit.distance, 5.0f);
  EXPECT_EQ(orbit.pivot.get(), glm::vec3(0));
  bench.session.history().redo_camera();
  EXPECT_EQ(orbit.distance, 11.0f);
}

TEST(History, QuickWritesOfOneObjectAreOneStep) {
  Bench bench(R"({"orbit": {"type": "interactor.orbit"}})");
  auto& orbit = *static_cast<fakes::Orbit*>(bench.session.find("orbit")->plugin());
  for (int notch = 1; notch < 6; ++notch) {
    orbit.distance.set(5.0f + float(notch));
    orbit.pivot.set(glm::vec3(float(notch)));
  }
  bench.session.history().undo_camera();
  EXPECT_EQ(orbit.distance, 5.0f);
  EXPECT_EQ(orbit.pivot.get(), glm::vec3(0));
  EXPECT_FALSE(bench.session.history().can_undo_camera());
}

TEST(History, StructureComesBackAsItWas) {
  Bench bench;
  bench.json("b.terms", R"(["a", "c"])");
  bench.session.link("c.width", "b.width");
  bench.session.set("b.width", 5.0f);
  const Json before = bench.session.to_json();
  bench.session.remove("b");
  EXPECT_EQ(bench.number("c.width"), 5);
  bench.session.add("diffuse.box", "d");
  bench.session.rename("c", "e");
  bench.session.history().jump(3);
  EXPECT_EQ(bench.session.to_json(), before) << "order, values, links";
  EXPECT_EQ(bench.session.find("b")->number(), 2);
  bench.session.set("b.width", 6.0f);
  EXPECT_EQ(bench.number("c.width"), 6);
  bench.session.history().undo();
  bench.session.history().jump(0);
  EXPECT_EQ(bench.saved("b"), Json::parse(R"({"type": "diffuse.box"})"));
}

TEST(History, ViewsComeBackToo) {
  Bench bench;
  bench.session.add("view", "main");
  bench.session.set("main.antialiasing", 16);
  bench.session.remove("main");
  EXPECT_TRUE(bench.session.views().empty());
  bench.session.history().undo();
  EXPECT_EQ(bench.read<int>("main.antialiasing"), 16);
  bench.session.history().jump(0);
  bench.session.history().jump(2);
  EXPECT_EQ(bench.read<int>("main.antialiasing"), 16);
}

TEST(History, KeepsAThousandSteps) {
  Bench bench;
  for (int i = 0; i < 1100; ++i) bench.session.set("a.height", float(i));
  EXPECT_EQ(bench.session.history().steps().size(), 1000u);
  bench.session.history().jump(0);
  EXPECT_EQ(bench.number("a.height"), 99);
}

/// Generation by generation of one type.
struct Reload : testing::Test {
  Reload() {
    first();
    bench.open(R"({"x": {"type": "diffuse.x", "roughness": 0.5, "level": 2, "link_me": {"link": "y.width"}, "stale": 1}, "y": {"type": "diffuse.box", "width": 7}})");
  }
  void first() {
    bench.factory.script("diffuse.x", [](Scripted& self) {
      self.add<float>("roughness", 0.1f);
      self.add<float>("untouched", 1.0f);
      self.add<int>("level", 0);
      self.add<float>("link_me", 0.0f);
      self.add<bool>("gone", false);
    });
  }
  void second() {
    bench.factory.number = 2;
    bench.factory.script("diffuse.x", [](Scripted& self) {
      self.add<std::string>("roughness", "smooth");
      self.add<float>("untouched", 3.0f);
      self.add<float>("level", 0.0f);
      self.add<float>("link_me", 0.0f);
      self.add<int>("stale", 0);
    });
  }
  Bench bench{"{}"};
};

TEST_F(Reload, TakesValuesOverAndConvertsWhatChangedItsType) {
  bench.session.set("x.gone", true);
  const auto draws = bench.session.find("x")->draw_revision();
  second();
  Rebuild rebuild(bench.session, bench.factory, {"diffuse.x"});
  EXPECT_EQ(bench.number("x.roughness"), 0.5f) << "built aside: nothing has changed";
  rebuild.swap();
  EXPECT_EQ(bench.session.find("x")->generation(), 2);
  EXPECT_EQ(bench.number("x.untouched"), 3) << "follows the new default";
  EXPECT_EQ(bench.number("x.level"), 2) << "int became float";
  EXPECT_EQ(bench.number("x.link_me"), 7);
  EXPECT_EQ(bench.read<std::string>("x.roughness"), "smooth");
  EXPECT_EQ(bench.read<int>("x.stale"), 1) << "an orphan came back";
  rebuild.keep();
  EXPECT_GT(bench.session.find("x")->draw_revision(), draws);
  EXPECT_TRUE(bench.has_problem("x.level: was int, is float now"));
  EXPECT_TRUE(bench.has_problem("x.roughness: was float, is string now"));
  EXPECT_EQ(nlohmann::json(bench.saved("x")),
            nlohmann::json::parse(R"({"type": "diffuse.x", "roughness": 0.5, "level": 2, "link_me": {"link": "y.width"}, "stale": 1, "gone": true})"));
  bench.session.set("y.width", 8.0f);
  EXPECT_EQ(bench.number("x.link_me"), 8);

  first();
  Rebuild back(bench.session, bench.factory, {"diffuse.x"});
  back.keep();
  EXPECT_EQ(bench.number("x.roughness"), 0.5f) << "what did not fit comes back";
  EXPECT_EQ(bench.read<int>("x.level"), 2) << "2.0 is a whole number";
  EXPECT_TRUE(bench.read<bool>("x.gone"));
}

TEST_F(Reload, RevertsExactly) {
  const Json before = bench.session.to_json();
  const auto old = bench.session.find("x")->share();
  const auto draws = bench.session.find("x")->draw_revision();
  second();
  {
    Rebuild rebuild(bench.session, bench.factory, {"diffuse.x"});
    rebuild.swap();
    bench.session.set("x.level", 77.0f);
    bench.session.update();
  }
  EXPECT_EQ(bench.session.find("x")->plugin(), old.get());
  EXPECT_EQ(bench.session.find("x")->generation(), 1);
  EXPECT_EQ(bench.session.to_json(), before);
  EXPECT_EQ(bench.read<int>("x.level"), 2);
  EXPECT_GT(bench.session.find("x")->draw_revision(), draws) << "what was drawn meanwhile is not it";
  bench.session.set("x.level", 5);
  EXPECT_EQ(bench.saved("x")["level"], 5);
}

TEST_F(Reload, AConstructorThatThrowsChangesNothing) {
  const Json before = bench.session.to_json();
  bench.factory.script("diffuse.x", [](Scripted& self) {
    self.add<float>("roughness", 1);
    throw lumen::Error("no");
  });
  EXPECT_NE(error_of([&] { Rebuild rebuild(bench.session, bench.factory, {"diffuse.box", "diffuse.x"}); }), "");
  EXPECT_EQ(bench.session.to_json(), before);
  EXPECT_EQ(bench.number("x.roughness"), 0.5f);
  EXPECT_EQ(bench.session.find("y")->plugin()->kind(), lumen::Kind::diffuse);
}

TEST_F(Reload, UndoWorksAcrossIt) {
  bench.session.set("x.link_me", 4.0f);  // through the link: y.width
  bench.session.set("x.roughness", 0.9f);
  bench.session.set("x.untouched", 6.0f);
  second();
  Rebuild(bench.session, bench.factory, {"diffuse.x"}).keep();
  bench.session.history().undo();
  EXPECT_EQ(bench.number("x.untouched"), 3) << "not set: the new default";
  bench.session.history().undo();
  EXPECT_EQ(bench.saved("x")["roughness"], 0.5);
  bench.session.history().undo();
  EXPECT_EQ(bench.number("y.width"), 7);
  bench.session.history().jump(3);
  EXPECT_EQ(bench.number("x.untouched"), 6);
}

TEST_F(Reload, LinksOfOthersFollowTheNewObject) {
  bench.session.link("y.height", "x.level");
  EXPECT_EQ(bench.number("y.height"), 2);
  const auto revision = bench.box("y").height.revision();
  second();
  Rebuild rebuild(bench.session, bench.factory, {"diffuse.x"});
  rebuild.swap();
  EXPECT_EQ(bench.number("y.height"), 2);
  EXPECT_EQ(bench.box("y").height.revision(), revision) << "the same value is no change";
  rebuild.keep();
  bench.session.set("x.level", 9.0f);
  EXPECT_EQ(bench.number("y.height"), 9);
}

TEST_F(Reload, TypesThatComeAndGoKeepEverything) {
  bench.factory.makers.erase("diffuse.x");
  const Json before = bench.session.to_json();
  Rebuild(bench.session, bench.factory, {"diffuse.x"}).keep();
  EXPECT_EQ(bench.session.find("x")->plugin(), nullptr);
  EXPECT_EQ(nlohmann::json(bench.session.to_json()), nlohmann::json(before));
  EXPECT_TRUE(bench.has_problem("there is no plugin diffuse.x"));
  first();
  Rebuild(bench.session, bench.factory, {"diffuse.x"}).keep();
  EXPECT_EQ(bench.number("x.roughness"), 0.5f);
  EXPECT_EQ(bench.number("x.link_me"), 7);
  EXPECT_FALSE(bench.has_problem("there is no plugin"));
}

TEST(Rebuild, OutputsKeepTheirLastGoodData) {
  Bench bench(R"({"scan": {"type": "importer.vtk", "path": "x.vtp"}, "sink": {"type": "diffuse.sink", "mesh": {"link": "scan.mesh"}}})");
  Instance& scan = *bench.session.find("scan");
  const auto mesh = std::make_shared<const lumen::Mesh>();
  scan.adopt(scan.slot_of("mesh"), mesh, "ready");
  const auto revision = scan.revision(scan.slot_of("mesh"));
  Rebuild(bench.session, bench.factory, {"importer.vtk"}).keep();
  EXPECT_EQ(bench.read<lumen::DataPointer>("sink.mesh"), mesh);
  EXPECT_EQ(bench.state("sink.mesh").data_state, "ready");
  EXPECT_EQ(scan.revision(scan.slot_of("mesh")), revision);
  EXPECT_EQ(bench.read<lumen::Path>("scan.path").file, "/sessions/x.vtp");
  EXPECT_EQ(bench.saved("scan")["path"], "x.vtp");
}

TEST(Rebuild, OldObjectsGoWhenItIsKeptAndNewOnesWhenItIsNot) {
  Bench bench(R"({"a": {"type": "diffuse.box"}})");
  {
    Rebuild rebuild(bench.session, bench.factory, {"diffuse.box"});
    rebuild.swap();
    EXPECT_EQ(bench.log.count("a destroyed"), 0);
    rebuild.keep();
    EXPECT_EQ(bench.log.count("a destroyed"), 1);
  }
  const auto* kept = bench.session.find("a")->plugin();
  { Rebuild rebuild(bench.session, bench.factory, {"diffuse.box"}); }
  EXPECT_EQ(bench.log.count("a destroyed"), 2);
  EXPECT_EQ(bench.session.find("a")->plugin(), kept);
}

TEST(Rebuild, SurvivesTheRemovalOfAnInstanceMeanwhile) {
  Bench bench;
  Rebuild rebuild(bench.session, bench.factory, {"diffuse.box"});
  bench.session.remove("b");
  rebuild.swap();
  bench.session.remove("c");
  rebuild.revert();
  EXPECT_EQ(bench.session.plugins().size(), 1u);
  bench.session.set("a.width", 4.0f);
  EXPECT_EQ(bench.number("a.width"), 4);
}

}  // namespace
}  // namespace lumenshop
