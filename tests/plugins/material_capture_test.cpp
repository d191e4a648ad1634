/// A captured look is the look: a sphere shaded by the picture of a sphere is that sphere.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

#include <nlohmann/json.hpp>

#include "command/picture_encoding.h"
#include "frame/headless.h"
#include "frame/shader_library.h"
#include "frame/view_renderer.h"
#include "installation.h"
#include "jobs/scheduler.h"
#include "material_capture.h"
#include "modules/registry.h"
#include "plugins/data_session.h"
#include "testing/given.h"

namespace lumenshop {
namespace {

constexpr const char* session_text = R"({ "lumenshop": 1,
  "plugins": {
    "data": {"type": "importer.given"}, "shot": {"type": "importer.given"},
    "camera": {"type": "interactor.orbit", "projection": "orthographic", "height": 2.2, "distance": 10, "pivot": [0, 0, 0], "rotation": [0, 0, 0, 1]},
    "front": {"type": "interactor.light", "direction": [0, 0, 1]},
    "constant": {"type": "ambient.constant", "intensity": 0.8}, "lambert": {"type": "diffuse.lambert"}, "phong": {"type": "specular.phong"},
    "dark": {"type": "ambient.lit_sphere", "front": {"link": "shot.image"}},
    "lit": {"type": "diffuse.lit_sphere", "fill_dark": false, "front": {"link": "shot.image"}, "front_mapping": "equidistant"},
    "ball": {"type": "renderer.surface", "mesh": {"link": "data.mesh"}, "ambient": "constant", "diffuse": "lambert", "specular": "phong",
             "ambient_color": [0.1, 0.08, 0.05], "diffuse_color": [0.7, 0.3, 0.2], "specular_color": [0.3, 0.4, 0.5], "shininess": 40} },
  "views": {"main": {"camera": "camera", "lights": ["front"], "renderers": ["ball"], "antialiasing": 1}} })";

struct MaterialCapture : testing::Test {
  HeadlessContext context;
  Registry registry{{Installation::find().plugins()}, nullptr};
  GivenFactory factory{registry};
  ShaderLibrary shaders{{Installation::find().shaders()}}, capture_shaders{{Installation::find().shaders()}};
  Session session{factory};
  Scheduler scheduler{session, nullptr};
  std::unique_ptr<ViewRenderer> view;

  void SetUp() override {
    registry.load_all();
    session.load(Json::parse(session_text), Installation::find().root);
    give("data", lumen::testing::sphere(256));
    view = std::make_unique<ViewRenderer>(session, shaders, "main");
    view->resize({96, 96});
    view->request({"color"});
  }
  void give(const char* id, lumen::DataPointer data) {
    scheduler.wait();
    static_cast<Given*>(session.find(id)->plugin())->give(std::move(data));
  }
  void finish() {
    session.update();
    scheduler.wait();
    session.update();
  }
  lumen::testing::Pixels drawn() {
    finish();
    view->finish();
    return lumen::testing::Pixels(view->layer("color"));
  }
  std::shared_ptr<lumen::Image> captured() {
    finish();
    return captured_material(session, "ball", "main", factory, capture_shaders);
  }
  /// From now on the ball is shaded by the picture.
  void wear(std::shared_ptr<const lumen::Image> picture, const char* space) {
    give("shot", std::move(picture));
    session.set("ball.ambient", lumen::Reference{"dark"});
    session.set("ball.diffuse", lumen::Reference{"lit"});
    session.set("ball.specular", lumen::Reference{});
    for (const char* term : {"dark", "lit"}) session.set(term + std::string(".space"), lumen::Choice{space});
  }
  /// In the numbers of an 8-bit picture.
  static float difference(const lumen::testing::Pixels& a, const lumen::testing::Pixels& b) {
    float largest = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        for (int c = 0; c < 3; ++c) largest = std::max(largest, 255 * std::abs(srgb_encoded(a.at(x, y, c)) - srgb_encoded(b.at(x, y, c))));
    return largest;
  }
};

TEST_F(MaterialCapture, APhongSphereComesBackUnderALightFromTheEye) {
  const auto before = drawn();
  const auto picture = captured();
  for (const char* space : {"light", "view"}) {
    wear(picture, space);
    EXPECT_LE(difference(before, drawn()), 2) << space;
  }
}

TEST_F(MaterialCapture, ViewSpaceKeepsLightsThatComeFromElsewhere) {
  session.set("front.direction", glm::vec3(0.5f, 0.6f, 0.6f));
  session.add("interactor.light", "back");
  session.set("back.direction", glm::vec3(-0.8f, -0.2f, 0.1f));
  session.set("back.color", lumen::Color(0.2f, 0.5f, 1));
  session.set("back.intensity", 1.5f);
  session.set("main.lights", lumen::References{{"front", "back"}});
  const auto before = drawn();
  wear(captured(), "view");
  session.set("main.lights", lumen::References{{"front"}});
  EXPECT_LE(difference(before, drawn()), 2);
}

TEST_F(MaterialCapture, TheCamerasFrameIsThePictures) {
  session.set("camera.rotation", glm::normalize(glm::quat(0.8f, 0.3f, -0.4f, 0.2f)));
  session.set("front.direction", glm::vec3(0.9f, 0.1f, -0.3f));
  const auto before = drawn();
  wear(captured(), "view");
  EXPECT_LE(difference(before, drawn()), 2);
}

TEST_F(MaterialCapture, PointLightsShineAsAtTheCenter) {
  session.set("front.direction", glm::vec3(0.3f, 0.4f, 0.5f));
  session.set("front.intensity", 0.5f);
  const auto parallel = captured();
  session.set("front.kind", lumen::Choice{"point"});
  session.set("front.position", glm::vec3(30, 40, 50));
  session.set("front.falloff", lumen::Choice{"quadratic"});
  session.set("front.intensity", 100.0f);
  const auto point = captured();
  // 100 / 5000 of the light at the center.
  const std::size_t middle = (std::size_t(point->height / 2) * point->width + point->width / 2) * 3;
  const float toward = glm::normalize(glm::vec3(3, 4, 5)).z;
  EXPECT_NEAR(parallel->pixels[middle], 0.8f * 0.1f + 0.5f * (0.7f * toward + 0.3f * std::pow(toward, 40.0f)), 2e-3f);
  EXPECT_NEAR(point->pixels[middle], 0.8f * 0.1f + 0.02f * (0.7f * toward + 0.3f * std::pow(toward, 40.0f)), 2e-3f);
}

TEST_F(MaterialCapture, CapturesWhatIsShadedByPicturesItself) {
  wear(captured(), "view");
  const auto before = drawn();
  const auto again = captured();
  session.set("ball.diffuse_color", lumen::Color(0, 0, 0));
  wear(again, "view");
  EXPECT_LE(difference(before, drawn()), 2);
}

TEST_F(MaterialCapture, TheAngleGrowsEvenlyToARightAngleAtTheEdges) {
  session.set("ball.ambient_color", lumen::Color(0, 0, 0));
  session.set("ball.specular", lumen::Reference{});
  session.set("ball.diffuse_color", lumen::Color(1, 1, 1));
  const auto picture = captured();
  ASSERT_EQ(picture->width, 512);
  for (const int x : {256, 300, 384, 450, 511}) {
    const float across = (float(x) + 0.5f) / 256 - 1, up = 0.5f / 256;
    const float wanted = std::cos(std::sqrt(across * across + up * up) * 1.5707963f);
    EXPECT_NEAR(picture->pixels[(255 * 512 + std::size_t(x)) * 3], wanted, 1e-3f) << x;
  }
  EXPECT_NEAR(picture->pixels[0], 0, 1e-3f) << "the rim's color goes on outward";
}

TEST_F(MaterialCapture, NamesWhatHasNoLook) {
  for (const char* id : {"front", "nobody", "main"}) {
    try {
      captured_material(session, id, "main", factory, capture_shaders);
      ADD_FAILURE() << id;
    } catch (const lumen::Error& error) {
      EXPECT_NE(std::string(error.what()).find(id), std::string::npos) << error.what();
    }
  }
}

TEST(MaterialFiles, AreWrittenUnderFreeNamesAndComeBack) {
  DataSession bench;
  ScratchFolder folder;
  auto picture = std::make_shared<lumen::Image>();
  picture->width = picture->height = 2;
  picture->channels = {"R", "G", "B"};
  picture->pixels = std::vector<float>{0, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1.0f, 3.5f};
  picture->finish();
  Instance& exporter = bench.add("exporter.image", "exporter");
  const auto gallery = folder / "data/gallery";
  EXPECT_EQ(save_material(bench.scheduler, exporter, picture, gallery, "wall").filename(), "wall.equidistant.exr");
  const auto second = save_material(bench.scheduler, exporter, picture, gallery, "wall");
  EXPECT_EQ(second.filename(), "wall-2.equidistant.exr");
  bench.add("importer.image", "picture");
  bench.session.set("picture.path", lumen::Value(lumen::Path{second.string()}));
  bench.run();
  const auto back = bench.data<lumen::Image>("picture.image");
  ASSERT_TRUE(back) << bench.messages("picture");
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(back->pixels[i], picture->pixels[i]);
}

TEST(MaterialFiles, PicturesOfRenderedSpheresShadeAsTheyAre) {
  const std::filesystem::path folder = std::filesystem::path(LUMEN_TEST_DATA) / "matcaps";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  DataSession bench;
  bench.add("importer.image", "picture");
  for (const char* name : {"png/jade.png", "exr/jade.exr"}) {
    bench.session.set("picture.path", lumen::Value(lumen::Path{(folder / name).string()}));
    bench.run();
    const auto matcap = bench.data<lumen::Image>("picture.image");
    ASSERT_TRUE(matcap) << bench.messages("picture");
    ASSERT_GE(matcap->channels.size(), 3u);
    lumen::testing::Scene scene({65, 65});
    scene.give("matcap", matcap);
    scene.add("diffuse.lit_sphere", "lit", R"({"space": "view", "front": {"link": "matcap.image"}})");
    scene.surface("wall", lumen::testing::rectangle(), R"({"diffuse": "lit"})");
    const glm::vec3 color = scene.layer("diffuse").rgb(32, 32);
    glm::vec3 middle(0);  // the four texels that meet there
    for (const int corner : {0, 1, 2, 3}) {
      const std::size_t at = (std::size_t(matcap->height / 2 - corner / 2) * matcap->width + matcap->width / 2 - corner % 2) * matcap->channels.size();
      middle += 0.25f * glm::vec3(matcap->pixels[at], matcap->pixels[at + 1], matcap->pixels[at + 2]);
    }
    EXPECT_NEAR(glm::distance(color, middle), 0, 1e-3f) << name;
    EXPECT_GT(color.g, color.b) << "jade is green";
    EXPECT_TRUE(scene.problems().empty());
  }
}

}  // namespace
}  // namespace lumenshop
