// The real window under Xvfb: a person's steps, played through its input queue.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "installation.h"

namespace {

constexpr const char* session_text = R"({ "lumenshop": 1, "title": "A test",
  "plugins": {
    "scan": {"type": "importer.phantom"},
    "ambient": {"type": "ambient.constant"}, "lambert": {"type": "diffuse.lambert"}, "blinn": {"type": "specular.blinn"},
    "ssao": {"type": "occlusion.ssao"},
    "wall": {"type": "renderer.surface", "mesh": {"link": "scan.mesh"}, "ambient": "ambient", "diffuse": "lambert", "specular": "blinn", "shininess": 60},
    "orbit": {"type": "interactor.orbit"}, "front": {"type": "interactor.light", "direction": [0, -1, 0]} },
  "views": {"main": {"camera": "orbit", "lights": ["front"], "renderers": ["wall"], "antialiasing": 1, "interactors": ["orbit"]}},
  "layout": [["main"]] }
)";

struct Outcome {
  int code = -1;
  std::string output;
};

struct Window : testing::Test {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("lumenshop-window-" + std::to_string(getpid()));
  const std::filesystem::path program = lumenshop::Installation::find().root / "bin/lumenshop";

  void SetUp() override {
    if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0) GTEST_SKIP() << "xvfb-run is not installed";
    if (!std::filesystem::exists(program)) GTEST_SKIP() << program << " is not built";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "session.json") << session_text;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// Plays the steps over the session; the script's failures are the output.
  Outcome play(const std::string& steps, const std::string& file = "session.json", const std::string& environment = "") const {
    std::ofstream(folder / "script.json") << steps;
    const std::string command = "cd '" + folder.string() + "' && XDG_CONFIG_HOME='" + folder.string() + "' MESA_SHADER_CACHE_DIR='" + folder.string() + "' " + environment +
                                " timeout 240 xvfb-run -a -s '-screen 0 1280x800x24' '" + program.string() + "' --size 1200x760 --script script.json " + file + " 2>&1";
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return outcome;
    std::array<char, 4096> buffer;
    while (const auto count = std::fread(buffer.data(), 1, buffer.size(), pipe)) outcome.output.append(buffer.data(), count);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }
  void expect_well(const Outcome& outcome) const { EXPECT_EQ(outcome.code, 0) << outcome.output; }
};

TEST_F(Window, NumbersAreDraggedTypedResetAndUndone) {
  expect_well(play(R"json([
    {"settle": true}, {"select": "wall"}, {"idle": 0.1},
    {"drag": "properties/wall.shininess", "by": [30, 0]}, {"expect": "wall.shininess", "above": 100, "set": true},
    {"key": "Ctrl+Z"}, {"expect": "wall.shininess", "value": 60},
    {"key": "Ctrl+Shift+Z"}, {"expect": "wall.shininess", "above": 100},
    {"click": "properties/wall.shininess"}, {"key": "Ctrl+A"}, {"type": "2*(10+2.5) "}, {"key": "Enter"}, {"expect": "wall.shininess", "value": 25},
    {"key": "Ctrl+Z"}, {"expect": "wall.shininess", "above": 100},
    {"move": "properties/label:wall.shininess"}, {"key": "Backspace"}, {"expect": "wall.shininess", "value": 40, "set": false},
    {"drag": "properties/wall.shininess", "by": [60, 0], "release": false}, {"expect": "wall.shininess", "above": 100},
    {"key": "Esc"}, {"expect": "wall.shininess", "value": 40, "set": false}])json"));
}

TEST_F(Window, ShiftDragsFinely) {
  expect_well(play(R"json([
    {"settle": true}, {"select": "ssao"}, {"idle": 0.1},
    {"drag": "properties/ssao.strength", "by": [20, 0], "keys": "Shift"}, {"expect": "ssao.strength", "above": 1.0001, "set": true},
    {"expect": "ssao.strength", "below": 1.2}])json"));
}

TEST_F(Window, DraggingInThePictureTurnsTheCameraAndItsUndoIsSeparate) {
  expect_well(play(R"json([
    {"settle": true}, {"expect": "orbit.rotation", "set": false},
    {"select": "wall"}, {"idle": 0.1}, {"click": "properties/wall.enabled", "at": [0.05, 0.5]}, {"expect": "wall.enabled", "value": false},
    {"drag": "view/picture", "by": [150, 40]}, {"expect": "orbit.rotation", "set": true},
    {"key": "Ctrl+Z"}, {"expect": "orbit.rotation", "set": true}, {"expect": "wall.enabled", "value": true},
    {"move": "view/picture"}, {"key": "BracketLeft"}, {"expect": "orbit.rotation", "set": false}])json"));
}

TEST_F(Window, TheWheelZoomsAndKeysTurn) {
  expect_well(play(R"json([
    {"settle": true}, {"wheel": "view/picture", "notches": 2}, {"expect": "orbit.distance", "set": true},
    {"key": "7"}, {"idle": 0.5}, {"settle": true}, {"expect": "orbit.rotation", "value": [0, 0, 0, 1], "tolerance": 1e-4},
    {"key": "5"}, {"expect": "orbit.projection", "value": "orthographic"}])json"));
}

TEST_F(Window, LAndADragTurnTheLight) {
  expect_well(play(R"json([
    {"settle": true}, {"drag": "view/picture", "by": [120, 0], "hold": "L"},
    {"expect": "front.direction", "differs": [0, -1, 0]}, {"expect": "orbit.rotation", "set": false}])json"));
}

TEST_F(Window, AClickInThePictureSelects) {
  expect_well(play(R"json([
    {"settle": true}, {"select": "orbit"}, {"click": "view/picture", "at": [0.02, 0.98]}, {"expect_place": "properties/orbit.rotation", "there": false},
    {"click": "outline/front"}, {"idle": 0.1}, {"expect_place": "properties/front.direction"}])json"));
}

/// A ball cut by the plane x = 0, its halves apart; the handle's middle is the picture's, its arrow points to the right.
constexpr const char* cut_ball = R"({ "lumenshop": 1,
  "plugins": {
    "ball": {"type": "importer.shape"}, "skin": {"type": "renderer.surface", "mesh": {"link": "ball.mesh"}, "splitter": "cut"},
    "cut": {"type": "splitter.plane", "angle": 90, "offset": 0.2, "whole": {"link": "pick.selection"}},
    "handle": {"type": "interactor.plane_handle", "plane": "cut", "size": 0.5}, "pick": {"type": "interactor.pick"},
    "orbit": {"type": "interactor.orbit"}, "front": {"type": "interactor.light"} },
  "views": {"main": {"camera": "orbit", "lights": ["front"], "renderers": ["skin"], "antialiasing": 1, "interactors": ["handle", "pick", "orbit"]}} }
)";

TEST_F(Window, DraggingTheHandleIsOneStepAndEscTakesItBack) {
  std::ofstream(folder / "cut.json") << cut_ball;
  expect_well(play(R"json([
    {"settle": true}, {"drag": "view/picture", "at": [0.7, 0.5], "by": [60, 0]}, {"expect": "cut.translation", "differs": [0, 0, 0], "set": true}, {"expect": "orbit.rotation", "set": false},
    {"key": "Ctrl+Z"}, {"expect": "cut.translation", "value": [0, 0, 0], "set": false},
    {"drag": "view/picture", "at": [0.7, 0.5], "by": [60, 0], "release": false}, {"expect": "cut.translation", "differs": [0, 0, 0]},
    {"key": "Esc"}, {"expect": "cut.translation", "value": [0, 0, 0], "set": false}, {"expect": "orbit.rotation", "set": false}, {"expect_problems": 0}])json", "cut.json"));
}

TEST_F(Window, AClickPicksAPartAndSelectsItsSurface) {
  std::ofstream(folder / "cut.json") << cut_ball;
  expect_well(play(R"json([
    {"settle": true}, {"click": "view/picture", "at": [0.62, 0.4]}, {"idle": 0.1},
    {"expect": "pick.renderer", "value": "skin"}, {"expect": "pick.part", "value": 0}, {"expect": "cut.whole", "value": [0]}, {"expect": "orbit.rotation", "set": false},
    {"expect_place": "view/label:pick"}, {"expect_place": "properties/skin.mesh"},
    {"key": "Ctrl+Z"}, {"expect": "cut.whole", "value": []}, {"expect": "pick.renderer", "value": ""}, {"expect_place": "view/label:pick", "there": false},
    {"click": "view/picture", "at": [0.38, 0.4], "keys": "Shift"}, {"expect": "pick.part", "value": 1}, {"expect": "cut.whole", "value": [0]},
    {"idle": 0.4}, {"click": "view/picture", "at": [0.02, 0.98]}, {"expect": "cut.whole", "value": []}, {"expect_place": "properties/skin.mesh", "there": false}, {"expect_problems": 0}])json", "cut.json"));
}

TEST_F(Window, DrawsNothingWhileIdle) {
  expect_well(play(R"json([{"settle": true}, {"idle": 1}, {"idle": 3, "frames": 0}])json"));
}

TEST_F(Window, PanelsComeAndGoByKeys) {
  expect_well(play(R"json([
    {"settle": true}, {"expect_place": "outline/wall"}, {"key": "T"}, {"idle": 0.1}, {"expect_place": "outline/wall", "there": false},
    {"key": "T"}, {"key": "Ctrl+B"}, {"idle": 0.1}, {"expect_place": "outline/wall", "there": false}, {"key": "Ctrl+B"}, {"idle": 0.1}, {"expect_place": "outline/wall"}])json"));
}

TEST_F(Window, SavesWhatWasChangedAndNothingElse) {
  expect_well(play(R"json([
    {"settle": true}, {"select": "wall"}, {"idle": 0.1}, {"click": "properties/wall.shininess"}, {"key": "Ctrl+A"}, {"type": "33"}, {"key": "Enter"},
    {"key": "Ctrl+S"}, {"idle": 0.2}])json"));
  std::ifstream stream(folder / "session.json");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_NE(text.find("\"shininess\": 33"), std::string::npos) << text;
  EXPECT_EQ(text.find("field_of_view"), std::string::npos) << "defaults are not saved";
}

TEST_F(Window, OpensWhatIsDropped) {
  std::ofstream(folder / "other.json") << R"({"lumenshop": 1, "title": "Other", "plugins": {"turn": {"type": "interactor.orbit"}}, "views": {}})";
  expect_well(play(R"json([{"settle": true}, {"drop": ["other.json"]}, {"idle": 0.2}, {"expect": "turn.style", "value": "trackball"}])json"));
}

TEST_F(Window, EveryPropertyHasItsControl) {
  std::string steps = R"json([{"settle": true})json";
  for (const char* place : {"wall.transform", "wall.diffuse", "wall.diffuse_color", "wall.shininess", "orbit.rotation", "orbit.pivot", "orbit.projection", "scan.mesh", "main.lights",
                            "main.camera", "main.antialiasing", "front.color", "front.direction"}) {
    const std::string id = std::string(place).substr(0, std::string(place).find('.'));
    steps += R"json(, {"select": ")json" + id + R"json("}, {"idle": 0.1}, {"expect_place": "properties/)json" + place + R"json("})json";
  }
  expect_well(play(steps + "]"));
}

TEST_F(Window, StaysWellAtEveryScaleAndTheme) {
  for (const char* scale : {"1.5", "2"})
    expect_well(play(R"json([{"settle": true}, {"select": "ssao"}, {"command": "window.light"}, {"idle": 0.2}, {"command": "window.high_contrast"}, {"idle": 0.2},
      {"drag": "properties/ssao.strength", "by": [30, 0]}, {"expect": "ssao.strength", "above": 1.01}])json", "session.json", std::string("LUMENSHOP_SCALE=") + scale));
}

TEST_F(Window, SaysWhatItCannotOpen) {
  std::ofstream(folder / "broken.json") << "{";
  expect_well(play(R"json([{"idle": 0.3}, {"expect_problems": 0}])json", "broken.json"));
}

}  // namespace
