// Sessions: what is set, reset, saved and loaded; structure; observers; conditions.
#include <gtest/gtest.h>

#include "model_fakes.h"

namespace lumenshop {
namespace {

using fakes::Bench;
using fakes::error_of;

TEST(Session, SavesWhatWasSetAndNothingElse) {
  Bench bench;
  EXPECT_EQ(bench.saved("a"), Json::parse(R"({"type": "diffuse.box"})"));
  bench.session.set("a.width", 1.0f);
  EXPECT_EQ(bench.saved("a").dump(), R"({"type":"diffuse.box","width":1})") << "set, even if equal to the default";
  EXPECT_TRUE(bench.box("a").width.is_set());
  bench.session.reset("a.width");
  EXPECT_EQ(bench.saved("a").dump(), R"({"type":"diffuse.box"})");
  EXPECT_FALSE(bench.box("a").width.is_set());
}

TEST(Session, UntouchedValuesFollowTheDefaultAndSetOnesDoNot) {
  Bench bench;
  bench.session.set("b.width", 3.0f);
  for (const char* id : {"a", "b"}) bench.box(id).width.set_default(9);
  EXPECT_EQ(bench.number("a.width"), 9);
  EXPECT_EQ(bench.number("b.width"), 3);
  bench.session.reset("b.width");
  EXPECT_EQ(bench.number("b.width"), 9);
  EXPECT_FALSE(bench.saved("a").contains("width"));
}

TEST(Session, ValuesAreClampedTypedAndFinite) {
  Bench bench;
  bench.session.set("a.count", 99);
  EXPECT_EQ(bench.read<int>("a.count"), 10);
  EXPECT_NE(error_of([&] { bench.session.set("a.count", 1.5f); }).find("a.count"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.session.set("a.width", std::numeric_limits<float>::infinity()); }).find("finite"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.box("a").width.set(std::nanf("")); }).find("finite"), std::string::npos);
  EXPECT_EQ(error_of([&] { bench.json("a.width", "\"wide\""); }), "a.width: expected a number, not \"wide\"");
  EXPECT_EQ(bench.number("a.width"), 1);
}

TEST(Session, KeepsWhatItDoesNotKnowByteForByteInMeaning) {
  const char* text = R"({"lumenshop": 1, "title": "T", "future": {"deep": [1, {"x": null}]},
    "plugins": {"a": {"type": "diffuse.box", "widht": 4, "width": "wide", "height": null, "count": 3},
      "ghost": {"type": "renderer.ghost", "big": 9007199254740993, "max": 18446744073709551615, "text": "\u00e4\ud83d\ude00", "link": {"link": "a.width"}, "nothing": null, "tiny": 1e-300},
      "9bad": {"type": "diffuse.box"}, "list": [1, 2], "typeless": {"x": 1}},
    "views": {"main": {"camera": "nobody", "wow": true}, "a": {"time": 1}}, "layout": [["main"], "odd"]})";
  Bench bench;
  bench.session.load(Json::parse(text), "/sessions");
  const Json saved = bench.session.to_json(), original = Json::parse(text);
  EXPECT_EQ(nlohmann::json(saved), nlohmann::json(original)) << saved.dump(1);
  EXPECT_EQ(bench.session.layout(), original["layout"]);
  for (const char* words : {"did you mean 'width'?", "expected a number, not \"wide\"", "a.height: expected a number, not null", "there is no plugin renderer.ghost",
                            "'9bad'", "list: a plugin is an object", "typeless", "\"future\"", "there is no instance 'nobody'", "main.wow", "a: the id is taken"})
    EXPECT_TRUE(bench.has_problem(words)) << words;
  bench.session.set("a.height", 2.5f);
  EXPECT_EQ(bench.saved("a")["height"], 2.5);
  bench.session.reset("a.width");
  EXPECT_FALSE(bench.saved("a").contains("width"));
}

TEST(Session, AValueThatDidNotFitIsReplacedByOneThatDoesAndTheProblemGoes) {
  Bench bench(R"({"a": {"type": "diffuse.box", "width": "wide"}})");
  EXPECT_EQ(bench.number("a.width"), 1);
  EXPECT_TRUE(bench.has_problem("wide"));
  bench.session.set("a.width", 6.0f);
  EXPECT_FALSE(bench.has_problem("wide"));
  bench.session.history().undo();
  EXPECT_EQ(bench.saved("a")["width"], "wide");
}

TEST(Session, OrphansCanBeForgottenAndThatCanBeUndone) {
  Bench bench(R"({"a": {"type": "diffuse.box", "old": [1, 2]}})");
  bench.session.reset("a.old");
  EXPECT_FALSE(bench.saved("a").contains("old"));
  bench.session.history().undo();
  EXPECT_EQ(bench.saved("a")["old"], Json::parse("[1, 2]"));
}

TEST(Session, PathsAreAbsoluteForPluginsAndRelativeInTheFile) {
  Bench bench(R"({"a": {"type": "diffuse.box", "file": "data/x.vtp"}, "b": {"type": "diffuse.box", "file": "../other/y.vtp"},
                  "c": {"type": "diffuse.box", "file": "/far/z.vtp"}})");
  EXPECT_EQ(bench.box("a").file->file, "/sessions/data/x.vtp");
  EXPECT_EQ(bench.box("b").file->file, "/other/y.vtp");
  EXPECT_EQ(bench.box("c").file->file, "/far/z.vtp");
  EXPECT_EQ(bench.saved("a")["file"], "data/x.vtp");
  EXPECT_EQ(bench.saved("b")["file"], "../other/y.vtp");
  EXPECT_EQ(bench.saved("c")["file"], "/far/z.vtp");
  bench.session.set("c.file", lumen::Path{"/sessions/in/w.vtp"});
  EXPECT_EQ(bench.saved("c")["file"], "in/w.vtp");
  bench.session.set("b.file", lumen::Path{""});
  EXPECT_EQ(bench.saved("b")["file"], "");
  bench.session.history().undo();
  EXPECT_EQ(bench.saved("b")["file"], "../other/y.vtp");
}

TEST(Session, OverridesAreRelativeToTheWorkingDirectoryAndTakeText) {
  Bench bench;
  bench.session.override_value("a.file", "here.vtp");
  EXPECT_EQ(bench.box("a").file->file, (std::filesystem::current_path() / "here.vtp").string());
  bench.session.override_value("a.width", "12");
  bench.session.override_value("a.text", "2024");
  bench.session.override_value("a.mode", "sorted");
  bench.session.override_value("a.offset", "[1, 2, 3]");
  bench.session.override_value("b.width", R"({"link": "a.width"})");
  EXPECT_EQ(bench.number("b.width"), 12);
  EXPECT_EQ(bench.read<std::string>("a.text"), "2024");
  EXPECT_EQ(bench.read<lumen::Choice>("a.mode"), "sorted");
  EXPECT_NE(error_of([&] { bench.session.override_value("a.widht", "1"); }).find("did you mean 'width'?"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.session.override_value("a.width", "wide"); }), "");
  EXPECT_NE(error_of([&] { bench.session.override_value("nobody.width", "1"); }), "");
  EXPECT_FALSE(bench.session.history().can_undo());
  EXPECT_TRUE(bench.saved("a").contains("width"));
}

TEST(Session, ReferencesThatDoNotFitStayAndAreProblems) {
  Bench bench(R"({"a": {"type": "diffuse.box", "opacity": "fade", "eye": "lamp", "terms": ["b", "gone"]}, "b": {"type": "diffuse.box"},
                  "fade": {"type": "opacity.fade"}, "lamp": {"type": "interactor.light"}, "orbit": {"type": "interactor.orbit"}})");
  EXPECT_EQ(bench.state("a.opacity").error, "");
  EXPECT_EQ(bench.state("a.eye").error, "'lamp' (interactor.light) is no camera");
  EXPECT_EQ(bench.state("a.terms").error, "there is no instance 'gone'");
  EXPECT_EQ(bench.saved("a")["eye"], "lamp");
  bench.json("a.eye", "\"orbit\"");
  EXPECT_EQ(bench.state("a.eye").error, "");
}

TEST(Session, ConditionsSayWhyAPropertyHasNoEffect) {
  Bench bench;
  EXPECT_EQ(bench.state("a.bias").no_effect, "no effect: mode is plain");
  EXPECT_EQ(bench.state("a.gain").no_effect, "no effect: opacity is none");
  EXPECT_EQ(bench.state("a.glow").no_effect, "no effect: flag is off");
  bench.json("a.mode", "\"sorted\"");
  bench.json("a.opacity", "\"b\"");
  bench.session.set("a.flag", true);
  for (const char* path : {"a.bias", "a.gain", "a.glow"}) EXPECT_EQ(bench.state(path).no_effect, "") << path;
}

TEST(Session, AddsWithFreeIdsAndRefusesBadOnes) {
  Bench bench("{}");
  EXPECT_EQ(bench.session.add("diffuse.box").id(), "box");
  EXPECT_EQ(bench.session.add("diffuse.box").id(), "box2");
  EXPECT_EQ(bench.session.find("box2")->number(), 2);
  EXPECT_EQ(bench.session.add("view", "main").kind(), lumen::Kind::view);
  EXPECT_EQ(bench.session.find("main")->number(), 0);
  EXPECT_NE(error_of([&] { bench.session.add("diffuse.box", "main"); }).find("taken"), std::string::npos);
  for (const char* id : {"1a", "a-b", "a.b", "_a", "\xc3\xa4"}) EXPECT_NE(error_of([&] { bench.session.add("diffuse.box", id); }), "") << id;
  EXPECT_NE(error_of([&] { bench.session.add("diffuse.none"); }), "");
  bench.factory.script("diffuse.bad", [](fakes::Scripted&) { throw lumen::Error("no room"); });
  EXPECT_NE(error_of([&] { bench.session.add("diffuse.bad"); }).find("no room"), std::string::npos);
  EXPECT_EQ(bench.session.find("bad"), nullptr);
}

TEST(Session, AConstructorThatThrowsCostsNoValues) {
  Bench bench("{}");
  bench.factory.script("diffuse.bad", [](fakes::Scripted& self) {
    self.add<float>("width", 1);
    throw 5;
  });
  bench.open(R"({"x": {"type": "diffuse.bad", "width": 4, "other": {"link": "y.z"}}})");
  EXPECT_EQ(bench.saved("x"), Json::parse(R"({"type": "diffuse.bad", "width": 4, "other": {"link": "y.z"}})"));
  EXPECT_TRUE(bench.has_problem("could not be made"));
}

TEST(Session, RefusesDeclarationsThatAreNotFit) {
  Bench bench("{}");
  const auto refused = [&](std::function<void(fakes::Scripted&)> declare) {
    bench.factory.script("diffuse.bad", std::move(declare));
    return error_of([&] { bench.session.add("diffuse.bad"); });
  };
  EXPECT_NE(refused([](auto& self) { self.template add<float>("type", 1); }), "");
  EXPECT_NE(refused([](auto& self) { self.template add<float>("Big", 1); }), "");
  EXPECT_NE(refused([](auto& self) { self.template add<float>("enabled", 1); }).find("twice"), std::string::npos);
  EXPECT_NE(refused([](auto& self) { self.template add<float>("x", std::nanf("")); }), "");
  EXPECT_NE(refused([](auto& self) { self.template add<float>("x", 1, {.min = 2, .max = 1}); }), "");
  EXPECT_NE(refused([](auto& self) { self.template add<float>("x", 1, {.logarithmic = true}); }), "");
  EXPECT_NE(refused([](auto& self) { self.template add<lumen::Choice>("x", {"c"}, {.choices = {"a", "b"}}); }), "");
}

TEST(Session, RenamingTakesLinksAndReferencesAlong) {
  Bench bench(R"({"a": {"type": "diffuse.box", "width": 5}, "b": {"type": "diffuse.box", "width": {"link": "a.width"}, "terms": ["a", "b"]},
                  "ghost": {"type": "renderer.ghost", "mesh": {"link": "a.width"}}})");
  bench.session.rename("a", "first");
  EXPECT_EQ(bench.saved("b")["width"]["link"], "first.width");
  EXPECT_EQ(bench.saved("b")["terms"], Json::parse(R"(["first", "b"])"));
  EXPECT_EQ(bench.saved("ghost")["mesh"]["link"], "first.width");
  EXPECT_EQ(bench.number("b.width"), 5);
  EXPECT_NE(error_of([&] { bench.session.rename("first", "b"); }), "");
  bench.session.history().undo();
  EXPECT_EQ(bench.session.find("first"), nullptr);
  EXPECT_EQ(bench.saved("b")["terms"], Json::parse(R"(["a", "b"])"));
  bench.session.set("a.width", 6.0f);
  EXPECT_EQ(bench.number("b.width"), 6);
}

TEST(Session, RuntimePropertiesKeepTheirValuesBetweenObjects) {
  Bench bench("{}");
  bench.factory.script("diffuse.parts", [](fakes::Scripted&) {});
  bench.open(R"({"p": {"type": "diffuse.parts", "part_1": 0.5, "part_2": {"link": "p.part_1"}}})");
  auto& parts = *static_cast<fakes::Scripted*>(bench.session.find("p")->plugin());
  auto one = std::make_unique<lumen::Property<float>>(&parts, "part_1", 0.0f);
  auto two = std::make_unique<lumen::Property<float>>(&parts, "part_2", 0.0f);
  EXPECT_EQ(two->get(), 0.5f);
  one->set(0.75f);
  EXPECT_EQ(two->get(), 0.75f);
  const auto revision = one->revision();
  one.reset();
  EXPECT_EQ(bench.saved("p")["part_1"], 0.75);
  EXPECT_NE(error_of([&] { bench.session.resolve("p.part_1"); }), "");
  one = std::make_unique<lumen::Property<float>>(&parts, "part_1", 0.0f);
  EXPECT_EQ(one->get(), 0.75f);
  EXPECT_EQ(two->get(), 0.75f);
  EXPECT_GT(one->revision(), revision);
  EXPECT_TRUE(bench.session.find("p")->orphans().empty());
}

TEST(Session, DrawAndShadingRevisionsTellThemApart) {
  Bench bench;
  Instance& a = *bench.session.find("a");
  bench.session.link("a.height", "b.height");
  auto draw = a.draw_revision(), shading = a.shading_revision();
  bench.session.set("a.text", std::string("no pixel"));
  EXPECT_EQ(a.draw_revision(), draw);
  EXPECT_EQ(a.shading_revision(), shading);
  bench.session.set("a.tint", lumen::Color(1, 0, 0));
  EXPECT_EQ(a.draw_revision(), draw);
  EXPECT_GT(a.shading_revision(), shading);
  shading = a.shading_revision();
  bench.session.set("b.height", 9.0f);
  EXPECT_GT(a.draw_revision(), draw) << "through the link";
  EXPECT_GT(a.shading_revision(), shading);
}

TEST(Update, TellsEachChangeOnceAndOnlyWhatChanged) {
  Bench bench;
  bench.session.update();
  EXPECT_TRUE(bench.log.lines.empty());
  bench.session.set("a.width", 2.0f);
  bench.session.set("a.width", 3.0f);
  bench.session.set("a.height", 2.0f);
  bench.session.update();
  EXPECT_EQ(bench.log.lines, std::vector<std::string>{"a changed width"}) << "height was set to what it was";
  bench.session.update();
  EXPECT_EQ(bench.log.lines.size(), 1u);
}

TEST(Update, TellsThroughLinks) {
  Bench bench(R"({"a": {"type": "diffuse.box", "width": {"link": "b.width"}}, "b": {"type": "diffuse.box", "width": 4}})");
  bench.session.update();
  EXPECT_EQ(bench.log.lines, std::vector<std::string>{"a changed width"}) << "no constructor sees through links of a file being loaded";
  bench.session.set("b.width", 5.0f);
  bench.session.update();
  EXPECT_EQ(bench.log.count("a changed width"), 2);
  EXPECT_EQ(bench.log.count("b changed width"), 1);
}

TEST(Update, ReleasesWhatIsSwitchedOff) {
  Bench bench;
  bench.session.set("a.enabled", false);
  bench.session.update();
  EXPECT_EQ(bench.log.lines, (std::vector<std::string>{"a changed enabled", "a released"}));
  EXPECT_FALSE(bench.session.find("a")->enabled());
  bench.session.set("a.enabled", true);
  bench.session.update();
  EXPECT_EQ(bench.log.count("a released"), 1);
}

TEST(Update, ObserversHearOfOthersWhileTheyLive) {
  Bench bench;
  auto observer = std::make_unique<lumen::Observer>(&bench.box("a"), "b.width");
  auto later = std::make_unique<lumen::Observer>(&bench.box("a"), "d.width");
  bench.session.set("b.width", 7.0f);
  bench.session.set("b.width", 8.0f);
  bench.session.update();
  EXPECT_EQ(bench.log.count("a changed b.width"), 1);
  bench.session.add("diffuse.box", "d");
  bench.session.update();
  EXPECT_EQ(bench.log.count("a changed d.width"), 1) << "it came to be";
  observer.reset();
  bench.session.set("b.width", 9.0f);
  bench.session.update();
  EXPECT_EQ(bench.log.count("a changed b.width"), 1);
  later.reset();
  bench.session.remove("a");
  bench.session.set("b.width", 10.0f);
  bench.session.update();
}

TEST(Update, FollowsWritesOfChangedToAFixedPoint) {
  Bench bench("{}");
  bench.factory.script("diffuse.clock", [](fakes::Scripted& self) {
    self.add<int>("start", 0);
    self.add<int>("steps", 0);
    self.on_change = [](fakes::Scripted& self, std::string_view) {
      auto& steps = *static_cast<lumen::Property<int>*>(self.owned[1].get());
      if (steps < 5) steps.set(steps + 1);
    };
  });
  Instance& clock = bench.session.add("diffuse.clock");
  bench.session.set("clock.start", 1);
  bench.session.update();
  EXPECT_EQ(bench.read<int>("clock.steps"), 5);
  EXPECT_EQ(bench.session.history().steps().size(), 2u) << "what changed() writes is no step of its own";
  EXPECT_TRUE(clock.problems().empty());
}

TEST(Update, EndsAfterSixteenRoundsAndNamesTheCulprits) {
  Bench bench("{}");
  bench.factory.script("diffuse.restless", [](fakes::Scripted& self) {
    self.add<int>("n", 0);
    self.on_change = [](fakes::Scripted& self, std::string_view) {
      auto& n = *static_cast<lumen::Property<int>*>(self.owned[0].get());
      n.set(n + 1);
    };
  });
  bench.session.add("diffuse.restless", "r");
  bench.session.set("r.n", 1);
  bench.session.update();
  EXPECT_EQ(bench.read<int>("r.n"), 17);
  EXPECT_TRUE(bench.has_problem("keep changing each other: r.n"));
  const auto revision = bench.session.revision();
  bench.session.update();
  EXPECT_EQ(bench.session.revision(), revision) << "an idle session rests";
}

TEST(Update, AThrowBecomesAProblemUntilItSucceeds) {
  Bench bench("{}");
  bench.factory.script("diffuse.picky", [](fakes::Scripted& self) {
    self.add<int>("n", 0);
    self.on_change = [](fakes::Scripted& self, std::string_view) {
      if (*static_cast<lumen::Property<int>*>(self.owned[0].get()) == 1) throw lumen::Error("not one");
    };
  });
  bench.session.add("diffuse.picky", "p");
  bench.session.set("p.n", 1);
  bench.session.update();
  EXPECT_TRUE(bench.has_problem("not one"));
  bench.session.set("p.n", 2);
  bench.session.update();
  EXPECT_FALSE(bench.has_problem("not one"));
}

TEST(Session, ReportsOfObjectsAreShownOnceUntilCleared) {
  Bench bench;
  bench.box("a").report(lumen::Severity::warning, "odd mesh");
  bench.box("a").report(lumen::Severity::warning, "odd mesh");
  EXPECT_EQ(bench.session.find("a")->problems().size(), 1u);
  EXPECT_EQ(bench.session.problems().front().instance, "a");
  bench.session.find("a")->clear_reports();
  EXPECT_TRUE(bench.session.problems().empty());
}

TEST(Session, ConstructorsProposeAndFilesDecide) {
  Bench bench(R"({"x": {"type": "diffuse.box", "width": 3}})");
  bench.factory.script("diffuse.eager", [](fakes::Scripted& self) {
    auto width = std::make_shared<lumen::Property<float>>(&self, "width", 1.0f);
    width->set(50);
    auto height = std::make_shared<lumen::Property<float>>(&self, "height", 1.0f);
    height->link("x.width");
    self.owned = {width, height};
  });
  bench.open(R"({"free": {"type": "diffuse.eager"}, "told": {"type": "diffuse.eager", "width": 2, "height": 4}, "x": {"type": "diffuse.box", "width": 3}})");
  EXPECT_EQ(bench.number("free.width"), 50);
  EXPECT_EQ(bench.number("free.height"), 3);
  EXPECT_EQ(bench.number("told.width"), 2);
  EXPECT_EQ(bench.number("told.height"), 4);
}

TEST(Session, AnObjectMayOutliveItsInstance) {
  Bench bench;
  const std::shared_ptr<lumen::Plugin> held = bench.session.find("a")->share();
  bench.session.link("b.width", "c.width");
  const std::shared_ptr<lumen::Plugin> linked = bench.session.find("b")->share();
  bench.session.remove("a");
  bench.session.remove("b");
  static_cast<fakes::Box*>(held.get())->width.set(9);
  held->report(lumen::Severity::error, "from beyond");
  EXPECT_EQ(held->id(), "a");
  EXPECT_EQ(static_cast<fakes::Box*>(linked.get())->width.get(), 1);
  EXPECT_FALSE(bench.has_problem("from beyond"));
}

}  // namespace
}  // namespace lumenshop
