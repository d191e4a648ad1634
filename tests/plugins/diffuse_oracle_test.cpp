/// Diffuse terms against their closed forms and integrals, through the program's own path.
#include <numbers>

#include "plugins/term_oracle.h"

namespace lumen::testing {
namespace {

constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();

/// The toon bands; not checked within rounding of a threshold.
Reflectance toon(glm::vec3 thresholds, glm::vec4 levels, bool printed) {
  return [=](const Angles& a) {
    const float d = glm::dot(a.n, a.l);
    for (const float edge : {thresholds.x, thresholds.y, thresholds.z, 0.0f})
      if (std::abs(d - edge) < 1e-5f) return glm::vec3(nowhere);
    const float level = d <= 0 ? 0 : d > thresholds.x ? levels.x : d > thresholds.y ? levels.y : d > thresholds.z ? levels.z : levels.w;
    return diffuse_color * level * (printed ? std::max(d, 0.0f) : 1.0f);
  };
}

const glm::vec3 printed_thresholds(0.95f, 0.5f, 0.25f);
const glm::vec4 printed_levels(0.8f, 0.5f, 0.25f, 0.1f);

TEST(DiffuseToon, BandsAreFlat) {
  expect_closed_form_everywhere("diffuse.toon", toon(printed_thresholds, printed_levels, false), "specular.blinn", blinn_term);
}

TEST(DiffuseToon, BandsKeepGradientsAsPrinted) {
  expect_closed_form_everywhere("diffuse.toon", toon(printed_thresholds, printed_levels, true), "specular.blinn", blinn_term, R"({"as_printed": true})");
}

TEST(DiffuseToon, ThresholdsAndLevelsAreWhatOneSets) {
  expect_closed_form_everywhere("diffuse.toon", toon({0.9f, 0.6f, 0.1f}, {1, 0.7f, 0.4f, 0}, false), "specular.blinn", blinn_term,
                                R"({"thresholds": [0.9, 0.6, 0.1], "levels": [1, 0.7, 0.4, 0]})");
}

TEST(DiffuseToon, LevelsChangeAtTheThresholds) {
  WallProbe wall("diffuse", "diffuse.toon");
  const auto at = [&](float facing) { return wall.reflected({std::sqrt(1 - facing * facing), 0, facing}).x; };
  constexpr float step = 1e-4f;
  for (const auto& [threshold, above, below] : {std::tuple(0.95f, 0.8f, 0.5f), std::tuple(0.5f, 0.5f, 0.25f), std::tuple(0.25f, 0.25f, 0.1f)}) {
    EXPECT_FLOAT_EQ(at(threshold + step), above);
    EXPECT_FLOAT_EQ(at(threshold - step), below);
  }
  EXPECT_FLOAT_EQ(at(1), 0.8f);
  EXPECT_FLOAT_EQ(at(step), 0.1f);
  EXPECT_EQ(at(0), 0);
  wall.set("thresholds", "[1, 0.5, 0.25]");
  EXPECT_FLOAT_EQ(at(1), 0.8f) << "a threshold belongs to the brighter band";
}

Reflectance oren_nayar(float sigma) {
  return [=](const Angles& a) {
    // By angles, as the paper writes it: azimuths from projections onto the tangent plane.
    const float cos_l = std::clamp(glm::dot(a.n, a.l), -1.0f, 1.0f), cos_v = std::clamp(glm::dot(a.n, a.v), 0.0f, 1.0f);
    if (cos_l <= 0) return glm::vec3(0);
    const double theta_l = std::acos(double(cos_l)), theta_v = std::acos(double(cos_v)), square = double(sigma) * sigma;
    const glm::dvec3 n(a.n), flat_l = glm::dvec3(a.l) - double(cos_l) * n, flat_v = glm::dvec3(a.v) - double(cos_v) * n;
    const double lengths = glm::length(flat_l) * glm::length(flat_v), azimuth = lengths > 1e-12 ? glm::dot(flat_l, flat_v) / lengths : 0;
    const double alpha = std::max(theta_l, theta_v), beta = std::min(theta_l, theta_v);
    const double A = 1 - 0.5 * square / (square + 0.33), B = 0.45 * square / (square + 0.09);
    return diffuse_color * float(cos_l * (A + B * std::max(0.0, azimuth) * std::sin(alpha) * std::tan(beta)));
  };
}

TEST(OrenNayar, QualitativeModelIsTheFormulaOfThePaper) {
  expect_closed_form_everywhere("diffuse.oren_nayar", oren_nayar(0.2f), "specular.blinn", blinn_term);
}

TEST(OrenNayar, QualitativeModelIsTheFormulaOfThePaperForRoughSurfaces) {
  expect_closed_form_everywhere("diffuse.oren_nayar", oren_nayar(1), "specular.blinn", blinn_term, R"({"sigma": 1})");
}

TEST(OrenNayar, IsLambertWhenSmooth) {
  expect_closed_form_everywhere("diffuse.oren_nayar", lambert_term, "specular.blinn", blinn_term, R"({"sigma": 0})");
  expect_closed_form_everywhere("diffuse.oren_nayar", lambert_term, "specular.blinn", blinn_term, R"({"model": "energy_preserving", "roughness": 0})");
}

TEST(OrenNayar, HasTheKnownValuesAtFortyFiveDegrees) {
  WallProbe wall("diffuse", "diffuse.oren_nayar", R"({"sigma": 1})");
  EXPECT_NEAR(wall.reflected(turned(45), turned(45)).x, 0.6477f, 1e-4f);
  EXPECT_NEAR(wall.reflected(turned(-45), turned(45)).x, 0.4413f, 1e-4f);
}

TEST(OrenNayar, LightAndEyeCanChangePlaces) {
  const glm::vec3 a = glm::normalize(glm::vec3(0.5f, 0.2f, 0.4f)), b = glm::normalize(glm::vec3(0.3f, -0.1f, 0.9f));
  WallProbe wall("diffuse", "diffuse.oren_nayar", R"({"sigma": 0.7, "roughness": 0.8})");
  for (const char* model : {"qualitative", "energy_preserving"}) {
    wall.set("model", model);
    EXPECT_NEAR(wall.reflected(a, b).x / a.z, wall.reflected(b, a).x / b.z, 1e-5f) << model;
  }
}

void expect_white_furnace(float degrees) {
  LightProbe probe("diffuse", "diffuse.oren_nayar", R"({"model": "energy_preserving"})", turned(degrees), 4, 320);
  for (const char* roughness : {"0", "0.5", "1"}) {
    probe.set("roughness", roughness);
    EXPECT_NEAR(probe.integral() / std::numbers::pi, 1, 1e-3) << degrees << " degrees, roughness " << roughness;
  }
  probe.set("model", "qualitative");
  probe.set("sigma", "1");
  EXPECT_LT(probe.integral() / std::numbers::pi, 0.93) << "the qualitative model loses light";
}

TEST(OrenNayar, EnergyPreservingModelReflectsAllLightFromAWhiteSurface) { expect_white_furnace(0); }
TEST(OrenNayar, EnergyPreservingModelReflectsAllLightSeenFromTheSide) { expect_white_furnace(60); }

TEST(OrenNayar, EnergyPreservingModelSaturatesColorsByItsSecondBounce) {
  // Lit and seen along the normal, where the paper's directional albedo is A: g(1) = 0.
  constexpr double pi = std::numbers::pi, r = 0.6, A = 1 / (1 + (0.5 - 2 / (3 * pi)) * r), mean = A + (2.0 / 3 - 28 / (15 * pi)) * r * A;
  WallProbe wall("diffuse", "diffuse.oren_nayar", R"({"model": "energy_preserving", "roughness": 0.6})", R"("diffuse_color": [0.9, 0.4, 0.1])");
  const glm::vec3 value = wall.reflected({0, 0, 1});
  const double albedo[] = {0.9, 0.4, 0.1};
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(value[c], albedo[c] * A + albedo[c] * albedo[c] * mean / (1 - albedo[c] * (1 - mean)) * (1 - A) * (1 - A) / (1 - mean), 1e-5);
}

TEST(Gooch, BlendsFromCoolToWarmWithTheAngleToTheLight) {
  expect_closed_form_everywhere("diffuse.gooch", [](const Angles& a) {
    const float warm = (1 + glm::dot(a.n, a.l)) / 2;
    return warm * (glm::vec3(0.4f, 0.4f, 0) + 0.6f * diffuse_color) + (1 - warm) * (glm::vec3(0, 0, 0.4f) + 0.2f * diffuse_color);
  }, "specular.blinn", blinn_term);
}

TEST(Gooch, TonesAndSharesAreWhatOneSets) {
  WallProbe wall("diffuse", "diffuse.gooch", R"({"cool": [0.1, 0.2, 0.3], "warm": [0.3, 0.2, 0], "alpha": 0.5, "beta": 0.25})", R"("diffuse_color": [0.4, 0.8, 0.2])");
  const glm::vec3 warm = wall.reflected({0, 0, 1}), cool = wall.reflected({0, 0, -1});
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(warm[c], glm::vec3(0.4f, 0.4f, 0.05f)[c], 1e-5f);
    EXPECT_NEAR(cool[c], glm::vec3(0.3f, 0.6f, 0.4f)[c], 1e-5f);
  }
}

/// Detail from nothing to full as light from 0 to 1, whatever the tone.
const std::string detail_as_light = R"("fine": {"range": [0, 1], "points": [[0, 1, 1, 1, 1], [1, 1, 1, 1, 1]]}, "coarse": {"range": [0, 1], "points": [[0, 0, 0, 0, 1], [1, 0, 0, 0, 1]]})";

TEST(XToon, DetailFadesTowardSilhouettes) {
  expect_closed_form_everywhere("diffuse.x_toon", [](const Angles& a) { return diffuse_color * std::pow(std::clamp(glm::dot(a.n, a.v), 0.0f, 1.0f), 0.7f); },
                                "specular.blinn", blinn_term, R"({"detail": "silhouette", "power": 0.7, )" + detail_as_light + "}");
}

TEST(XToon, DetailFadesAwayFromHighlights) {
  expect_closed_form_everywhere("diffuse.x_toon", [](const Angles& a) {
    return diffuse_color * std::pow(std::clamp(glm::dot(2 * glm::dot(a.n, a.l) * a.n - a.l, a.v), 0.0f, 1.0f), 3.0f);
  }, "specular.blinn", blinn_term, R"({"detail": "highlight", "power": 3, )" + detail_as_light + "}");
}

TEST(XToon, TonesAreReadFromBothFunctions) {
  // Linear in N.L from -1 to 1, other colors at each end, so that a 1024-texel table holds them exactly.
  const std::string maps = R"("fine": {"range": [-1, 1], "points": [[-1, 0, 0.2, 1, 1], [1, 1, 0.4, 0, 1]]}, "coarse": {"range": [-1, 1], "points": [[-1, 0.5, 0, 0, 1], [1, 0.7, 1, 0, 1]]})";
  expect_closed_form_everywhere("diffuse.x_toon", [](const Angles& a) {
    const float tone = (1 + glm::dot(a.n, a.l)) / 2, detail = glm::dot(a.n, a.v);
    const glm::vec3 fine = glm::mix(glm::vec3(0, 0.2f, 1), glm::vec3(1, 0.4f, 0), tone), coarse = glm::mix(glm::vec3(0.5f, 0, 0), glm::vec3(0.7f, 1, 0), tone);
    return diffuse_color * glm::mix(coarse, fine, detail);
  }, "specular.blinn", blinn_term, R"({"detail": "silhouette", )" + maps + "}");
}

TEST(XToon, DetailFadesWithTheLogarithmOfDistance) {
  for (const bool perspective : {true, false}) {
    Scene scene({48, 48});
    add_ball(scene, "diffuse.x_toon", "specular.blinn", "{" + detail_as_light + R"(, "nearest": 0.25, "farthest": 0.6})");
    scene.set("camera.distance", "3");
    if (perspective) look_from_near(scene, 3);
    const Pixels depth = scene.layer("depth"), diffuse = scene.layer("diffuse");
    const double radius = std::sqrt(3.0), first = 3 - radius + 0.25 * 2 * radius, last = 3 - radius + 0.6 * 2 * radius;
    int between = 0;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const double z = depth.at(x, y);
        if (std::isinf(z)) continue;
        const double passed = perspective ? std::log(z / first) / std::log(last / first) : (z - first) / (last - first);
        const double detail = 1 - std::clamp(passed, 0.0, 1.0);
        between += detail > 0 && detail < 1;
        ASSERT_NEAR(diffuse.at(x, y), diffuse_color.x * detail, 1e-4) << x << ", " << y;
      }
    EXPECT_GT(between, 300);
  }
}

TEST(XToon, FallsInBandsByItself) {
  WallProbe wall("diffuse", "diffuse.x_toon", R"({"detail": "silhouette"})");
  const auto at = [&](float tone) { return wall.reflected({std::sqrt(1 - tone * tone), 0, tone}).x; };
  EXPECT_NEAR(at(0.98f), 1, 1e-5f);
  EXPECT_NEAR(at(0.9f), 0.8f, 1e-5f);
  EXPECT_NEAR(at(0.7f), 0.8f, 1e-5f);
  EXPECT_NEAR(at(0.45f), 0.5f, 1e-5f);
  EXPECT_NEAR(at(0.2f), 0.25f, 1e-5f);
  EXPECT_NEAR(at(0.02f), 0.08f, 1e-5f);
}

/// Diffusion around a ring as a Fourier series: each harmonic of max(0, cos) damped by 1 + n^2 s^2.
double ring(double s, double angle) {
  double sum = 1 / std::numbers::pi + std::cos(angle) / (2 * (1 + s * s)), sign = 1;
  for (int k = 1; k <= 400; ++k, sign = -sign) sum += 2 / std::numbers::pi * sign * std::cos(2 * k * angle) / ((4.0 * k * k - 1) * (1 + 4.0 * k * k * s * s));
  return sum;
}

TEST(Subsurface, IsLambertWithoutWidth) {
  expect_closed_form_everywhere("diffuse.subsurface", lambert_term, "specular.blinn", blinn_term, R"({"width": 0, "through": 0})");
}

TEST(Subsurface, DiffusesAsTheFourierSeriesOfARing) {
  WallProbe wall("diffuse", "diffuse.subsurface", R"({"through": 0, "spread": [1, 0.5, 0.1]})");
  for (const double width : {0.3, 1.0, 3.0}) {
    wall.set("width", std::to_string(width));
    for (int degrees = 0; degrees <= 180; degrees += 9) {
      const glm::vec3 value = wall.reflected(turned(float(degrees)));
      const double angle = degrees * std::numbers::pi / 180;
      EXPECT_NEAR(value.r, ring(width, angle), term_tolerance) << width << ", " << degrees << " degrees";
      EXPECT_NEAR(value.g, ring(width * 0.5, angle), term_tolerance) << width << ", " << degrees << " degrees";
      EXPECT_NEAR(value.b, ring(width * 0.1, angle), term_tolerance) << width << ", " << degrees << " degrees";
    }
  }
}

TEST(Subsurface, KeepsTheLightOfTheRingAndReddensTheTerminator) {
  WallProbe wall("diffuse", "diffuse.subsurface", R"({"through": 0})");
  glm::dvec3 sum(0);
  constexpr int steps = 180;
  for (int i = 0; i < steps; ++i) sum += glm::dvec3(wall.reflected(turned(360.0f * (float(i) + 0.5f) / steps)));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / steps, 1 / std::numbers::pi, 1e-4);
  const glm::vec3 terminator = wall.reflected(turned(92));
  EXPECT_GT(terminator.r, 1.5f * terminator.g);
  EXPECT_GT(terminator.g, 1.5f * terminator.b);
}

TEST(Subsurface, LightFromBehindShinesThrough) {
  Scene scene({40, 40});
  add_ball(scene, "diffuse.subsurface", "specular.blinn", R"({"width": 0, "through": 0.5, "distortion": 0.4, "sharpness": 3, "spread": [1, 0.6, 0.2]})");
  look_from_near(scene);
  for (const glm::vec3 toward : {glm::normalize(glm::vec3(0.2f, 0.1f, -1)), glm::vec3(1, 0, 0), slanted}) {
    scene.set("front.direction", json(toward));
    expect_closed_form(scene, {{.direction = toward}}, [](const Angles& a) {
      const float straight = std::max(0.0f, -glm::dot(a.v, glm::normalize(a.l + 0.4f * a.n)));
      return lambert_term(a) + diffuse_color * glm::vec3(1, 0.6f, 0.2f) * 0.5f * straight * straight * straight;
    }, blinn_term);
  }
}

}  // namespace
}  // namespace lumen::testing
