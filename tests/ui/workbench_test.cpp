// What panels do to the session, without a window.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <lumen/image.h>

#include "frame/headless.h"
#include "window/workbench.h"

namespace {

using namespace lumenshop;

constexpr const char* session_text = R"({ "lumenshop": 1,
  "plugins": {
    "lambert": {"type": "diffuse.lambert"}, "wall": {"type": "renderer.surface", "diffuse": "lambert", "ambient_color": [0, 0.1, 0], "diffuse_color": [0, 0.5, 0]},
    "orbit": {"type": "interactor.orbit"}, "front": {"type": "interactor.light", "direction": [0, -1, 0]} },
  "views": {"main": {"camera": "orbit", "lights": ["front"], "renderers": ["wall"]}} })";

struct WorkbenchTest : testing::Test {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("lumenshop-workbench-" + std::to_string(getpid()));
  Workshop workshop;
  std::string notice;
  std::unique_ptr<SessionWorkbench> workbench;

  void SetUp() override {
    setenv("XDG_DATA_HOME", folder.c_str(), 1);
    workshop.session().load(Json::parse(session_text), std::filesystem::temp_directory_path());
    workbench = std::make_unique<SessionWorkbench>(workshop, [this](const std::string& message) { notice = message; });
  }
  void TearDown() override {
    workbench.reset();
    std::filesystem::remove_all(folder);
  }
  std::shared_ptr<const lumen::Image> picture(const std::string& type, const std::string& values) {
    for (int round = 0; round < 3000; ++round) {
      if (auto made = workbench->picture(type, values)) return made;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      workbench->update();
    }
    return nullptr;
  }
};

TEST_F(WorkbenchTest, AddsAnInstanceWithItsValuesInOneStep) {
  const std::string id = workbench->add("importer.lit_sphere", R"({"material": "jade", "size": 64})");
  EXPECT_EQ(id, "lit_sphere");
  EXPECT_EQ(std::get<lumen::Choice>(workbench->property(id + ".material")->value).name, "jade");
  EXPECT_TRUE(workbench->property(id + ".size")->set);
  workshop.session().history().undo();
  EXPECT_FALSE(workbench->property(id + ".material"));
  workshop.session().history().redo();
  EXPECT_EQ(std::get<int>(workbench->property(id + ".size")->value), 64);
}

TEST_F(WorkbenchTest, LeavesNothingBehindOfWhatItCannotAdd) {
  EXPECT_THROW(workbench->add("importer.lit_sphere", R"({"nothing_of_its": 1})"), lumen::Error);
  EXPECT_THROW(workbench->add("importer.lit_sphere", "[1]"), lumen::Error);
  EXPECT_THROW(workbench->add("importer.no_such", "{}"), lumen::Error);
  EXPECT_EQ(workshop.session().plugins().size(), 4u);
  EXPECT_EQ(workbench->add("importer.lit_sphere", "{}"), "lit_sphere");
}

TEST_F(WorkbenchTest, ManyChangesBetweenBeginAndEndAreOneStep) {
  workbench->begin_edit();
  const std::string source = workbench->add("importer.lit_sphere", "{}"), term = workbench->add("diffuse.lit_sphere", R"({"fill_dark": false})");
  workbench->link(term + ".front", source + ".image", {});
  workbench->set("wall.diffuse", lumen::Reference{term});
  workbench->end_edit();
  EXPECT_EQ(workbench->property(term + ".front")->link, source + ".image");
  workshop.session().history().undo();
  EXPECT_EQ(workshop.session().plugins().size(), 4u);
  EXPECT_EQ(std::get<lumen::Reference>(workbench->property("wall.diffuse")->value).id, "lambert");
  EXPECT_FALSE(workshop.session().history().can_undo());
}

TEST_F(WorkbenchTest, HandsOverPicturesThatAreInNoSession) {
  const auto made = picture("importer.lit_sphere", R"({"material": "gold", "size": 32})");
  ASSERT_TRUE(made);
  EXPECT_EQ(made->width, 32);
  EXPECT_EQ(workshop.session().plugins().size(), 4u);
  EXPECT_FALSE(workshop.session().modified());
  EXPECT_FALSE(workbench->picture("importer.lit_sphere", R"({"material": "gold", "size": 32})")) << "made anew";
}

TEST_F(WorkbenchTest, SaysWhyThereIsNoPicture) {
  EXPECT_THROW(picture("importer.image", R"({"path": "/no/such/picture.png"})"), lumen::Error);
  EXPECT_THROW(picture("importer.phantom", R"({"triangles": 1000})"), lumen::Error);
  EXPECT_THROW(picture("importer.image", R"({"size": 3})"), lumen::Error);
  EXPECT_FALSE(workbench->picture("importer.image", R"({"path": "/no/such/picture.png"})")) << "the next call tries again";
}

TEST_F(WorkbenchTest, CapturesASurfaceIntoTheGallery) {
  const HeadlessContext context;
  const std::filesystem::path file = workbench->capture("wall");
  EXPECT_EQ(file, folder / "lumenshop/gallery/wall.equidistant.exr");
  EXPECT_EQ(file.parent_path(), workbench->gallery());
  const auto made = picture("importer.image", "{\"path\": \"" + file.string() + "\"}");
  ASSERT_TRUE(made);
  EXPECT_EQ(made->width, 512);
  const std::size_t middle = (std::size_t(256) * 512 + 256) * made->channels.size();
  EXPECT_NEAR(made->pixels[middle + 1], 0.6f, 1e-3f) << "ambient and diffuse, for the light stands at the eye";
  EXPECT_THROW(workbench->capture("orbit"), lumen::Error);
}

TEST_F(WorkbenchTest, HasNothingUnderThePointerWithoutAWindow) {
  EXPECT_EQ(workbench->instance_at({10, 10}), "");
  workbench->set_picking([](glm::vec2 point) { return point.x > 5 ? "wall" : ""; });
  EXPECT_EQ(workbench->instance_at({10, 10}), "wall");
}

}  // namespace
