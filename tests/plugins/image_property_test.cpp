/// Pictures as shaders see them: image(p.name, uv), through compositor.background.
#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// Texel (x, y from the top) is (x / 8, y / 8, blue).
std::shared_ptr<lumen::Image> ramp(int width, int height, float blue) {
  auto image = std::make_shared<lumen::Image>();
  image->width = width;
  image->height = height;
  image->channels = {"R", "G", "B"};
  std::vector<float> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.insert(pixels.end(), {float(x) / 8, float(y) / 8, blue});
  image->pixels = std::move(pixels);
  image->finish();
  return image;
}

TEST(ImageProperty, shows_each_texel_where_it_is_and_nothing_of_its_neighbors_in_the_atlas) {
  Scene scene({20, 10});  // five pixels per texel, so that every third is a texel's center
  scene.give("small", ramp(4, 2, 0.5f));
  scene.give("large", ramp(7, 5, 1.0f));
  scene.add("compositor.background", "other", R"({"mode": "image", "image": {"link": "large.image"}})");
  scene.add("compositor.background", "shown", R"({"mode": "image", "image": {"link": "small.image"}})");
  scene.set("other.enabled", "false");
  const Pixels picture = scene.picture();
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) {
      const glm::vec3 color = picture.rgb(5 * x + 2, 5 * y + 2);
      EXPECT_NEAR(color.r, float(x) / 8, 1e-3f) << x << ", " << y;
      EXPECT_NEAR(color.g, float(y) / 8, 1e-3f) << x << ", " << y;
      EXPECT_NEAR(color.b, 0.5f, 1e-3f);
    }
  EXPECT_NEAR(picture.rgb(0, 0).r, 0.0f, 1e-3f) << "the edge repeats";
  EXPECT_NEAR(picture.rgb(19, 9).b, 0.5f, 1e-3f) << "no texel of another picture";
}

TEST(ImageProperty, covers_or_fits_the_view) {
  Scene scene({40, 10});
  scene.give("photo", ramp(2, 1, 1.0f));
  scene.add("compositor.background", "background", R"({"mode": "image", "image": {"link": "photo.image"}, "color": [0, 1, 0]})");
  scene.set("background.fit", "contain");
  EXPECT_NEAR(scene.picture().rgb(5, 5).g, 1.0f, 1e-3f) << "20 pixels wide: the color stands beside it";
  EXPECT_NEAR(scene.picture().rgb(12, 5).b, 1.0f, 1e-3f);
  scene.set("background.fit", "cover");
  EXPECT_NEAR(scene.picture().rgb(1, 5).b, 1.0f, 1e-3f);
  EXPECT_NEAR(scene.picture().rgb(1, 5).r, 0.0f, 1e-3f);
}

TEST(ImageProperty, follows_new_data_and_is_absent_without) {
  Scene scene({5, 5});
  scene.add("compositor.background", "background", R"({"mode": "image", "color": [0, 1, 0]})");
  EXPECT_NEAR(scene.picture().rgb(2, 2).g, 1.0f, 1e-3f) << "no picture yet: the color";
  scene.give("photo", ramp(1, 1, 0.25f));
  scene.set("background.image", R"({"link": "photo.image"})");
  EXPECT_NEAR(scene.picture().rgb(2, 2).b, 0.25f, 1e-3f);
  scene.give("photo", ramp(1, 1, 0.75f));
  EXPECT_NEAR(scene.picture().rgb(2, 2).b, 0.75f, 1e-3f);
}

}  // namespace
