/// Every session of the installation is an image test: drawn and compared with tests/image/references/<name>.png.
/// LUMEN_UPDATE_REFERENCES=1 writes the references instead.
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "command/offscreen.h"
#include "command/picture_encoding.h"
#include "image/png_file.h"
#include "installation.h"

namespace lumenshop {
namespace {

constexpr int tolerance = 8;             // of 255
constexpr double accepted_part = 0.005;  // of the pixels

std::vector<std::string> session_names() {
  std::vector<std::string> names;
  const auto folder = Installation::find().sessions();
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
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

class SessionPicture : public testing::TestWithParam<std::string> {};

TEST_P(SessionPicture, IsAsItsReference) {
  const std::filesystem::path file = Installation::find().sessions() / (GetParam() + ".json");
  const std::filesystem::path reference = std::filesystem::path(LUMEN_REFERENCES) / (GetParam() + ".png");
  Offscreen offscreen({.files = {file}, .size = {480, 360}});
  const BytePicture picture = drawn(offscreen);
  EXPECT_TRUE(offscreen.all_findings().empty()) << offscreen.all_findings().text();
  if (std::getenv("LUMEN_UPDATE_REFERENCES")) {
    write_png(picture, reference);
    GTEST_SKIP() << "wrote " << reference;
  }
  ASSERT_TRUE(std::filesystem::exists(reference)) << reference << " is missing: look at the picture, then run with LUMEN_UPDATE_REFERENCES=1";
  const double part = differing_part(read_png(reference), picture, tolerance);
  if (part > accepted_part) write_png(picture, Installation::find().root / "failed" / (GetParam() + ".png"));
  EXPECT_LE(part, accepted_part) << "the new picture is in " << Installation::find().root / "failed";
}

TEST_P(SessionPicture, IsTheSameAfterSavingAndLoading) {
  const std::filesystem::path file = Installation::find().sessions() / (GetParam() + ".json");
  Offscreen offscreen({.files = {file}, .size = {240, 180}});
  const BytePicture before = drawn(offscreen);
  Session& session = offscreen.workshop().session();
  const Json saved = session.to_json();
  offscreen.workshop().close_views();
  session.load(saved, file.parent_path());
  EXPECT_EQ(session.to_json(), saved);
  offscreen.reopen();
  EXPECT_EQ(differing_part(before, drawn(offscreen), 0), 0);
}

INSTANTIATE_TEST_SUITE_P(Sessions, SessionPicture, testing::ValuesIn(session_names()), [](const auto& info) { return info.param; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SessionPicture);

}  // namespace
}  // namespace lumenshop
