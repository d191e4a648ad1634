// The panel of cuts: what it measures, and the change between a cut in each frame and a cut once, in the real window under Xvfb.
#include <cmath>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "frame/headless.h"
#include "window/workbench.h"
#include "window_test_case.h"

namespace {

using namespace lumenshop;

constexpr const char* session_text = R"({ "lumenshop": 1,
  "plugins": {
    "scan": {"type": "importer.shape", "shape": "sphere", "detail": 64},
    "ambient": {"type": "ambient.constant"}, "lambert": {"type": "diffuse.lambert"},
    "cut": {"type": "splitter.plane", "axis": [0, 1, 0], "angle": 90, "offset": 0.2},
    "ball": {"type": "renderer.surface", "mesh": {"link": "scan.mesh"}, "ambient": "ambient", "diffuse": "lambert", "splitter": "cut"},
    "orbit": {"type": "interactor.orbit"}, "front": {"type": "interactor.light"} },
  "views": {"main": {"camera": "orbit", "lights": ["front"], "renderers": ["ball"], "antialiasing": 1, "interactors": ["orbit"]}},
  "layout": [["main"]] }
)";

TEST(SplitTrial, DrawsTheViewAsItIsAndWithoutTheCut) {
  Workshop workshop;
  const HeadlessContext context;
  workshop.session().load(Json::parse(session_text), std::filesystem::temp_directory_path());
  workshop.scheduler().wait();
  SessionWorkbench workbench(workshop, [](const std::string&) {});
  workshop.view("main").resize({96, 96});
  const Json before = workshop.session().to_json();
  const auto covered = [&](const std::string& instance) {
    const auto trial = workbench.trial("main", instance, {"depth"});
    while (trial->step()) {}
    EXPECT_GT(trial->milliseconds(), 0) << "of all passes";
    const auto depth = trial->layer("depth");
    return std::isfinite(depth->pixels[(48 * 96 + 48) * depth->channels.size()]);
  };
  EXPECT_FALSE(covered("ball")) << "the gap runs through the middle";
  EXPECT_TRUE(covered("cut"));
  EXPECT_FALSE(covered("ball"));
  EXPECT_EQ(workshop.session().to_json(), before);
  workshop.close_views();
}

struct SplitWindow : lumenshop::testing::WindowTestCase {
  SplitWindow() : WindowTestCase(session_text) {}
};

TEST_F(SplitWindow, AButtonCutsOnceUndoTakesItBackAndSoDoesTheOtherButton) {
  play_in_panel("split", R"json({"click": "split/measure:ball"}, {"idle": 1.5}, {"expect_place": "split/measure:ball"}, {"shot": "measured.ppm"},
    {"click": "split/once:ball"}, {"settle": true}, {"idle": 0.3},
    {"expect": "ball.mesh", "link": "split.result"}, {"expect": "ball.splitter", "value": []}, {"expect": "split.mesh", "link": "scan.mesh"},
    {"expect": "split.angle", "link": "cut.angle", "value": 90}, {"expect": "split.offset", "link": "cut.offset"}, {"expect": "split.transform", "link": "ball.transform"},
    {"expect": "split.capped", "value": true}, {"expect_place": "split/live:ball"}, {"expect_place": "split/once:ball", "there": false}, {"expect_problems": 0}, {"shot": "once.ppm"},
    {"key": "Ctrl+Z"}, {"settle": true}, {"idle": 0.3},
    {"expect": "ball.mesh", "link": "scan.mesh"}, {"expect": "ball.splitter", "value": ["cut"]}, {"expect_place": "outline/split", "there": false},
    {"click": "split/once:ball"}, {"settle": true}, {"idle": 0.3}, {"expect": "ball.mesh", "link": "split.result"},
    {"click": "split/live:ball"}, {"settle": true}, {"idle": 0.3},
    {"expect": "ball.mesh", "link": "scan.mesh"}, {"expect": "ball.splitter", "value": ["cut"]}, {"expect": "split.enabled", "value": false},
    {"click": "split/once:ball"}, {"settle": true}, {"idle": 0.3}, {"expect": "split.enabled", "value": true},
    {"expect": "ball.mesh", "link": "split.result"}, {"expect_place": "outline/split2", "there": false}, {"expect_problems": 0})json");
}

}  // namespace
