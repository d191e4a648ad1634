/// Every splitter, as it is by default, on whatever a surface may be: closed, open, moved, mirrored, transparent, in pairs.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

#include "plugins/installed_types.h"

namespace lumenshop {
namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

void expect_sound(Scene& scene, const std::string& what) {
  const Pixels color = scene.picture();
  for (int y = 0; y < color.height(); ++y)
    for (int x = 0; x < color.width(); ++x)
      for (int channel = 0; channel < 4; ++channel) ASSERT_TRUE(std::isfinite(color.at(x, y, channel))) << what << " at " << x << ", " << y;
  for (const lumen::Problem& problem : scene.problems())
    EXPECT_EQ(problem.severity, lumen::Severity::note) << what << ": " << problem.message;  // what it falls back from
}

TEST(EverySplitter, SplitsWhateverSurfaceThereIs) {
  const std::pair<const char*, std::shared_ptr<lumen::Mesh>> meshes[] = {
      {"closed", lumen::testing::sphere(24)},
      {"open", lumen::testing::rectangle()},
      {"two parts", lumen::testing::joined({lumen::testing::sphere(16, 0.4f), lumen::testing::moved(*lumen::testing::box(glm::vec3(0.3f)), {0.7f, 0, 0})})}};
  for (const std::string& type : installed_types(lumen::Kind::splitter))
    for (const auto& [shape, mesh] : meshes)
      for (const char* transform : {"[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]", "[-0.5,0,0,0.1, 0,1,0,0, 0,0,2,0, 0,0,0,1]"})
        for (const bool transparent : {false, true}) {
          Scene scene({48, 48});
          scene.add(type, "cut");
          scene.add("diffuse.lambert", "lambert");
          if (transparent) {
            scene.add("opacity.constant", "half", R"({"alpha": 0.5})");
            scene.add("transparency.linked_list", "exact");
          }
          scene.surface("surface", mesh, std::string(R"({"diffuse": "lambert", "splitter": ["cut"], "transform": )") + transform + (transparent ? R"(, "opacity": "half"})" : "}"));
          expect_sound(scene, type + ", " + shape + (transparent ? ", transparent" : ""));
        }
}

TEST(EverySplitter, ComposesWithAPlane) {
  for (const std::string& type : installed_types(lumen::Kind::splitter)) {
    Scene scene({48, 48});
    scene.add(type, "first");
    scene.add("splitter.plane", "second", R"({"axis": [0, 1, 0], "angle": 90, "offset": 0.3})");
    scene.surface("ball", lumen::testing::sphere(24), R"({"splitter": ["first", "second"]})");
    expect_sound(scene, type);
    EXPECT_TRUE(std::isinf(scene.layer("depth").at(24, 24))) << type << ": the plane's gap is open";
  }
}

}  // namespace
}  // namespace lumenshop
