// The real window under Xvfb: a person's steps, played through its input queue.
#include <fstream>
#include <iterator>
#include <string>

#include "window_test_case.h"

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

struct Window : lumenshop::testing::WindowTestCase {
  Window() : WindowTestCase(session_text) {}
};

TEST_F(Window, NumbersAreDraggedTypedResetAndUndone) {
  play(R"json([
    {"settle": true}, {"select": "wall"}, {"idle": 0.1},
    {"drag": "properties/wall.shininess", "by": [30, 0]}, {"expect": "wall.shininess", "above": 100, "set": true},
    {"key": "Ctrl+Z"}, {"expect": "wall.shininess", "value": 60},
    {"key": "Ctrl+Shift+Z"}, {"expect": "wall.shininess", "above": 100},
    {"click": "properties/wall.shininess"}, {"key": "Ctrl+A"}, {"type": "2*(10+2.5) "}, {"key": "Enter"}, {"expect": "wall.shininess", "value": 25},
    {"key": "Ctrl+Z"}, {"expect": "wall.shininess", "above": 100},
    {"move": "properties/label:wall.shininess"}, {"key": "Backspace"}, {"expect": "wall.shininess", "value": 40, "set": false},
    {"drag": "properties/wall.shininess", "by": [60, 0], "release": false}, {"expect": "wall.shininess", "above": 100},
    {"key": "Esc"}, {"expect": "wall.shininess", "value": 40, "set": false}])json");
}

TEST_F(Window, ShiftDragsFinely) {
  play(R"json([
    {"settle": true}, {"select": "ssao"}, {"idle": 0.1},
    {"drag": "properties/ssao.strength", "by": [20, 0], "keys": "Shift"}, {"expect": "ssao.strength", "above": 1.0001, "set": true},
    {"expect": "ssao.strength", "below": 1.2}])json");
}

TEST_F(Window, DraggingInThePictureTurnsTheCameraAndItsUndoIsSeparate) {
  play(R"json([
    {"settle": true}, {"expect": "orbit.rotation", "set": false},
    {"select": "wall"}, {"idle": 0.1}, {"click": "properties/wall.enabled", "at": [0.05, 0.5]}, {"expect": "wall.enabled", "value": false},
    {"drag": "view/picture", "by": [150, 40]}, {"expect": "orbit.rotation", "set": true},
    {"key": "Ctrl+Z"}, {"expect": "orbit.rotation", "set": true}, {"expect": "wall.enabled", "value": true},
    {"move": "view/picture"}, {"key": "BracketLeft"}, {"expect": "orbit.rotation", "set": false}])json");
}

TEST_F(Window, TheWheelZoomsAndKeysTurn) {
  play(R"json([
    {"settle": true}, {"wheel": "view/picture", "notches": 2}, {"expect": "orbit.distance", "set": true},
    {"key": "7"}, {"idle": 0.5}, {"settle": true}, {"expect": "orbit.rotation", "value": [0, 0, 0, 1], "tolerance": 1e-4},
    {"key": "5"}, {"expect": "orbit.projection", "value": "orthographic"}])json");
}

TEST_F(Window, LAndADragTurnTheLight) {
  play(R"json([
    {"settle": true}, {"drag": "view/picture", "by": [120, 0], "hold": "L"},
    {"expect": "front.direction", "differs": [0, -1, 0]}, {"expect": "orbit.rotation", "set": false}])json");
}

TEST_F(Window, AClickInThePictureSelects) {
  play(R"json([
    {"settle": true}, {"select": "orbit"}, {"click": "view/picture", "at": [0.02, 0.98]}, {"expect_place": "properties/orbit.rotation", "there": false},
    {"click": "outline/front"}, {"idle": 0.1}, {"expect_place": "properties/front.direction"}])json");
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
  play(R"json([
    {"settle": true}, {"drag": "view/picture", "at": [0.7, 0.5], "by": [60, 0]}, {"expect": "cut.translation", "differs": [0, 0, 0], "set": true}, {"expect": "orbit.rotation", "set": false},
    {"key": "Ctrl+Z"}, {"expect": "cut.translation", "value": [0, 0, 0], "set": false},
    {"drag": "view/picture", "at": [0.7, 0.5], "by": [60, 0], "release": false}, {"expect": "cut.translation", "differs": [0, 0, 0]},
    {"key": "Esc"}, {"expect": "cut.translation", "value": [0, 0, 0], "set": false}, {"expect": "orbit.rotation", "set": false}, {"expect_problems": 0}])json", "cut.json");
}

TEST_F(Window, AClickPicksAPartAndSelectsItsSurface) {
  std::ofstream(folder / "cut.json") << cut_ball;
  play(R"json([
    {"settle": true}, {"click": "view/picture", "at": [0.62, 0.4]}, {"idle": 0.1},
    {"expect": "pick.renderer", "value": "skin"}, {"expect": "pick.part", "value": 0}, {"expect": "cut.whole", "value": [0]}, {"expect": "orbit.rotation", "set": false},
    {"expect_place": "view/label:pick"}, {"expect_place": "properties/skin.mesh"},
    {"key": "Ctrl+Z"}, {"expect": "cut.whole", "value": []}, {"expect": "pick.renderer", "value": ""}, {"expect_place": "view/label:pick", "there": false},
    {"click": "view/picture", "at": [0.38, 0.4], "keys": "Shift"}, {"expect": "pick.part", "value": 1}, {"expect": "cut.whole", "value": [0]},
    {"idle": 0.4}, {"click": "view/picture", "at": [0.02, 0.98]}, {"expect": "cut.whole", "value": []}, {"expect_place": "properties/skin.mesh", "there": false}, {"expect_problems": 0}])json", "cut.json");
}

TEST_F(Window, AFieldOfReferencesMakesNewInstancesInOneStep) {
  play(R"json([
    {"settle": true}, {"select": "wall"}, {"idle": 0.1},
    {"click": "properties/wall.splitter"}, {"idle": 0.3}, {"type": "plane"}, {"idle": 0.2}, {"shot": "new.ppm"}, {"key": "Enter"}, {"idle": 0.3},
    {"expect": "wall.splitter", "value": ["plane"]}, {"expect_place": "outline/plane"}, {"expect_place": "properties/wall.splitter"}, {"expect_problems": 0},
    {"key": "Ctrl+Z"}, {"idle": 0.2}, {"expect": "wall.splitter", "value": []}, {"expect_place": "outline/plane", "there": false},
    {"click": "properties/wall.specular"}, {"idle": 0.3}, {"type": "new phong"}, {"idle": 0.2}, {"key": "Enter"}, {"settle": true},
    {"expect": "wall.specular", "value": "phong"}, {"key": "Ctrl+Z"}, {"idle": 0.2}, {"expect": "wall.specular", "value": "blinn"}])json");
}

TEST_F(Window, DrawsNothingWhileIdle) {
  play(R"json([{"settle": true}, {"idle": 1}, {"idle": 3, "frames": 0}])json");
}

TEST_F(Window, PanelsComeAndGoByKeys) {
  play(R"json([
    {"settle": true}, {"expect_place": "outline/wall"}, {"key": "T"}, {"idle": 0.1}, {"expect_place": "outline/wall", "there": false},
    {"key": "T"}, {"key": "Ctrl+B"}, {"idle": 0.1}, {"expect_place": "outline/wall", "there": false}, {"key": "Ctrl+B"}, {"idle": 0.1}, {"expect_place": "outline/wall"}])json");
}

TEST_F(Window, SavesWhatWasChangedAndNothingElse) {
  play(R"json([
    {"settle": true}, {"select": "wall"}, {"idle": 0.1}, {"click": "properties/wall.shininess"}, {"key": "Ctrl+A"}, {"type": "33"}, {"key": "Enter"},
    {"key": "Ctrl+S"}, {"idle": 0.2}])json");
  std::ifstream stream(folder / "session.json");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_NE(text.find("\"shininess\": 33"), std::string::npos) << text;
  EXPECT_EQ(text.find("field_of_view"), std::string::npos) << "defaults are not saved";
}

TEST_F(Window, OpensWhatIsDropped) {
  std::ofstream(folder / "other.json") << R"({"lumenshop": 1, "title": "Other", "plugins": {"turn": {"type": "interactor.orbit"}}, "views": {}})";
  play(R"json([{"settle": true}, {"drop": ["other.json"]}, {"idle": 0.2}, {"expect": "turn.style", "value": "trackball"}])json");
}

TEST_F(Window, EveryPropertyHasItsControl) {
  std::string steps = R"json([{"settle": true})json";
  for (const char* place : {"wall.transform", "wall.diffuse", "wall.diffuse_color", "wall.shininess", "orbit.rotation", "orbit.pivot", "orbit.projection", "scan.mesh", "main.lights",
                            "main.camera", "main.antialiasing", "front.color", "front.direction"}) {
    const std::string id = std::string(place).substr(0, std::string(place).find('.'));
    steps += R"json(, {"select": ")json" + id + R"json("}, {"idle": 0.1}, {"expect_place": "properties/)json" + place + R"json("})json";
  }
  play(steps + "]");
}

TEST_F(Window, StaysWellAtEveryScaleAndTheme) {
  for (const char* scale : {"1.5", "2"})
    play(R"json([{"settle": true}, {"select": "ssao"}, {"command": "window.light"}, {"idle": 0.2}, {"command": "window.high_contrast"}, {"idle": 0.2},
      {"drag": "properties/ssao.strength", "by": [30, 0]}, {"expect": "ssao.strength", "above": 1.01}])json", "session.json", std::string("LUMENSHOP_SCALE=") + scale);
}

TEST_F(Window, SaysWhatItCannotOpen) {
  std::ofstream(folder / "broken.json") << "{";
  play(R"json([{"idle": 0.3}, {"expect_problems": 0}])json", "broken.json");
}

}  // namespace
