// Links: reading, writing through, expressions, cycles, data.
#include <gtest/gtest.h>

#include "model_fakes.h"

namespace lumenshop {
namespace {

using fakes::Bench;
using fakes::error_of;

TEST(Link, ReadsFollowTheSourceConvertedAndClamped) {
  Bench bench;
  bench.session.link("a.width", "b.height");
  bench.session.set("b.height", 7.0f);
  EXPECT_EQ(bench.box("a").width.get(), 7);
  bench.session.set("b.height", 500.0f);
  EXPECT_EQ(bench.box("a").width.get(), 100) << "clamped to the range of a.width";
  bench.session.link("a.offset", "b.count");
  EXPECT_EQ(bench.box("a").offset.get(), glm::vec3(3));
  bench.session.link("a.tint", "b.offset");
  bench.session.set("b.offset", glm::vec3(0.25f, 2, -1));
  EXPECT_EQ(bench.box("a").tint->rgb, glm::vec3(0.25f, 1, 0));
}

TEST(Link, RefusesWhatDoesNotConvert) {
  Bench bench;
  EXPECT_NE(error_of([&] { bench.session.link("a.count", "b.width"); }).find("float does not convert to int"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.session.link("a.text", "b.width"); }), "");
  EXPECT_NE(error_of([&] { bench.session.link("a.text", "b.text", "x"); }).find("needs numbers"), std::string::npos);
  EXPECT_EQ(bench.saved("a"), Json::parse(R"({"type": "diffuse.box"})"));
}

TEST(Link, WritingThroughIdentityLinksSetsTheFarSource) {
  Bench bench;
  bench.session.link("a.width", "b.width");
  bench.session.link("b.width", "c.width");
  bench.session.set("a.width", 42.0f);
  EXPECT_EQ(bench.number("c.width"), 42);
  EXPECT_EQ(bench.saved("c")["width"], 42);
  EXPECT_EQ(bench.saved("a")["width"], Json::parse(R"({"link": "b.width"})"));
  bench.box("a").width.set(43);
  EXPECT_EQ(bench.number("c.width"), 43);
}

TEST(Link, WritingConvertsBackOrSaysWhyNot) {
  Bench bench;
  bench.session.link("a.width", "b.count");
  bench.session.set("a.width", 6.6f);
  EXPECT_EQ(bench.read<int>("b.count"), 7);
  bench.session.link("a.offset", "b.height");
  EXPECT_NE(error_of([&] { bench.session.set("a.offset", glm::vec3(1, 2, 3)); }).find("b.height"), std::string::npos);
  bench.session.set("a.offset", glm::vec3(4));
  EXPECT_EQ(bench.number("b.height"), 4);
}

TEST(Link, ExpressionsAreReadOnlyAndTheRefusalNamesBoth) {
  Bench bench;
  bench.session.link("a.width", "b.height", "2*x + 1");
  EXPECT_EQ(bench.number("a.width"), 5);
  const std::string error = error_of([&] { bench.session.set("a.width", 1.0f); });
  EXPECT_NE(error.find("a.width"), std::string::npos);
  EXPECT_NE(error.find("b.height"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.box("a").width.set(1); }), "");
  EXPECT_EQ(bench.number("b.height"), 2);
}

TEST(Link, ExpressionsWorkPerComponent) {
  Bench bench;
  bench.session.set("b.offset", glm::vec3(1, 2, 3));
  bench.session.link("a.offset", "b.offset", "x*x + 10*i");
  EXPECT_EQ(bench.read<glm::vec3>("a.offset"), glm::vec3(1, 14, 29));
  bench.session.link("a.pair", "b.height", "x + i");
  EXPECT_EQ(bench.read<glm::vec2>("a.pair"), glm::vec2(2, 3));
}

TEST(Link, ExpressionsThatFailKeepTheLastValueAndSayWhy) {
  Bench bench;
  bench.session.link("a.width", "b.height", "8/x");
  EXPECT_EQ(bench.number("a.width"), 4);
  bench.session.set("b.height", 0.0f);
  EXPECT_EQ(bench.number("a.width"), 4);
  EXPECT_NE(bench.state("a.width").error.find("finite"), std::string::npos);
  bench.session.set("b.height", 4.0f);
  EXPECT_EQ(bench.number("a.width"), 2);
  EXPECT_EQ(bench.state("a.width").error, "");
}

TEST(Link, BadExpressionsAreRefusedWithTheirPlace) {
  Bench bench;
  EXPECT_NE(error_of([&] { bench.session.link("a.width", "b.height", "2*y"); }).find("column 3"), std::string::npos)
      << error_of([&] { bench.session.link("a.width", "b.height", "2*y"); });
  EXPECT_NE(error_of([&] { bench.session.link("a.width", "b.height", "(("); }), "");
  EXPECT_NE(error_of([&] { bench.session.link("a.width", "b.height", "1,2"); }), "");
  EXPECT_NE(error_of([&] { bench.session.link("a.width", "b.height", "\"text\""); }), "");
  EXPECT_NE(error_of([&] { bench.session.link("a.width", "b.height", std::string(1025, 'x')); }).find("1024"), std::string::npos);
  EXPECT_EQ(error_of([&] { bench.session.link("a.width", "b.height", std::string(510, '(') + "x" + std::string(510, ')')); }), "");
}

TEST(Link, CyclesAreRefusedWithTheirPath) {
  Bench bench;
  bench.session.link("b.width", "a.width");
  EXPECT_NE(error_of([&] { bench.session.link("a.width", "b.width"); }).find("a.width -> b.width -> a.width"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.session.link("c.height", "c.height"); }).find("c.height -> c.height"), std::string::npos);
  bench.session.link("c.width", "b.width");
  EXPECT_NE(error_of([&] { bench.session.link("a.width", "c.width"); }).find("a.width -> c.width -> b.width -> a.width"), std::string::npos);
  EXPECT_EQ(bench.number("a.width"), 1);
}

TEST(Link, CyclesOfAFileLoadAsProblemsAndAreSavedAgain) {
  Bench bench(R"({"a": {"type": "diffuse.box", "width": {"link": "b.width"}, "height": 9},
                  "b": {"type": "diffuse.box", "width": {"link": "a.width"}}, "c": {"type": "diffuse.box", "width": {"link": "a.width"}}})");
  bench.session.update();
  EXPECT_EQ(bench.number("a.height"), 9);
  EXPECT_EQ(bench.number("c.width"), 1);
  EXPECT_TRUE(bench.has_problem("a.width -> b.width -> a.width") || bench.has_problem("b.width -> a.width -> b.width"));
  EXPECT_NE(error_of([&] { bench.session.set("a.width", 3.0f); }), "");
  EXPECT_EQ(bench.saved("b")["width"], Json::parse(R"({"link": "a.width"})"));
  bench.session.unlink("b.width");
  bench.session.set("b.width", 8.0f);
  EXPECT_EQ(bench.number("c.width"), 8) << "broken open, the rest revives";
  EXPECT_EQ(bench.state("a.width").error, "");
}

TEST(Link, UnlinkingKeepsTheCurrentValueAsSet) {
  Bench bench;
  bench.session.link("a.width", "b.height", "3*x");
  bench.session.unlink("a.width");
  EXPECT_EQ(bench.number("a.width"), 6);
  EXPECT_EQ(bench.saved("a")["width"], 6);
  bench.session.set("b.height", 1.0f);
  EXPECT_EQ(bench.number("a.width"), 6);
}

TEST(Link, RevisionsGrowThroughChainsAndOnlyWhenTheValueChanges) {
  Bench bench;
  bench.session.link("a.width", "b.width");
  bench.session.link("b.width", "c.width");
  const auto before = bench.box("a").width.revision();
  bench.session.set("c.height", 77.0f);
  EXPECT_EQ(bench.box("a").width.revision(), before);
  bench.session.set("c.width", 5.0f);
  EXPECT_GT(bench.box("a").width.revision(), before);
  const auto after = bench.box("a").width.revision();
  bench.session.set("c.width", 5.0f);
  EXPECT_EQ(bench.box("a").width.revision(), after);
}

TEST(Link, ALongChainFromAFileCostsNoStack) {
  Json plugins = Json::object();
  const char* names[] = {"width", "height", "bias", "gain", "glow"};
  const int instances = 1000;
  for (int i = 0; i < instances; ++i) {
    Json& entry = plugins["i" + std::to_string(i)];
    entry["type"] = "diffuse.box";
    for (int k = 0; k < 5; ++k) {
      if (i == 0 && k == 0) entry[names[k]] = 17;
      else entry[names[k]]["link"] = k > 0 ? "i" + std::to_string(i) + "." + names[k - 1] : "i" + std::to_string(i - 1) + "." + names[4];
    }
  }
  Bench bench(plugins.dump());
  EXPECT_EQ(bench.number("i999.glow"), 17);
  bench.session.set("i0.width", 18.0f);
  EXPECT_EQ(bench.number("i999.glow"), 18);
}

TEST(Link, DataFlowsOnlyBetweenTheSameKinds) {
  Bench bench(R"({"scan": {"type": "importer.vtk"}, "sink": {"type": "diffuse.sink"}})");
  EXPECT_EQ(bench.session.linkable("sink.mesh"), std::vector<std::string>{"scan.mesh"});
  EXPECT_TRUE(bench.session.linkable("sink.volume").empty());
  EXPECT_NE(error_of([&] { bench.session.link("sink.volume", "scan.mesh"); }).find("mesh data does not convert to volume data"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.session.link("scan.mesh", "sink.mesh"); }).find("output"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.json("sink.mesh", "5"); }), "");

  bench.session.link("sink.mesh", "scan.mesh");
  EXPECT_EQ(bench.state("sink.mesh").data_state, "pending");
  const auto mesh = std::make_shared<const lumen::Mesh>();
  Instance& scan = *bench.session.find("scan");
  const auto draws = bench.session.find("sink")->draw_revision();
  scan.adopt(scan.slot_of("mesh"), mesh, "ready");
  EXPECT_EQ(bench.read<lumen::DataPointer>("sink.mesh"), mesh);
  EXPECT_EQ(bench.state("sink.mesh").data_state, "ready");
  EXPECT_GT(bench.session.find("sink")->draw_revision(), draws);
  EXPECT_FALSE(bench.saved("scan").contains("mesh")) << "outputs are never saved";
  EXPECT_FALSE(bench.session.modified() && bench.session.history().steps().empty());

  bench.session.unlink("sink.mesh");
  EXPECT_EQ(bench.read<lumen::DataPointer>("sink.mesh"), nullptr);
  EXPECT_FALSE(bench.saved("sink").contains("mesh"));
}

TEST(Link, OfARemovedSourceStaysAndRevives) {
  Bench bench(R"({"scan": {"type": "importer.vtk"}, "sink": {"type": "diffuse.sink", "mesh": {"link": "scan.mesh"}}})");
  Instance& scan = *bench.session.find("scan");
  scan.adopt(scan.slot_of("mesh"), std::make_shared<const lumen::Mesh>(), "ready");
  EXPECT_NE(bench.read<lumen::DataPointer>("sink.mesh"), nullptr);
  bench.session.remove("scan");
  EXPECT_EQ(bench.read<lumen::DataPointer>("sink.mesh"), nullptr);
  EXPECT_TRUE(bench.has_problem("no instance 'scan'"));
  EXPECT_EQ(bench.saved("sink")["mesh"]["link"], "scan.mesh");
  bench.session.history().undo();
  EXPECT_FALSE(bench.has_problem("no instance 'scan'"));
  const auto mesh = std::make_shared<const lumen::Mesh>();
  Instance& again = *bench.session.find("scan");
  again.adopt(again.slot_of("mesh"), mesh, "ready");
  EXPECT_EQ(bench.read<lumen::DataPointer>("sink.mesh"), mesh);
}

TEST(Link, LinkableLeavesOutWhatWouldCycle) {
  Bench bench;
  bench.session.link("b.width", "a.width");
  const auto sources = bench.session.linkable("a.width");
  EXPECT_EQ(std::count(sources.begin(), sources.end(), "b.width"), 0);
  EXPECT_EQ(std::count(sources.begin(), sources.end(), "c.width"), 1);
  EXPECT_EQ(std::count(sources.begin(), sources.end(), "c.count"), 1);
  EXPECT_EQ(std::count(sources.begin(), sources.end(), "c.offset"), 0);
}

}  // namespace
}  // namespace lumenshop
