/// Compositors against closed forms: lines, fog, depth of field and unsharp masking, on flat scenes of known depth.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <lumen/image.h>
#include <lumen/testing.h>

namespace {

using lumen::Value;
using lumen::testing::moved;
using lumen::testing::Pixels;
using lumen::testing::rectangle;
using lumen::testing::Scene;

/// Shown in exactly this color.
void flat(Scene& scene, const std::string& id, std::shared_ptr<const lumen::Mesh> mesh, glm::vec3 color = glm::vec3(1)) {
  if (scene.value("main.renderers") == Value(lumen::References{})) scene.add("ambient.constant", "ambient");
  scene.surface(id, std::move(mesh), R"({"ambient": "ambient"})");
  scene.set_value(id + ".ambient_color", Value(lumen::Color(color)));
}

/// Scene depth of z = `depth` when the scene's bounds are about the origin, 10 in front of the eye.
float scene_depth(float depth, float radius) { return (depth - (10 - radius)) / (2 * radius); }

// --- silhouettes: a square whose edges lie between pixels 15 and 16 and between 47 and 48 of 64.

void white_behind(Scene& scene) {
  scene.add("compositor.background", "white", R"({"mode": "color", "color": [1, 1, 1]})");
}

TEST(Silhouettes, LinesAreAsWideAsAskedForAndCenteredOnTheEdge) {
  const Scene shared;  // the driver's context stays from scene to scene
  for (const float width : {0.5f, 1.0f, 2.0f, 3.0f, 7.0f}) {
    Scene scene({64, 64});
    flat(scene, "square", rectangle(1.1f, 1.1f));
    white_behind(scene);
    scene.add("compositor.silhouettes", "lines");
    scene.set_value("lines.width", Value(width));
    const Pixels picture = scene.picture();
    double sum = 0, moment = 0;
    for (int x = 6; x < 26; ++x) {
      const double line = 1 - picture.at(x, 32);
      sum += line;
      moment += line * (x + 0.5);
    }
    // Half a pixel is the least that an edge between pixel centers can be told apart from: narrower lines fade.
    EXPECT_NEAR(sum, width >= 1 ? width : 2 * 0.25, 0.02) << width;
    EXPECT_NEAR(moment / sum, 16, 0.01) << width;
    EXPECT_TRUE(scene.problems().empty());
  }
}

TEST(Silhouettes, ATiltedPlaneHasNoLinesInIt) {
  const Scene shared;
  for (const float degrees : {30.0f, 70.0f, 85.0f}) {
    for (const char* projection : {"orthographic", "perspective"}) {
      Scene scene({64, 64});
      scene.set("camera.projection", projection);
      scene.set("camera.field_of_view", "12");
      flat(scene, "plane", rectangle(1.2f, 30), {1, 1, 1});
      scene.set_value("plane.transform", Value(glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(1, 0, 0))));
      white_behind(scene);
      scene.add("compositor.silhouettes", "lines", R"({"creases": true, "step": 0.001, "angle": 5})");
      const Pixels depth = scene.layer("depth"), picture = scene.picture();
      int inside = 0;
      for (int y = 3; y < 61; ++y)
        for (int x = 24; x < 40; ++x) {
          bool covered = true;
          for (int i = -3; i <= 3; ++i)
            for (int j = -3; j <= 3; ++j) covered = covered && std::isfinite(depth.at(x + j, y + i));
          if (!covered) continue;
          ++inside;
          EXPECT_EQ(picture.at(x, y), 1) << degrees << projection << x << " " << y;
        }
      EXPECT_GT(inside, 20) << degrees;
    }
  }
}

TEST(Silhouettes, StepsBelowTheThresholdAreNoEdges) {
  Scene scene({64, 64});
  flat(scene, "wall", rectangle(4, 4));
  flat(scene, "step", moved(*rectangle(1.1f, 1.1f), {0, 0, 0.2f}));
  white_behind(scene);
  scene.add("compositor.silhouettes", "lines", R"({"width": 2})");
  const float radii = 0.2f / (0.5f * std::sqrt(32.04f));
  scene.set_value("lines.step", Value(radii * 0.95f));
  EXPECT_LT(scene.picture().at(16, 32), 0.5f);
  scene.set_value("lines.step", Value(radii * 1.05f));
  EXPECT_EQ(scene.picture().at(16, 32), 1);
}

TEST(Silhouettes, CreasesAreLinesOnlyWhenAskedForAndBeyondTheAngle) {
  Scene scene({64, 64});
  flat(scene, "box", lumen::testing::box(glm::vec3(1)));
  scene.set_value("box.transform", Value(glm::rotate(glm::mat4(1), glm::radians(45.0f), glm::vec3(0, 1, 0))));
  white_behind(scene);
  scene.add("compositor.silhouettes", "lines", R"({"width": 2, "angle": 85})");
  EXPECT_EQ(scene.picture().at(32, 32), 1);
  scene.set("lines.creases", "true");
  EXPECT_LT(scene.picture().at(32, 32), 0.5f);
  scene.set("lines.angle", "95");
  EXPECT_EQ(scene.picture().at(32, 32), 1) << "its faces meet at 90 degrees";
}

TEST(Silhouettes, ASphereHasARimAndNothingElse) {
  Scene scene({128, 128});
  flat(scene, "ball", lumen::testing::sphere(128, 0.9f));
  white_behind(scene);
  scene.add("compositor.silhouettes", "lines", R"({"width": 2})");
  const Pixels picture = scene.picture();
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const float from_rim = std::abs(std::hypot(float(x) - 63.5f, float(y) - 63.5f) - 0.9f / 2.2f * 128);
      if (from_rim > 3) { EXPECT_EQ(picture.at(x, y), 1) << x << " " << y; }
      if (from_rim < 0.25f) { EXPECT_LT(picture.at(x, y), 0.5f) << x << " " << y; }
    }
}

// --- fog: squares 1 in front of and 1 behind the middle.

constexpr float fog_radius = 1.40357f;  // of the bounds 1.8 x 0.8 x 2

struct TwoDepths : Scene {
  TwoDepths() : Scene({64, 64}) {
    flat(*this, "near", moved(*rectangle(0.8f, 0.8f), {-0.5f, 0, 1}), {0.8f, 0.4f, 0.2f});
    flat(*this, "far", moved(*rectangle(0.8f, 0.8f), {0.5f, 0, -1}), {0.8f, 0.4f, 0.2f});
  }
};

TEST(Fog, FollowsItsThreeCurvesOfSceneDepth) {
  const float depths[] = {scene_depth(9, fog_radius), scene_depth(11, fog_radius)};
  const Scene shared;
  for (const char* mode : {"linear", "exponential", "exponential_squared"}) {
    TwoDepths scene;
    scene.add("compositor.fog", "fog", R"({"color": [0.1, 0.2, 1], "start": 0.1, "end": 0.9, "density": 1.5})");
    scene.set("fog.mode", mode);
    const Pixels picture = scene.picture();
    for (int side = 0; side < 2; ++side) {
      const float behind = depths[side] - 0.1f, thick = 1.5f * behind;
      const float fog = mode == std::string("linear") ? behind / 0.8f : mode == std::string("exponential") ? 1 - std::exp(-thick) : 1 - std::exp(-thick * thick);
      const glm::vec3 expected = glm::mix(glm::vec3(0.8f, 0.4f, 0.2f), glm::vec3(0.1f, 0.2f, 1), fog), found = picture.rgb(side == 0 ? 17 : 46, 32);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-3f) << mode << side << c;
      EXPECT_EQ(picture.rgba(side == 0 ? 17 : 46, 32).a, 1);
    }
    EXPECT_EQ(picture.rgba(32, 4), glm::vec4(0)) << "what is clear stays clear";
  }
}

TEST(Fog, ThePictureBehindTheSceneIsFogOnlyWhenAskedFor) {
  TwoDepths scene;
  scene.add("compositor.background", "behind", R"({"mode": "color", "color": [0.25, 0.5, 0.75]})");
  scene.add("compositor.fog", "fog", R"({"color": [1, 0, 0]})");
  EXPECT_EQ(scene.picture().rgb(32, 4), glm::vec3(0.25f, 0.5f, 0.75f));
  scene.set("fog.background", "true");
  EXPECT_EQ(scene.picture().rgb(32, 4), glm::vec3(1, 0, 0));
}

TEST(Fog, WhatIsBehindATransparentSurfaceFadesAndTheSurfaceDoesNot) {
  TwoDepths scene;
  scene.add("opacity.constant", "half", R"({"alpha": 0.5})");
  scene.add("transparency.weighted", "weighted");
  flat(scene, "pane", moved(*rectangle(0.8f, 0.8f), {0.5f, 0, 0.5f}), {0, 1, 0});
  scene.set("pane.opacity", "half");
  const glm::vec3 before = scene.picture().rgb(46, 32);
  scene.add("compositor.fog", "fog", R"({"color": [0, 0, 1], "start": 0.1, "end": 0.9})");
  const float fog = (scene_depth(11, fog_radius) - 0.1f) / 0.8f;
  const glm::vec3 behind = 0.5f * glm::vec3(0.8f, 0.4f, 0.2f), expected = before + fog * (0.5f * glm::vec3(0, 0, 1) - behind), found = scene.picture().rgb(46, 32);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 2e-3f) << c;
}

TEST(Fog, RimsOfAnAntialiasedSceneFadeAsTheirSurface) {
  Scene scene({64, 64});
  scene.set("main.antialiasing", "16");
  flat(scene, "near", rectangle(0.98f, 0.98f), {1, 1, 1});
  flat(scene, "corner", moved(*rectangle(0.01f, 0.01f), {-1, -1, 2}));
  scene.add("compositor.fog", "fog", R"({"color": [0, 0, 0], "start": -1, "end": 2})");
  const Pixels picture = scene.picture();
  const glm::vec4 inside = picture.rgba(32, 32);
  int rims = 0;
  for (int x = 0; x < 64; ++x) {
    const glm::vec4 pixel = picture.rgba(x, 32);
    if (pixel.a < 0.1f || pixel.a > 0.9f) continue;
    ++rims;
    EXPECT_NEAR(pixel.r / pixel.a, inside.r, 2e-3f) << x;
  }
  EXPECT_EQ(rims, 2);
}

// --- depth of field: a perspective camera 10 from its pivot, 30 degrees high.

constexpr float pixels_at_1 = 128 / (2 * 0.26794919f);

struct Lens : Scene {
  explicit Lens(std::string_view properties) : Scene({128, 128}) {
    set("camera.projection", "perspective");
    set("camera.field_of_view", "30");
    add("compositor.depth_of_field", "lens", properties);
  }
};

/// How much there is in the right half of a picture, and its variances.
struct Spread {
  double sum = 0, x = 0, y = 0;
};
Spread spread_of(const Pixels& picture) {
  double sum = 0, x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (int y = 34; y < 94; ++y)
    for (int x = 66; x < 128; ++x) {
      const double a = picture.rgba(x, y).a;
      sum += a, x1 += a * x, x2 += a * x * x, y1 += a * y, y2 += a * y * y;
    }
  return {sum, x2 / sum - x1 / sum * x1 / sum, y2 / sum - y1 / sum * y1 / sum};
}

TEST(DepthOfField, APointSpreadsOverItsCircleOfConfusion) {
  Lens scene(R"({"aperture": 0.5, "samples": 256})");
  // Far bounds make the scene's radius known: the box -1.5 .. 1.5, -0.1 .. 0.1, -5 .. 5.
  flat(scene, "sharp", moved(*rectangle(0.2f, 0.2f), {-1.4f, 0, 0}));
  flat(scene, "blurred", moved(*rectangle(0.2f, 0.2f), {1.4f, 0, -5}));
  flat(scene, "bound", moved(*rectangle(0.002f, 0.002f), {-1.4f, 0, 5}), {0, 0, 0});
  const float radius = 0.5f * std::sqrt(9 + 0.04f + 100);
  const float circle = 0.5f * radius * (15 - 10) / (15.0f * 10) * pixels_at_1;  // A |z - zf| / (z zf), f cancels: diameter
  scene.set("lens.enabled", "false");
  const Spread sharp = spread_of(scene.picture());
  scene.set("lens.enabled", "true");
  const Spread blurred = spread_of(scene.picture());
  const double disc = circle * circle / 16;  // variance along an axis
  EXPECT_NEAR(blurred.sum, sharp.sum, 0.1 * sharp.sum) << "it spreads, no more";
  EXPECT_NEAR(blurred.x, sharp.x + disc, 0.1 * disc) << "radius " << circle / 2;
  EXPECT_NEAR(blurred.y, sharp.y + disc, 0.1 * disc);
}

TEST(DepthOfField, WhatIsInFocusStaysSharpBeforeABlurredGround) {
  Lens scene(R"({"aperture": 0.5})");
  flat(scene, "sharp", rectangle(1, 1), {1, 0, 0});
  flat(scene, "ground", moved(*rectangle(30, 30), {0, 0, -5}), {0, 0, 1});
  scene.set("lens.enabled", "false");
  const Pixels pinhole = scene.picture();
  scene.set("lens.enabled", "true");
  EXPECT_LT(lumen::testing::largest_difference(pinhole, scene.picture()), 1e-3f);
}

TEST(DepthOfField, ABlurredEdgeOverASharpGroundIsTheDiscsIntegral) {
  Lens scene(R"({"aperture": 0.3, "samples": 256})");
  flat(scene, "ground", rectangle(8, 8), {0, 0, 1});
  flat(scene, "edge", moved(*rectangle(6, 8), {3, 0, 2}), {1, 0, 0});  // its edge at x = 0, the picture's middle
  const float radius = 0.5f * std::sqrt(10 * 10 + 8 * 8 + 4.0f);
  const float reach = 0.5f * 0.3f * radius * (10 - 8) / (10.0f * 8) * pixels_at_1;
  ASSERT_GT(reach, 3);
  const Pixels picture = scene.picture();
  for (int x = 40; x < 88; ++x) {
    const float at = std::clamp((float(x) + 0.5f - 64) / reach, -1.0f, 1.0f);
    const float covered = 0.5f + (at * std::sqrt(1 - at * at) + std::asin(at)) / float(M_PI);
    EXPECT_NEAR(picture.at(x, 64), covered, 0.06f) << x;
    EXPECT_NEAR(picture.at(x, 64) + picture.at(x, 64, 2), 1, 2e-3f) << "nothing else shows";
  }
}

TEST(DepthOfField, TheFocusIsThePivotAPlaceOrADistance) {
  Lens scene(R"({"aperture": 1})");
  flat(scene, "near", moved(*rectangle(0.5f, 0.5f), {-0.7f, 0, 0}));
  flat(scene, "far", moved(*rectangle(0.5f, 0.5f), {0.7f, 0, -4}));
  const Pixels depth = scene.layer("depth");
  const auto sharp = [&](float z) {
    const Pixels picture = scene.picture();
    for (int x = 0; x < 128; ++x)
      if (std::isfinite(depth.at(x, 64)) && std::abs(depth.at(x, 64) - z) < 0.1f && picture.rgba(x, 64).a < 0.999f) return false;
    return true;
  };
  EXPECT_TRUE(sharp(10));
  EXPECT_FALSE(sharp(14));
  scene.set("lens.focus", "place");
  scene.set("lens.place", "[0.593, 0.5]");
  EXPECT_TRUE(sharp(14));
  EXPECT_FALSE(sharp(10));
  scene.set("lens.focus", "distance");
  scene.set("lens.distance", "10");
  EXPECT_TRUE(sharp(10));
  scene.set("lens.distance", "14");
  EXPECT_TRUE(sharp(14));
  scene.set("lens.focus", "pivot");
  scene.set("camera.pivot", "[0, 0, -4]");
  scene.set("camera.distance", "14");  // the same view from the same place, turned about another point
  EXPECT_TRUE(sharp(14));
}

TEST(DepthOfField, ATransparentSurfaceStaysSharpOverWhatIsBlurredBehindIt) {
  Lens scene(R"({"aperture": 0.2})");
  scene.add("opacity.constant", "half", R"({"alpha": 0.5})");
  scene.add("transparency.weighted", "weighted");
  flat(scene, "pane", moved(*rectangle(2, 1), {0, 0, -2}), {1, 0, 0});
  flat(scene, "bar", moved(*rectangle(0.3f, 6), {0, 0, -5}), {0, 0, 1});
  scene.set("pane.opacity", "half");
  const Pixels picture = scene.picture();
  const Pixels opacity = scene.layer("opacity");
  float blurred = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const bool behind_pane = opacity.at(x, y) > 0;
      EXPECT_NEAR(picture.at(x, y), behind_pane ? 0.5f : 0.0f, 2e-3f) << "red is the pane's alone at " << x << " " << y;
      // Away from the pane's rim the bar has the same profile in front of it and behind it, half as strong there.
      if (behind_pane) { EXPECT_NEAR(picture.at(x, y, 2), 0.5f * picture.at(x, 40, 2), 0.02f) << x << " " << y; }
      const float blue = picture.at(x, 40, 2);
      blurred += blue > 0.1f && blue < 0.9f ? 1 : 0;
    }
  EXPECT_GT(blurred, 3 * 128);
}

TEST(DepthOfField, TheGroundBehindTheSceneBlursOnlyWhenAskedFor) {
  auto stripe = std::make_shared<lumen::Image>();
  stripe->width = 128, stripe->height = 1, stripe->channels = {"R", "G", "B"};
  std::vector<float> pixels(128 * 3, 0.0f);
  for (int x = 64; x < 128; ++x) pixels[std::size_t(x) * 3] = pixels[std::size_t(x) * 3 + 1] = pixels[std::size_t(x) * 3 + 2] = 1;
  stripe->pixels = pixels;
  stripe->finish();
  Scene scene({128, 128});
  scene.give("stripe", stripe);
  scene.add("compositor.background", "behind", R"({"mode": "image", "fit": "stretch", "image": {"link": "stripe.image"}})");
  scene.add("compositor.depth_of_field", "lens");
  flat(scene, "ball", moved(*lumen::testing::sphere(32, 0.1f), {-0.9f, 0.9f, 0}));
  EXPECT_EQ(scene.picture().at(63, 64), 0);
  EXPECT_EQ(scene.picture().at(64, 64), 1);
  scene.set("lens.background", "true");
  EXPECT_NEAR(scene.picture().at(63, 64), 0.5f, 0.08f);
  EXPECT_NEAR(scene.picture().at(64, 64), 0.5f, 0.08f);
}

// --- depth unsharp masking: a step of depth at the picture's middle.

TEST(DepthUnsharp, AStepMakesTheGaussiansIntegral) {
  const Scene shared;
  for (const float deviation : {3.0f, 13.0f}) {  // pixels; the second on a coarser raster
    Scene scene({192, 64});
    flat(scene, "near", moved(*rectangle(4, 4), {-2, 0, 0.5f}), glm::vec3(0.5f));
    flat(scene, "far", moved(*rectangle(4, 4), {2, 0, -0.5f}), glm::vec3(0.5f));
    const float radius = 0.5f * std::sqrt(64 + 16 + 1.0f), low = scene_depth(9.5f, radius), high = scene_depth(10.5f, radius);
    scene.add("compositor.depth_unsharp", "halos", R"({"strength": 4})");
    scene.set_value("halos.radius", Value(deviation / std::sqrt(192.0f * 192 + 64 * 64)));
    const Pixels picture = scene.picture();
    for (int x = 45; x < 147; ++x) {
      const float at = float(x) + 0.5f - 96, smooth = low + (high - low) * 0.5f * (1 + std::erf(at / (deviation * std::sqrt(2.0f))));
      const float change = 4 * (smooth - (at < 0 ? low : high));
      EXPECT_NEAR(picture.at(x, 32), 0.5f + change, 0.02f * 4 * (high - low)) << deviation << " " << x;
    }
    scene.set("halos.halos", "dark");
    EXPECT_NEAR(scene.picture().at(95, 32), 0.5f, 1e-3f);
    EXPECT_LT(scene.picture().at(96, 32), 0.45f);
    scene.set("halos.halos", "bright");
    EXPECT_GT(scene.picture().at(95, 32), 0.55f);
    EXPECT_NEAR(scene.picture().at(96, 32), 0.5f, 1e-3f);
  }
}

TEST(DepthUnsharp, ATiltedPlaneKeepsItsColor) {
  Scene scene({64, 64});
  flat(scene, "plane", rectangle(20, 20), glm::vec3(0.5f));
  scene.set_value("plane.transform", Value(glm::rotate(glm::mat4(1), glm::radians(40.0f), glm::vec3(1, 1, 0))));
  scene.add("compositor.depth_unsharp", "halos", R"({"strength": 10, "radius": 0.05})");
  const Pixels picture = scene.picture();
  for (int y = 20; y < 44; ++y)
    for (int x = 20; x < 44; ++x) EXPECT_NEAR(picture.at(x, y), 0.5f, 2e-3f);
}

// --- halos: a square 0.2 in front of a wall, its edges between pixels 15 and 16 and between 47 and 48 of 64.

TEST(Halos, AreAsWideAsTheDepthBehindTheEdgeSaysAndOnlyThere) {
  const Scene shared;
  for (const float part : {0.25f, 0.5f, 1.0f, 3.0f}) {  // of the depth of the widest halo
    Scene scene({64, 64});
    flat(scene, "wall", rectangle(4, 4), glm::vec3(0));
    flat(scene, "square", moved(*rectangle(1.1f, 1.1f), {0, 0, 0.2f}), glm::vec3(0));
    scene.add("compositor.halos", "halos", R"({"width": 8})");
    scene.set_value("halos.full", Value(0.2f / part / (0.5f * std::sqrt(32.04f))));
    const Pixels picture = scene.picture();
    double left = 0, right = 0, above = 0;
    for (int i = 0; i < 16; ++i) left += picture.at(i, 32), right += picture.at(63 - i, 32), above += picture.at(32, i);
    const double expected = 8 * std::min(part, 1.0f);
    EXPECT_NEAR(left, expected, 0.05) << part;
    EXPECT_NEAR(right, expected, 0.05) << part;
    EXPECT_NEAR(above, expected, 0.05) << part;
    for (int y = 16; y < 48; ++y)
      for (int x = 16; x < 48; ++x) EXPECT_EQ(picture.at(x, y), 0) << "none on what is in front";
  }
}

TEST(Halos, SlopesAndConvexSurfacesHaveNone) {
  const Scene shared;
  for (const float degrees : {20.0f, 80.0f}) {
    Scene scene({64, 64});
    flat(scene, "plane", rectangle(30, 30), glm::vec3(0));
    scene.set_value("plane.transform", Value(glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(1, 0.4f, 0))));
    scene.add("compositor.halos", "halos", R"({"width": 10, "full": 0.01})");
    const Pixels picture = scene.picture();
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) ASSERT_LT(picture.at(x, y), 0.01f) << degrees << " " << x << " " << y;
  }
  Scene scene({64, 64});
  flat(scene, "ball", lumen::testing::sphere(128, 0.8f), glm::vec3(0));
  scene.add("compositor.halos", "halos", R"({"width": 10, "full": 0.05})");
  const Pixels picture = scene.picture();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_LT(picture.at(x, y), 0.05f) << x << " " << y;
  scene.set("halos.background", "true");
  EXPECT_EQ(scene.picture().rgba(32 - 27, 32), glm::vec4(1)) << "the rim is 23.3 from the middle";
}

}  // namespace
