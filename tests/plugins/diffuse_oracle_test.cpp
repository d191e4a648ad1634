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

}  // namespace
}  // namespace lumen::testing
