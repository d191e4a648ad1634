/// Every view of every session of the installation is an image test: drawn and compared with
/// tests/image/references/<session>.png, or <session>-<view>.png where the session has several views.
/// LUMEN_UPDATE_REFERENCES=1 writes the references instead.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command/offscreen.h"
#include "command/picture_encoding.h"
#include "image/png_file.h"
#include "installation.h"

namespace lumenshop {
namespace {

constexpr int tolerance = 8;             // of 255
constexpr double accepted_part = 0.005;  // of the pixels

/// One view of a session, by the session's path under the folder of sessions.
struct Picture {
  std::string session, view;
  std::string reference;  ///< file name without extension
};

std::vector<Picture> pictures() {
  std::vector<Picture> all;
  const auto folder = Installation::find().sessions();
  if (!std::filesystem::is_directory(folder)) return all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream file(entry.path());
    const auto session = nlohmann::json::parse(file, nullptr, false);
    if (!session.is_object() || !session.contains("views")) continue;
    const bool several = session["views"].size() > 1;
    const std::string name = std::filesystem::relative(entry.path(), folder).replace_extension().string();
    for (const auto& [view, contents] : session["views"].items()) all.push_back({name, view, several ? name + "-" + view : name});
  }
  std::sort(all.begin(), all.end(), [](const Picture& a, const Picture& b) { return a.reference < b.reference; });
  return all;
}

BytePicture drawn(Offscreen& offscreen) {
  offscreen.view().request({"color"});
  offscreen.finish();
  const auto image = displayable(*offscreen.view().layer("color"), "color", {});
  BytePicture picture{image->width, image->height, {}};
  const std::size_t channels = image->channels.size();
  for (std::size_t pixel = 0; pixel < image->pixels.size(); pixel += channels)
    for (std::size_t channel = 0; channel < 3; ++channel)
      picture.rgb.push_back(std::uint8_t(std::lround(255 * image->pixels[pixel + channel])));
  return picture;
}

class SessionPicture : public testing::TestWithParam<Picture> {};

TEST_P(SessionPicture, IsAsItsReference) {
  const std::filesystem::path file = Installation::find().sessions() / (GetParam().session + ".json");
  const std::filesystem::path reference = std::filesystem::path(LUMEN_REFERENCES) / (GetParam().reference + ".png");
  Offscreen offscreen({.files = {file}, .view = GetParam().view, .size = {480, 360}});
  const BytePicture picture = drawn(offscreen);
  EXPECT_TRUE(offscreen.all_findings().empty()) << offscreen.all_findings().text();
  if (std::getenv("LUMEN_UPDATE_REFERENCES")) {
    std::filesystem::create_directories(reference.parent_path());
    write_png(picture, reference);
    GTEST_SKIP() << "wrote " << reference;
  }
  ASSERT_TRUE(std::filesystem::exists(reference)) << reference << " is missing: look at the picture, then run with LUMEN_UPDATE_REFERENCES=1";
  const double part = differing_part(read_png(reference), picture, tolerance);
  if (part > accepted_part) {
    const std::filesystem::path failed = Installation::find().root / "failed" / (GetParam().reference + ".png");
    std::filesystem::create_directories(failed.parent_path());
    write_png(picture, failed);
  }
  EXPECT_LE(part, accepted_part) << "the new picture is in " << Installation::find().root / "failed";
}

TEST_P(SessionPicture, IsTheSameAfterSavingAndLoading) {
  const std::filesystem::path file = Installation::find().sessions() / (GetParam().session + ".json");
  Offscreen offscreen({.files = {file}, .view = GetParam().view, .size = {240, 180}});
  const BytePicture before = drawn(offscreen);
  Session& session = offscreen.workshop().session();
  const Json saved = session.to_json();
  offscreen.workshop().close_views();
  session.load(saved, file.parent_path());
  EXPECT_EQ(session.to_json(), saved);
  offscreen.reopen();
  EXPECT_EQ(differing_part(before, drawn(offscreen), 0), 0);
}

INSTANTIATE_TEST_SUITE_P(Sessions, SessionPicture, testing::ValuesIn(pictures()), [](const auto& info) {
  std::string name = info.param.reference;
  std::replace_if(name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SessionPicture);

}  // namespace
}  // namespace lumenshop
