/// exporter.image and importer.image: what is written comes back.
#include <algorithm>
#include <cmath>
#include <limits>

#include <lumen/image.h>

#include "plugins/data_session.h"

namespace lumenshop {
namespace {

namespace files = std::filesystem;

std::shared_ptr<lumen::Image> picture(std::vector<std::string> channels) {
  auto image = std::make_shared<lumen::Image>();
  image->width = 5;
  image->height = 3;
  image->channels = std::move(channels);
  std::vector<float> pixels(5 * 3 * image->channels.size());
  for (std::size_t index = 0; index < pixels.size(); ++index) pixels[index] = static_cast<float>(index) / static_cast<float>(pixels.size() - 1);
  image->pixels = std::move(pixels);
  image->finish();
  return image;
}

struct Pictures : DataSession {
  Pictures() : exporter(add("exporter.image", "exporter")) { add("importer.image", "picture"); }
  std::shared_ptr<const lumen::Image> through(lumen::DataPointer image, const std::string& name) {
    scheduler.write_file(exporter, std::move(image), folder / name);
    session.set("picture.path", lumen::Value(lumen::Path{(folder / name).string()}));
    run();
    return data<lumen::Image>("picture.image");
  }
  Instance& exporter;
  ScratchFolder folder;
};

TEST(Pictures, floats_come_back_bit_by_bit_with_their_channel_names) {
  Pictures bench;
  auto image = picture({"diffuse.R", "diffuse.G", "diffuse.B", "depth.Z"});
  std::vector<float> pixels(image->pixels.begin(), image->pixels.end());
  pixels[3] = std::numeric_limits<float>::infinity();
  pixels[5] = -1.0f / 3;
  image->pixels = pixels;
  const auto result = bench.through(image, "layers.exr");
  ASSERT_TRUE(result) << bench.messages("picture");
  EXPECT_EQ(result->width, 5);
  EXPECT_EQ(result->height, 3);
  ASSERT_EQ(result->channels.size(), 4u);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const auto found = std::find(result->channels.begin(), result->channels.end(), image->channels[channel]);
    ASSERT_NE(found, result->channels.end()) << image->channels[channel];
    const auto at = static_cast<std::size_t>(found - result->channels.begin());
    for (std::size_t pixel = 0; pixel < 15; ++pixel) EXPECT_EQ(result->pixels[pixel * 4 + at], pixels[pixel * 4 + channel]);
  }
  const auto map = bench.through(picture({"R", "G", "B"}), "map.pfm");
  ASSERT_TRUE(map);
  EXPECT_EQ(map->pixels[7], picture({"R", "G", "B"})->pixels[7]);
}

TEST(Pictures, eight_bits_hold_the_numbers_as_given_rounded) {
  Pictures bench;
  const auto image = picture({"R", "G", "B"});
  for (const char* name : {"a.png", "a.ppm", "a.tif", "a.bmp", "a.tga"}) {
    const auto result = bench.through(image, name);
    ASSERT_TRUE(result) << name << bench.messages("picture");
    for (std::size_t index = 0; index < image->pixels.size(); ++index) {
      // The importer decodes sRGB; encoded again they are the bytes.
      const float linear = result->pixels[index];
      const float encoded = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
      EXPECT_NEAR(encoded * 255, std::floor(image->pixels[index] * 255 + 0.5f), 0.01f) << name << " " << index;
    }
  }
}

TEST(Pictures, alpha_is_neither_multiplied_nor_divided) {
  Pictures bench;
  auto image = picture({"R", "G", "B", "A"});
  image->pixels = std::vector<float>(60, 0.2f);
  for (const char* name : {"a.png", "a.tif"}) {
    const auto result = bench.through(image, name);
    ASSERT_TRUE(result) << name;
    ASSERT_EQ(result->channels.size(), 4u);
    EXPECT_NEAR(result->pixels[3], 0.2f, 1e-6f) << name;
  }
}

TEST(Pictures, an_unknown_extension_names_the_formats_and_writes_nothing) {
  Pictures bench;
  try {
    bench.scheduler.write_file(bench.exporter, picture({"R", "G", "B"}), bench.folder / "a.xyz");
    FAIL();
  } catch (const lumen::Error& error) {
    EXPECT_NE(std::string(error.what()).find("png exr pfm"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(files::is_empty(bench.folder.path()));
}

TEST(Pictures, broken_files_load_or_give_one_message) {
  const files::path folder = files::path(LUMEN_TEST_DATA) / "bad" / "imager-pnm";
  if (!files::exists(folder)) GTEST_SKIP() << "no shared data at " << folder;
  Pictures bench;
  for (const auto& entry : files::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    bench.session.set("picture.path", lumen::Value(lumen::Path{entry.path().string()}));
    bench.run();
    const std::size_t problems = bench.session.find("picture")->problems().size();
    EXPECT_EQ(problems, bench.state("picture.image") == "ready" ? 0u : 1u) << entry.path() << bench.messages("picture");
  }
}

}  // namespace
}  // namespace lumenshop
