/// Specular terms against their closed forms and integrals, through the program's own path.
#include <numbers>

#include "plugins/term_oracle.h"

namespace lumen::testing {
namespace {

constexpr double pi = std::numbers::pi;

TEST(SpecularToon, IsFullAboveTheThresholdAndNothingBelow) {
  for (const float threshold : {0.99f, 0.8f}) {
    const Reflectance toon = [=](const Angles& a) {
      const float facing = glm::dot(a.n, a.halfway());
      if (std::abs(facing - threshold) < 1e-5f) return glm::vec3(std::numeric_limits<float>::quiet_NaN());
      return facing > threshold ? specular_color : glm::vec3(0);
    };
    expect_closed_form_everywhere("diffuse.lambert", lambert_term, "specular.toon", toon, "{}", R"({"threshold": )" + std::to_string(threshold) + "}");
  }
}

struct CookTorrance {
  double a = 0.2, f = 1.0 / 9;
  bool correlated = false, printed = false;

  double root(double x) const { return std::sqrt(a * a + (1 - a * a) * x * x); }
  double g1(double x) const { return 2 * x / (x + root(x)); }
  double fresnel(double facing) const { return f + (1 - f) * std::pow(1 - facing, 5); }
  double value(const Angles& angles) const {
    const glm::dvec3 n = glm::normalize(glm::dvec3(angles.n)), l(angles.l), v(angles.v), h = glm::normalize(l + v);
    const double nl = glm::dot(n, l), nv = glm::dot(n, v), nh = glm::dot(n, h), spread = nh * nh * (a * a - 1) + 1;
    const double d = a * a / (pi * spread * spread), common = fresnel(glm::dot(h, v)) * d;
    if (printed) return common * g1(nl) * g1(nv) / (pi * nl * nv);
    const double g = correlated ? 2 * nl * nv / (nl * root(nv) + nv * root(nl)) : g1(nl) * g1(nv);
    return common * g / (4 * nv);
  }
  operator Reflectance() const {
    return [self = *this](const Angles& a) { return specular_color * (glm::dot(a.n, a.v) > 1e-4f ? float(self.value(a)) : std::numeric_limits<float>::quiet_NaN()); };
  }
};

void expect_cook_torrance(const CookTorrance& formula, const char* properties) {
  expect_closed_form_everywhere("diffuse.lambert", lambert_term, "specular.cook_torrance", formula, "{}", properties);
}

TEST(CookTorrance, IsTheFormula) { expect_cook_torrance({}, "{}"); }
TEST(CookTorrance, TakesTheSquareOfItsRoughness) { expect_cook_torrance({.a = 0.25}, R"({"sigma": 0.5, "squared": true})"); }
TEST(CookTorrance, MasksWithCorrelatedHeights) {
  expect_cook_torrance({.a = 0.5, .f = 0.04, .correlated = true}, R"({"sigma": 0.5, "n2": 1.5, "masking": "correlated"})");
}
TEST(CookTorrance, IsTheFormulaAsPrinted) { expect_cook_torrance({.printed = true}, R"({"as_printed": true})"); }

/// F = 1: a mirror's refractive index.
constexpr const char* mirror = R"({"n2": 1000000})";

TEST(CookTorrance, FacetsCoverTheSurface) {
  // Light from the eye: H = V, so each pixel of a sphere is a direction of facets, and its area their projected solid angle.
  for (const double sigma : {0.2, 0.5}) {
    Scene scene({220, 220});
    scene.surface("ball", sphere(512), R"({"specular": "term", "specular_color": [1, 1, 1]})");
    scene.add("specular.cook_torrance", "term", mirror);
    scene.set("term.sigma", std::to_string(sigma));
    const Pixels specular = scene.layer("specular"), normal = scene.layer("normal");
    const CookTorrance formula{.a = sigma};
    double sum = 0;
    for (int y = 0; y < 220; ++y)
      for (int x = 0; x < 220; ++x)
        if (const double facing = normal.at(x, y, 2); facing > 0) sum += specular.at(x, y) * 4 * facing / (formula.g1(facing) * formula.g1(facing)) * 0.01 * 0.01;
    EXPECT_NEAR(sum, 1, 2e-4) << "sigma " << sigma;
  }
}

/// The integral of G1(V) D / (4 N.V), the term without G1(L), over the directions of light above the horizon.
double weak_furnace(LightProbe& probe, double sigma) {
  const CookTorrance formula{.a = sigma};
  probe.set("sigma", std::to_string(sigma));
  return probe.integral([&](const Angles& a) { return 1 / formula.g1(glm::dot(a.n, a.l)); });
}

TEST(CookTorrance, WeakWhiteFurnaceReturnsAllLight) {
  // Below the horizon, where no term is asked, goes what facets steeper than 45 degrees reflect: a^2 / (1 + a^2).
  LightProbe probe("specular", "specular.cook_torrance", mirror, {0, 0, 1});
  EXPECT_NEAR(weak_furnace(probe, 0.05), 1, 3e-3);
  EXPECT_NEAR(weak_furnace(probe, 0.2) + 0.04 / 1.04, 1, 1e-3);
  EXPECT_NEAR(weak_furnace(probe, 0.4) + 0.16 / 1.16, 1, 1e-3);
}

TEST(CookTorrance, WeakWhiteFurnaceReturnsAllLightSeenFromTheSide) {
  LightProbe probe("specular", "specular.cook_torrance", mirror, turned(30));
  EXPECT_NEAR(weak_furnace(probe, 0.05), 1, 3e-3);
}

TEST(CookTorrance, ReflectsTheKnownShareOfLightAlongTheNormal) {
  LightProbe probe("specular", "specular.cook_torrance", mirror, {0, 0, 1});
  EXPECT_NEAR(probe.integral(), 0.9476, 2e-4);
  probe.set("masking", "correlated");
  EXPECT_NEAR(probe.integral(), 0.9476, 2e-4) << "along the normal nothing is masked from the eye";
}

TEST(CookTorrance, CorrelatedMaskingReflectsMoreAndNeverTooMuch) {
  LightProbe probe("specular", "specular.cook_torrance", mirror, turned(60), 4, 320);
  for (const char* sigma : {"0.2", "0.6"}) {
    probe.set("sigma", sigma);
    probe.set("masking", "separable");
    const double separable = probe.integral();
    probe.set("masking", "correlated");
    EXPECT_GT(probe.integral(), separable + 1e-3) << sigma;
    EXPECT_LT(probe.integral(), 1) << sigma;
  }
}

TEST(CookTorrance, LightAndEyeCanChangePlaces) {
  const glm::vec3 a = glm::normalize(glm::vec3(0.5f, 0.2f, 0.4f)), b = glm::normalize(glm::vec3(-0.3f, -0.1f, 0.9f));
  WallProbe wall("specular", "specular.cook_torrance", R"({"sigma": 0.4})");
  for (const char* masking : {"separable", "correlated"}) {
    wall.set("masking", masking);
    EXPECT_NEAR(wall.reflected(a, b).x / a.z, wall.reflected(b, a).x / b.z, 1e-5f) << masking;
  }
}

}  // namespace
}  // namespace lumen::testing
