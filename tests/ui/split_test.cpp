// The panel of cuts: what it measures, and the change between a cut in each frame and a cut once, in the real window under Xvfb.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "frame/headless.h"
#include "installation.h"
#include "window/workbench.h"

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

struct SplitWindow : testing::Test {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("lumenshop-split-" + std::to_string(getpid()));
  const std::filesystem::path program = Installation::find().root / "bin/lumenshop";

  void SetUp() override {
    if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0) GTEST_SKIP() << "xvfb-run is not installed";
    if (!std::filesystem::exists(program)) GTEST_SKIP() << program << " is not built";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "session.json") << session_text;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// Plays the steps with the panel open; the script's failures are a failure.
  void play(const std::string& steps) const {
    std::ofstream(folder / "script.json") << R"json([{"settle": true}, {"command": "panel.split"}, {"idle": 0.5}, )json" + steps + "]";
    const std::string place = "'" + folder.string() + "'";
    const std::string command = "cd " + place + " && XDG_DATA_HOME=" + place + " XDG_CONFIG_HOME=" + place + " MESA_SHADER_CACHE_DIR=" + place +
                                " timeout 240 xvfb-run -a -s '-screen 0 1280x800x24' '" + program.string() + "' --size 1200x760 --script script.json session.json 2>&1";
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::array<char, 4096> buffer;
    while (const auto count = std::fread(buffer.data(), 1, buffer.size(), pipe)) output.append(buffer.data(), count);
    const int status = pclose(pipe);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << output;
    if (const char* kept = std::getenv("LUMEN_KEEP_SHOTS")) std::filesystem::copy(folder, kept, std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  }
};

TEST_F(SplitWindow, AButtonCutsOnceUndoTakesItBackAndSoDoesTheOtherButton) {
  play(R"json({"click": "split/measure:ball"}, {"idle": 1.5}, {"expect_place": "split/measure:ball"}, {"shot": "measured.ppm"},
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
