/// Lit spheres against a bilinear lookup on the CPU, at every covered pixel of a sphere, through the program's own path.

#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr float tolerance = 1e-4f;
constexpr float pi = std::numbers::pi_v<float>;

using ImagePointer = std::shared_ptr<const lumen::Image>;

template <class Color>
ImagePointer picture(int size, Color color_at) {
  auto image = std::make_shared<lumen::Image>();
  image->width = image->height = size;
  image->channels = {"R", "G", "B"};
  std::vector<float> pixels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const glm::vec3 color = color_at(glm::vec2((float(x) + 0.5f) / float(size), 1 - (float(y) + 0.5f) / float(size)));
      pixels.insert(pixels.end(), {color.r, color.g, color.b});
    }
  image->pixels = std::move(pixels);
  image->finish();
  return image;
}

/// Smooth, and different in all directions and channels; `shift` tells pictures apart.
ImagePointer waves(int size, float shift = 0) {
  return picture(size, [&](glm::vec2 uv) {
    return glm::vec3(0.5f + 0.4f * std::sin(5 * uv.x + shift), 0.4f + 0.3f * uv.y + 0.1f * shift, 0.3f + 0.2f * std::cos(4 * uv.x - 3 * uv.y + shift));
  });
}

/// A Lambert sphere, as a rendered one is seen.
ImagePointer lambert_picture(int size) {
  return picture(size, [](glm::vec2 uv) {
    const glm::vec2 place = 2.0f * uv - 1.0f;
    return glm::vec3(std::sqrt(std::max(0.0f, 1 - glm::dot(place, place))));
  });
}

/// uv from the bottom left.
glm::vec3 bilinear(const lumen::Image& image, glm::vec2 uv) {
  const auto texel = [&](int x, int y) {
    const float* at = &image.pixels[(std::size_t(std::clamp(y, 0, image.height - 1)) * image.width + std::clamp(x, 0, image.width - 1)) * image.channels.size()];
    return glm::vec3(at[0], at[1], at[2]);
  };
  const float x = uv.x * float(image.width) - 0.5f, y = (1 - uv.y) * float(image.height) - 0.5f;
  const int left = int(std::floor(x)), top = int(std::floor(y));
  return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - float(left)), glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - float(left)), y - float(top));
}

glm::vec3 darkest(const lumen::Image& image) {
  glm::vec3 color(0);
  float least = 1e9f;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::vec2 place((float(x) + 0.5f) / float(image.width) - 0.5f, (float(y) + 0.5f) / float(image.height) - 0.5f);
      if (glm::length(place) > 0.5f) continue;
      const float* at = &image.pixels[(std::size_t(y) * image.width + std::size_t(x)) * 3];
      const float luminance = 0.2126f * at[0] + 0.7152f * at[1] + 0.0722f * at[2];
      if (luminance < least) least = luminance, color = {at[0], at[1], at[2]};
    }
  return color;
}

std::string json(glm::vec3 v) { return "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]"; }

void add_ball(Scene& scene, const std::string& style) { scene.surface("ball", lumen::testing::sphere(96), style); }

/// Rodrigues' formula; half a turn about y where a and b are opposite.
glm::vec3 turned(glm::vec3 v, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 axis = glm::cross(a, b);
  const float sine = glm::length(axis), cosine = glm::dot(a, b);
  if (sine < 1e-5f) return cosine > 0 ? v : glm::vec3(-v.x, v.y, -v.z);
  const glm::vec3 k = axis / sine;
  return v * cosine + glm::cross(k, v) * sine + k * glm::dot(k, v) * (1 - cosine);
}

/// The normal in the light's frame; the eye looks along -z.
glm::vec3 in_light_space(glm::vec3 n, glm::vec3 l, glm::vec3 to_eye = {0, 0, 1}) {
  const glm::vec3 z(0, 0, 1);
  return {glm::dot(n, turned(turned({1, 0, 0}, z, to_eye), to_eye, l)), glm::dot(n, turned(turned({0, 1, 0}, z, to_eye), to_eye, l)), glm::dot(n, l)};
}

glm::vec2 orthographic(glm::vec3 n) { return {0.5f * n.x + 0.5f, 0.5f * n.y + 0.5f}; }
glm::vec2 equidistant(glm::vec3 n) {
  const float r = std::acos(std::clamp(n.z, -1.0f, 1.0f)) / pi, t = std::atan2(n.y, n.x);
  return {r * std::cos(t) + 0.5f, r * std::sin(t) + 0.5f};
}

/// Compares a layer with `wanted(normal)` where the surface is.
template <class Wanted>
int expect_everywhere(Scene& scene, const char* layer, Wanted wanted) {
  const Pixels normal = scene.layer("normal"), shown = scene.layer(layer);
  int covered = 0;
  for (int y = 0; y < normal.height(); ++y)
    for (int x = 0; x < normal.width(); ++x) {
      const glm::vec3 n = normal.rgb(x, y);
      if (n == glm::vec3(0)) continue;
      ++covered;
      const glm::vec3 color = wanted(n);
      for (int c = 0; c < 3; ++c)
        if (std::abs(shown.at(x, y, c) - color[c]) > tolerance) {
          ADD_FAILURE() << layer << " at " << x << ", " << y << " is " << shown.at(x, y, c) << ", not " << color[c];
          return covered;
        }
    }
  EXPECT_GT(covered, normal.width() * normal.height() / 4);
  for (const lumen::Problem& problem : scene.problems()) ADD_FAILURE() << problem.message;
  return covered;
}

const glm::vec3 slanted = glm::normalize(glm::vec3(0.4f, 0.5f, 0.6f)), sideways = glm::normalize(glm::vec3(-0.8f, -0.1f, 0.2f));

TEST(LitSphere, ViewSpaceLooksUpTheNormalAsItIsSeen) {
  const ImagePointer front = waves(64);
  Scene scene;
  scene.give("picture", front);
  scene.add("diffuse.lit_sphere", "lit", R"({"space": "view", "front": {"link": "picture.image"}})");
  add_ball(scene, R"({"diffuse": "lit"})");
  expect_everywhere(scene, "diffuse", [&](glm::vec3 n) { return bilinear(*front, orthographic(n)); });
  scene.set("front.direction", json(sideways));
  expect_everywhere(scene, "diffuse", [&](glm::vec3 n) { return bilinear(*front, orthographic(n)); });
}

TEST(LitSphere, LightSpaceLooksUpTheNormalInTheLightsFrame) {
  const ImagePointer front = waves(64);
  for (const auto& [mapping, uv] : {std::pair<const char*, glm::vec2 (*)(glm::vec3)>("equidistant", equidistant), std::pair<const char*, glm::vec2 (*)(glm::vec3)>("orthographic", orthographic)})
    for (const glm::vec3 l : {slanted, sideways, glm::vec3(0, 0, 1), glm::normalize(glm::vec3(0.3f, -0.2f, -0.9f))}) {
      Scene scene;
      scene.give("picture", front);
      scene.set("front.direction", json(l));
      scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}, "front_mapping": ")" + std::string(mapping) + "\"}");
      add_ball(scene, R"({"diffuse": "lit"})");
      expect_everywhere(scene, "diffuse", [&](glm::vec3 n) {
        const glm::vec3 in_light = in_light_space(n, l);
        return in_light.z < 0 ? darkest(*front) : bilinear(*front, uv(in_light));
      });
    }
}

TEST(LitSphere, LightSpaceFollowsTheEyeInPerspective) {
  const ImagePointer front = waves(64);
  Scene scene;
  scene.set("camera.projection", "perspective");
  scene.set("camera.distance", "3");
  scene.set("camera.field_of_view", "45");
  scene.set("front.direction", json(slanted));
  scene.give("picture", front);
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}, "front_mapping": "equidistant"})");
  add_ball(scene, R"({"diffuse": "lit"})");
  const Pixels normal = scene.layer("normal"), position = scene.layer("position"), diffuse = scene.layer("diffuse");
  for (int y = 0; y < normal.height(); ++y)
    for (int x = 0; x < normal.width(); ++x) {
      const glm::vec3 n = normal.rgb(x, y);
      if (n == glm::vec3(0)) continue;
      const glm::vec3 in_light = in_light_space(n, slanted, glm::normalize(glm::vec3(0, 0, 3) - position.rgb(x, y)));
      const glm::vec3 wanted = in_light.z < 0 ? darkest(*front) : bilinear(*front, equidistant(in_light));
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(diffuse.at(x, y, c), wanted[c], 2 * tolerance) << x << ", " << y;
    }
}

TEST(LitSphere, ALightFromBehindTurnsTheFrameAboutUp) {
  const ImagePointer back = waves(64);
  Scene scene;
  scene.give("picture", back);
  scene.set("front.direction", "[0, 0, -1]");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}, "front_dark": [0.9, 0.1, 0.2]})");
  add_ball(scene, R"({"diffuse": "lit"})");
  expect_everywhere(scene, "diffuse", [](glm::vec3) { return glm::vec3(0.9f, 0.1f, 0.2f); });
  // From just beside the axis the frame must still be one of unit vectors.
  const glm::vec3 almost = glm::normalize(glm::vec3(0.02f, 0.01f, -1));
  scene.set("front.direction", json(almost));
  expect_everywhere(scene, "diffuse", [&](glm::vec3 n) {
    const glm::vec3 in_light = in_light_space(n, almost);
    return in_light.z < 0 ? glm::vec3(0.9f, 0.1f, 0.2f) : bilinear(*back, orthographic(in_light));
  });
}

TEST(LitSphere, TheTangentFrameHoldsTheAngleToTheLightAndTwistsAtThePoles) {
  // Where the picture depends on the distance from its middle alone, both frames agree.
  const ImagePointer rings = picture(128, [](glm::vec2 uv) { return glm::vec3(1 - glm::length(uv - 0.5f)); });
  Scene scene;
  scene.give("picture", rings);
  scene.set("front.direction", json(slanted));
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}, "front_mapping": "equidistant"})");
  add_ball(scene, R"({"diffuse": "lit"})");
  const Pixels camera = scene.layer("diffuse");
  scene.set("lit.frame", "tangent");
  EXPECT_LT(largest_difference(camera, scene.layer("diffuse")), 0.01f);
  // Elsewhere they do not: across the pole of the up axis the tangent turns round.
  scene.give("picture", waves(128));
  const Pixels twisted = scene.layer("diffuse");
  scene.set("lit.frame", "camera");
  EXPECT_GT(largest_difference(twisted, scene.layer("diffuse")), 0.1f);
}

TEST(LitSphere, TheMappingOfARenderedSphereGivesItsOwnShading) {
  Scene scene({65, 65});
  scene.give("picture", lambert_picture(512));
  scene.surface("wall", lumen::testing::rectangle(), R"({"diffuse": "lit"})");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}})");
  scene.set("front.direction", json(glm::normalize(glm::vec3(1, 0, 1))));
  EXPECT_NEAR(scene.layer("diffuse").at(32, 32), 0.7071f, 1e-3f) << "a Lambert sphere at 45 degrees";
  scene.set("lit.front_mapping", "equidistant");
  EXPECT_NEAR(scene.layer("diffuse").at(32, 32), 0.8660f, 1e-3f) << "the wrong mapping";
}

TEST(LitSphere, DarkColorsAreThePicturesUnlessSet) {
  const ImagePointer front = waves(32), brighter = waves(32, 0.7f);
  Scene scene;
  scene.give("picture", front);
  scene.set("front.direction", "[1, 0, 0]");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}})");
  add_ball(scene, R"({"diffuse": "lit"})");
  const auto shown = [&] { return scene.layer("diffuse").rgb(10, 32); };
  EXPECT_NEAR(glm::distance(shown(), darkest(*front)), 0, tolerance);
  scene.give("picture", brighter);
  EXPECT_NEAR(glm::distance(shown(), darkest(*brighter)), 0, tolerance) << "follows another picture";
  scene.set("lit.front_dark", "[0.1, 0.2, 0.3]");
  EXPECT_NEAR(glm::distance(shown(), glm::vec3(0.1f, 0.2f, 0.3f)), 0, tolerance);
  scene.give("picture", front);
  EXPECT_NEAR(glm::distance(shown(), glm::vec3(0.1f, 0.2f, 0.3f)), 0, tolerance) << "what a person set stays";
  scene.set("lit.fill_dark", "false");
  EXPECT_EQ(shown(), glm::vec3(0));
}

TEST(LitSphere, AmbientTakesUpExactlyWhatDiffuseLeavesDark) {
  Scene scene;
  scene.give("picture", waves(32));
  scene.give("other", waves(32, 0.7f));
  scene.set("front.direction", json(slanted));
  scene.add("interactor.light", "back", R"({"direction": )" + json(sideways) + "}");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}, "back": {"link": "other.image"}})");
  scene.add("ambient.lit_sphere", "dark", R"({"front": {"link": "picture.image"}, "back": {"link": "other.image"}})");
  add_ball(scene, R"({"diffuse": "lit", "ambient_color": [0, 0, 0]})");
  const Pixels filled = scene.layer("color");
  scene.set("lit.fill_dark", "false");
  scene.set("ball.ambient", "dark");
  EXPECT_LT(largest_difference(filled, scene.layer("color")), tolerance);
}

TEST(LitSphere, FrontAndBackLightHavePicturesOfTheirOwn) {
  const ImagePointer front = waves(64), back = waves(64, 0.7f);
  Scene scene;
  scene.give("first", front);
  scene.give("second", back);
  scene.set("front.direction", json(slanted));
  scene.add("interactor.light", "back", R"({"direction": )" + json(sideways) + "}");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "first.image"}, "back": {"link": "second.image"}, "back_mapping": "equidistant"})");
  add_ball(scene, R"({"diffuse": "lit"})");
  const auto front_part = [&](glm::vec3 n) { return glm::dot(n, slanted) < 0 ? darkest(*front) : bilinear(*front, orthographic(in_light_space(n, slanted))); };
  const auto back_part = [&](glm::vec3 n) { return glm::dot(n, sideways) < 0 ? darkest(*back) : bilinear(*back, equidistant(in_light_space(n, sideways))); };
  expect_everywhere(scene, "diffuse", [&](glm::vec3 n) { return front_part(n) + back_part(n); });
  scene.give("second", nullptr);
  expect_everywhere(scene, "diffuse", front_part);
}

TEST(LitSphere, OneLightDrivesTheHighlight) {
  const ImagePointer spot = waves(64);
  for (const auto& [light, direction] : {std::pair<const char*, glm::vec3>("front", slanted), std::pair<const char*, glm::vec3>("back", sideways)}) {
    Scene scene;
    scene.give("picture", spot);
    scene.set("front.direction", json(slanted));
    scene.add("interactor.light", "back", R"({"direction": )" + json(sideways) + "}");
    scene.add("specular.lit_sphere", "shine", R"({"highlight": {"link": "picture.image"}, "light": ")" + std::string(light) + "\"}");
    add_ball(scene, R"({"specular": "shine"})");
    expect_everywhere(scene, "specular", [&, direction = direction](glm::vec3 n) {
      return glm::dot(n, direction) <= 0 ? glm::vec3(0) : bilinear(*spot, orthographic(in_light_space(n, direction)));
    });
  }
}

TEST(LitSphere, MaterialAndLightCountOnlyWhenAskedFor) {
  const ImagePointer front = waves(64);
  const glm::vec3 material(0.5f, 0.25f, 0.75f), light(0.2f, 0.8f, 1.6f);
  Scene scene;
  scene.give("picture", front);
  scene.set("front.color", "[0.1, 0.4, 0.8]");
  scene.set("front.intensity", "2");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}})");
  scene.add("specular.lit_sphere", "shine", R"({"highlight": {"link": "picture.image"}})");
  add_ball(scene, R"({"diffuse": "lit", "specular": "shine", "diffuse_color": )" + json(material) + R"(, "specular_color": )" + json(material) + "}");
  for (const bool with_material : {false, true})
    for (const bool with_light : {false, true}) {
      for (const char* term : {"lit", "shine"}) {
        scene.set(term + std::string(".use_material"), with_material ? "true" : "false");
        scene.set(term + std::string(".use_light"), with_light ? "true" : "false");
      }
      const glm::vec3 factor = (with_material ? material : glm::vec3(1)) * (with_light ? light : glm::vec3(1));
      for (const char* layer : {"diffuse", "specular"})
        expect_everywhere(scene, layer, [&](glm::vec3 n) { return factor * bilinear(*front, orthographic(n)); });
    }
}

TEST(LitSphere, WithoutPicturesTheMaterialShows) {
  Scene scene({33, 33});
  scene.add("ambient.lit_sphere", "dark");
  scene.add("diffuse.lit_sphere", "lit");
  scene.add("specular.lit_sphere", "shine");
  add_ball(scene, R"({"ambient": "dark", "diffuse": "lit", "specular": "shine", "ambient_color": [0.1, 0.2, 0.3], "diffuse_color": [0.5, 0.25, 1], "specular_color": [0.4, 0.4, 0.2], "shininess": 3})");
  expect_everywhere(scene, "ambient", [](glm::vec3) { return glm::vec3(0.1f, 0.2f, 0.3f); });
  expect_everywhere(scene, "diffuse", [](glm::vec3 n) { return glm::vec3(0.5f, 0.25f, 1) * n.z; });
  expect_everywhere(scene, "specular", [](glm::vec3 n) { return glm::vec3(0.4f, 0.4f, 0.2f) * n.z * n.z * n.z; });
}

TEST(LitSphere, ClearTexelsShowTheDarkColorAndHalfClearOnesTheirOwn) {
  auto clear = std::make_shared<lumen::Image>();
  clear->width = 2;
  clear->height = 1;
  clear->channels = {"R", "G", "B", "A"};
  clear->pixels = std::vector<float>{0.2f, 0.1f, 0.3f, 0.5f, 0, 0, 0, 0};
  clear->finish();
  Scene scene({40, 40});
  scene.give("picture", clear);
  scene.add("diffuse.lit_sphere", "lit", R"({"space": "view", "front": {"link": "picture.image"}, "front_dark": [0, 1, 0]})");
  add_ball(scene, R"({"diffuse": "lit"})");
  const Pixels diffuse = scene.layer("diffuse");
  EXPECT_NEAR(glm::distance(diffuse.rgb(4, 20), glm::vec3(0.4f, 0.2f, 0.6f)), 0, tolerance);
  EXPECT_NEAR(glm::distance(diffuse.rgb(36, 20), glm::vec3(0, 1, 0)), 0, tolerance);
}

/// Every combination of lit spheres and other terms, a bit each for ambient, diffuse and specular.
struct LitSphereBeside : testing::TestWithParam<int> {};

TEST_P(LitSphereBeside, OtherTermsIsWhatItIsAlone) {
  const char* const kinds[] = {"ambient", "diffuse", "specular"};
  const char* const others[] = {"ambient.constant", "diffuse.lambert", "specular.blinn"};
  const ImagePointer shown = waves(32);
  Scene scene({32, 32});
  scene.give("picture", shown);
  scene.set("front.direction", json(slanted));
  std::string style = R"({"ambient_color": [0.1, 0.1, 0.1], "diffuse_color": [0.5, 0.5, 0.5], "specular_color": [0.6, 0.6, 0.6], "shininess": 10)";
  for (int kind = 0; kind < 3; ++kind) {
    const bool lit = (GetParam() >> kind & 1) != 0;
    scene.add(lit ? kinds[kind] + std::string(".lit_sphere") : others[kind], kinds[kind],
              lit ? "{\"" + std::string(kind == 2 ? "highlight" : "front") + R"(": {"link": "picture.image"}})" : "{}");
    style += ", \"" + std::string(kinds[kind]) + "\": \"" + kinds[kind] + "\"";
  }
  add_ball(scene, style + "}");
  const auto looked_up = [&](glm::vec3 n) { return bilinear(*shown, orthographic(in_light_space(n, slanted))); };
  expect_everywhere(scene, "ambient", [&](glm::vec3 n) {
    if ((GetParam() & 1) == 0) return glm::vec3(0.1f);
    return glm::dot(n, slanted) < 0 ? darkest(*shown) : glm::vec3(0);
  });
  expect_everywhere(scene, "diffuse", [&](glm::vec3 n) {
    const float toward = glm::dot(n, slanted);
    if ((GetParam() & 2) == 0) return glm::vec3(0.5f * std::max(0.0f, toward));
    return toward < 0 ? darkest(*shown) : looked_up(n);
  });
  expect_everywhere(scene, "specular", [&](glm::vec3 n) {
    if (glm::dot(n, slanted) <= 0) return glm::vec3(0);
    return (GetParam() & 4) != 0 ? looked_up(n) : glm::vec3(0.6f * std::pow(std::max(0.0f, glm::dot(n, glm::normalize(slanted + glm::vec3(0, 0, 1)))), 10.0f));
  });
}
INSTANTIATE_TEST_SUITE_P(Terms, LitSphereBeside, testing::Range(0, 8));

TEST(LitSphere, ShadesTransparentSurfacesAsOpaqueOnes) {
  Scene scene({48, 48});
  scene.give("picture", waves(64));
  scene.set("front.direction", json(slanted));
  scene.add("ambient.lit_sphere", "dark", R"({"front": {"link": "picture.image"}})");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "picture.image"}, "fill_dark": false})");
  scene.add("specular.lit_sphere", "shine", R"({"highlight": {"link": "picture.image"}})");
  scene.surface("wall", lumen::testing::sphere(64), R"({"ambient": "dark", "diffuse": "lit", "specular": "shine"})");
  const Pixels opaque = scene.layer("color");
  scene.add("opacity.constant", "half", R"({"alpha": 0.5})");
  scene.add("transparency.weighted", "transparency");
  scene.surface("front_half", lumen::testing::moved(*lumen::testing::rectangle(0.5f, 0.5f), {0, 0, 2}), R"({"ambient": "dark", "diffuse": "lit", "specular": "shine", "opacity": "half"})");
  const Pixels transparent = scene.layer("transparent");
  scene.set("front_half.opacity", "null");
  const Pixels rectangle = scene.layer("color");
  EXPECT_NEAR(transparent.rgba(24, 24).a, 0.5f, 1e-3f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(transparent.at(24, 24, c), 0.5f * rectangle.at(24, 24, c), 2e-3f);
  EXPECT_NEAR(glm::distance(rectangle.rgb(12, 24), opaque.rgb(12, 24)), 0, tolerance);
}

TEST(LitSphereImporter, MakesEveryMaterialFiniteAndOfItsOwn) {
  const char* const names[] = {"clay", "skin", "bone", "artery", "vein", "jade", "porcelain", "gold", "chrome", "toon", "x-ray", "blueprint", "soft highlight", "sharp highlight", "window highlight"};
  std::vector<Pixels> seen;
  Scene scene({64, 64});
  scene.add("importer.lit_sphere", "gallery", R"({"size": 64})");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "gallery.image"}})");
  add_ball(scene, R"({"diffuse": "lit"})");
  for (const char* name : names) {
    scene.set("gallery.material", name);
    const Pixels shown = scene.layer("diffuse");
    float largest = 0;
    for (const float number : shown.image().pixels) {
      ASSERT_TRUE(std::isfinite(number) && number >= 0) << name;
      largest = std::max(largest, number);
    }
    EXPECT_GT(largest, 0.3f) << name;
    EXPECT_LT(largest, 4.0f) << name;
    for (const Pixels& other : seen) EXPECT_GT(largest_difference(shown, other), 0.05f) << name;
    seen.push_back(shown);
    EXPECT_TRUE(scene.problems().empty()) << name;
  }
}

TEST(LitSphereImporter, BothMappingsShadeASphereAlike) {
  Scene scene;
  scene.add("importer.lit_sphere", "gallery", R"({"size": 512, "material": "bone"})");
  scene.add("diffuse.lit_sphere", "lit", R"({"front": {"link": "gallery.image"}})");
  scene.set("front.direction", json(slanted));
  add_ball(scene, R"({"diffuse": "lit"})");
  const Pixels rendered = scene.layer("diffuse");
  scene.set("gallery.mapping", "equidistant");
  scene.set("lit.front_mapping", "equidistant");
  const Pixels by_angle = scene.layer("diffuse");
  const Pixels normal = scene.layer("normal");
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const float toward = glm::dot(normal.rgb(x, y), slanted);
      if (toward < 0.1f) continue;  // a rendered sphere's last texel holds many degrees
      ASSERT_NEAR(rendered.at(x, y), by_angle.at(x, y), 6e-3f) << x << ", " << y;
    }
}

}  // namespace
