// The material gallery in the real window under Xvfb: double clicks, drags, undo.
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "window_test_case.h"

namespace {

constexpr const char* session_text = R"({ "lumenshop": 1,
  "plugins": {
    "scan": {"type": "importer.phantom", "triangles": 5000},
    "ambient": {"type": "ambient.constant"}, "lambert": {"type": "diffuse.lambert"}, "blinn": {"type": "specular.blinn"},
    "wall": {"type": "renderer.surface", "mesh": {"link": "scan.mesh"}, "ambient": "ambient", "diffuse": "lambert", "specular": "blinn"},
    "other": {"type": "renderer.surface", "diffuse": "lambert"},
    "orbit": {"type": "interactor.orbit"}, "front": {"type": "interactor.light", "direction": [0, -1, 0]} },
  "views": {"main": {"camera": "orbit", "lights": ["front"], "renderers": ["wall", "other"], "antialiasing": 1, "interactors": ["orbit"]}},
  "layout": [["main"]] }
)";

struct MaterialWindow : lumenshop::testing::WindowTestCase {
  MaterialWindow() : WindowTestCase(session_text) {}
  void play(const std::string& steps) const { play_in_panel("materials", steps); }
  /// The mean color of a picture of the window.
  std::array<double, 3> mean(const std::string& shot) const {
    std::ifstream stream(folder / shot, std::ios::binary);
    std::string magic;
    int width = 0, height = 0, most = 0;
    stream >> magic >> width >> height >> most;
    stream.get();
    std::array<double, 3> sum{};
    // The view's part: right of the outline, left of the properties, above the gallery.
    std::string row(std::size_t(width) * 3, '\0');
    for (int y = 0; y < height && stream.read(row.data(), std::streamsize(row.size())); ++y)
      for (int x = 300; x < 820 && y > 40 && y < 420; ++x)
        for (int c = 0; c < 3; ++c) sum[std::size_t(c)] += static_cast<unsigned char>(row[std::size_t(3 * x + c)]);
    for (double& value : sum) value /= 520.0 * 379;
    return sum;
  }
};

TEST_F(MaterialWindow, ADoubleClickGivesTheSelectedSurfaceALookThatUndoTakesBack) {
  play(R"json({"select": "wall"}, {"idle": 0.3}, {"shot": "before.ppm"},
    {"click": "materials/front:jade", "times": 2, "at": [0.5, 0.4]}, {"settle": true}, {"idle": 0.3},
    {"expect": "wall.diffuse", "value": "lit_sphere2"}, {"expect": "lit_sphere2.front", "link": "lit_sphere.image"}, {"expect": "lit_sphere.material", "value": "jade"},
    {"expect": "wall.ambient", "value": "lit_sphere3"}, {"expect": "wall.specular", "value": ""}, {"expect_problems": 0}, {"shot": "jade.ppm"},
    {"key": "Ctrl+Z"}, {"settle": true}, {"idle": 0.3}, {"expect": "wall.diffuse", "value": "lambert"}, {"expect": "wall.specular", "value": "blinn"},
    {"expect": "wall.ambient", "value": "ambient"}, {"expect_place": "outline/lit_sphere", "there": false}, {"move": "menu/File"}, {"shot": "after.ppm"})json");
  const auto before = mean("before.ppm"), jade = mean("jade.ppm"), after = mean("after.ppm");
  EXPECT_GT(jade[1] - jade[0], before[1] - before[0] + 5) << "jade is green";
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(before[c], after[c], 0.5);
}

TEST_F(MaterialWindow, ArrowKeysAndEnterDoWhatADoubleClickDoes) {
  play(R"json({"select": "wall"}, {"idle": 0.3}, {"move": "menu/File"}, {"key": "Right"}, {"idle": 0.1}, {"expect_place": "materials/cursor:front:clay"},
    {"key": "Right"}, {"key": "Right"}, {"key": "Left"}, {"idle": 0.1}, {"expect_place": "materials/cursor:front:skin"},
    {"key": "Enter"}, {"settle": true}, {"idle": 0.3}, {"expect": "wall.diffuse", "value": "lit_sphere2"}, {"expect": "lit_sphere.material", "value": "skin"},
    {"key": "Ctrl+Z"}, {"settle": true}, {"idle": 0.2}, {"expect": "wall.diffuse", "value": "lambert"},
    {"key": "Down"}, {"key": "Enter"}, {"settle": true}, {"idle": 0.3}, {"expect": "wall.diffuse", "value": "lit_sphere2"}, {"expect_place": "materials/cursor:front:skin", "there": false}, {"shot": "keys.ppm"})json");
}

TEST_F(MaterialWindow, TheSameMaterialComesFromOneImporterAndTermsAreNotShared) {
  play(R"json({"select": "wall"}, {"idle": 0.3}, {"click": "materials/front:bone", "times": 2, "at": [0.5, 0.4]}, {"idle": 0.3},
    {"select": "other"}, {"idle": 0.3}, {"click": "materials/front:bone", "times": 2, "at": [0.5, 0.4]}, {"idle": 0.3},
    {"expect": "wall.diffuse", "value": "lit_sphere2"}, {"expect": "other.diffuse", "value": "lit_sphere4"},
    {"expect": "lit_sphere2.front", "link": "lit_sphere.image"}, {"expect": "lit_sphere4.front", "link": "lit_sphere.image"},
    {"wheel": "materials/front:bone", "notches": -3}, {"idle": 0.2}, {"click": "materials/back:gold", "times": 2, "at": [0.5, 0.4]}, {"idle": 0.3},
    {"expect": "other.diffuse", "value": "lit_sphere4"}, {"expect": "lit_sphere4.front", "link": "lit_sphere.image"}, {"expect": "lit_sphere4.back", "link": "lit_sphere6.image"})json");
}

TEST_F(MaterialWindow, ADragOntoASurfaceInThePictureGivesItTheMaterial) {
  play(R"json({"select": "orbit"}, {"idle": 0.3},
    {"drag": "materials/front:artery", "at": [0.5, 0.4], "to": "view/picture", "steps": 6}, {"idle": 0.3},
    {"expect": "wall.diffuse", "value": "lit_sphere2"}, {"expect": "lit_sphere.material", "value": "artery"}, {"expect_place": "properties/wall.diffuse"})json");
}

TEST_F(MaterialWindow, ACaptureBecomesAThumbnailThatCanBeGivenBack) {
  play(R"json({"select": "wall"}, {"idle": 0.3}, {"click": "materials/capture"}, {"idle": 1.5}, {"expect_place": "materials/front:wall"},
    {"click": "materials/front:wall", "times": 2, "at": [0.5, 0.4]}, {"settle": true}, {"expect": "wall.diffuse", "value": "lit_sphere"},
    {"expect": "lit_sphere.front", "link": "image.image"}, {"expect": "lit_sphere.front_mapping", "value": "equidistant"},
    {"expect": "lit_sphere.space", "value": "view"}, {"expect_problems": 0})json");
  EXPECT_TRUE(std::filesystem::exists(folder / "lumenshop/gallery/wall.equidistant.exr"));
}

}  // namespace
