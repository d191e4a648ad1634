// Comparing techniques: a view drawn with another one, how pictures differ, and the table.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../../plugins/editor/accuracy/difference.h"
#include "frame/headless.h"
#include "window/workbench.h"

namespace {

using namespace lumenshop;

std::shared_ptr<lumen::Image> gray(const std::vector<float>& pixels, int width) {
  auto image = std::make_shared<lumen::Image>();
  image->width = width;
  image->height = int(pixels.size()) / width;
  image->channels = {"R"};
  image->pixels = pixels;
  image->finish();
  return image;
}

TEST(PictureDifference, OfAnOffsetIsTheOffset) {
  const auto reference = gray(std::vector<float>(64, 0.25f), 8), picture = gray(std::vector<float>(64, 0.5f), 8);
  const Difference off = difference(*picture, *reference, std::vector<bool>(64, true));
  EXPECT_NEAR(off.rmse, 0.25, 1e-6);
  EXPECT_NEAR(off.largest, 0.25, 1e-6);
  // Even pictures have no variance: what is left is the comparison of the means.
  const double a = std::pow(0.5, 1 / 2.2), b = std::pow(0.25, 1 / 2.2), c = 1e-4;
  EXPECT_NEAR(off.structural, 1 - (2 * a * b + c) / (a * a + b * b + c), 1e-6);
  EXPECT_EQ(difference(*reference, *reference, std::vector<bool>(64, true)).structural, 0);
}

TEST(PictureDifference, CountsOnlyThePixelsThatCount) {
  std::vector<float> pixels(16, 0.5f);
  pixels[3] = 1;
  const auto reference = gray(std::vector<float>(16, 0.5f), 4), picture = gray(pixels, 4);
  std::vector<bool> counts(16, true);
  EXPECT_NEAR(difference(*picture, *reference, counts).rmse, 0.5 / 4, 1e-6) << "one of 16 pixels is off by .5";
  EXPECT_NEAR(difference(*picture, *reference, counts).map[3], 0.5f, 1e-6f);
  counts[3] = false;
  EXPECT_EQ(difference(*picture, *reference, counts).largest, 0);
}

constexpr const char* session_text = R"({ "lumenshop": 1,
  "plugins": {
    "phantom": {"type": "importer.phantom", "triangles": 5000}, "ambient": {"type": "ambient.constant"},
    "wall": {"type": "renderer.surface", "mesh": {"link": "phantom.wall"}, "ambient": "ambient"},
    "ssao": {"type": "occlusion.ssao"}, "hidden": {"type": "occlusion.stochastic_depth"}, "rays": {"type": "occlusion.traced", "samples": 16, "samples_per_step": 4},
    "orbit": {"type": "interactor.orbit"} },
  "views": {"main": {"camera": "orbit", "renderers": ["wall"], "occlusion": "ssao", "antialiasing": 1}} })";

struct TrialTest : testing::Test {
  Workshop workshop;
  HeadlessContext context;
  std::unique_ptr<SessionWorkbench> workbench;

  void SetUp() override {
    workshop.session().load(Json::parse(session_text), std::filesystem::temp_directory_path());
    workshop.scheduler().wait();
    workbench = std::make_unique<SessionWorkbench>(workshop, [](const std::string&) {});
    workshop.view("main").resize({96, 96});
  }
  void TearDown() override {
    workbench.reset();
    workshop.close_views();
  }
  static std::shared_ptr<const lumen::Image> finished(lumen::Trial& trial) {
    while (trial.step()) EXPECT_LE(trial.progress(), 1.0f);
    return trial.layer("occlusion");
  }
};

TEST_F(TrialTest, DrawsTheViewWithAnotherOcclusionAndLeavesTheSessionAlone) {
  const Json before = workshop.session().to_json();
  const auto rays = workbench->trial("main", "rays", {"occlusion"}), ssao = workbench->trial("main", "ssao", {"occlusion"});
  const auto traced = finished(*rays), sampled = finished(*ssao);
  EXPECT_EQ(traced->width, 96);
  EXPECT_NE(std::vector<float>(traced->pixels.begin(), traced->pixels.end()), std::vector<float>(sampled->pixels.begin(), sampled->pixels.end()));
  for (const auto* trial : {rays.get(), ssao.get()}) {
    EXPECT_GT(trial->milliseconds(), 0);
    EXPECT_GE(trial->bytes(), 96u * 96 * 4) << "its layer at least";
  }
  EXPECT_EQ(workshop.session().to_json(), before);
  // The view's own picture is still that of its own occlusion.
  workshop.view("main").request({"occlusion"});
  workshop.view("main").finish();
  const auto own = workshop.view("main").layer("occlusion");
  EXPECT_EQ(std::vector<float>(own->pixels.begin(), own->pixels.end()), std::vector<float>(sampled->pixels.begin(), sampled->pixels.end()));
}

/// An occlusion that draws the surfaces again by itself.
TEST_F(TrialTest, IsThePictureOfAViewThatHasTheOcclusion) {
  const auto trial = workbench->trial("main", "hidden", {"occlusion"});
  const auto drawn = finished(*trial);
  Json session = Json::parse(session_text);
  session["views"]["main"]["occlusion"] = "hidden";
  workshop.session().load(session, std::filesystem::temp_directory_path());
  workshop.scheduler().wait();
  workshop.view("main").resize({96, 96});
  workshop.view("main").request({"occlusion"});
  workshop.view("main").finish();
  const auto own = workshop.view("main").layer("occlusion");
  EXPECT_GT(*std::max_element(own->pixels.begin(), own->pixels.end()), 0.05f);
  EXPECT_EQ(std::vector<float>(own->pixels.begin(), own->pixels.end()), std::vector<float>(drawn->pixels.begin(), drawn->pixels.end()));
}

TEST_F(TrialTest, RefusesWhatIsNoTechnique) {
  EXPECT_THROW(workbench->trial("main", "orbit", {"occlusion"}), lumen::Error);
  EXPECT_THROW(workbench->trial("main", "nobody", {"occlusion"}), lumen::Error);
}

}  // namespace
