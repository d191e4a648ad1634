/// Slices of a surface, moved apart along the x axis.

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include <lumen/splitter.h>

namespace {

struct @Class@ : lumen::Splitter {
  using Splitter::Splitter;

  lumen::Property<int> slices{this, "slices", 3, {.min = 1, .max = 16, .doc = "how many parts"}};
  lumen::Property<float> gap{this, "gap", 0.1f, {.min = 0, .unit = "world", .doc = "between neighbors"}};

  lumen::Split split(const lumen::SplitSurface& surface) override {
    const int count = slices;
    const float left_end = surface.bounds.min.x, width = std::max(surface.bounds.max.x - left_end, 0.0f) / float(count);
    lumen::Split result{.parts = {}};
    for (int i = 0; i < count; ++i) {
      const float left = left_end + width * float(i);
      lumen::Part part;
      part.transform = glm::translate(glm::mat4(1), glm::vec3((float(i) - 0.5f * float(count - 1)) * gap, 0, 0));
      if (i > 0) part.planes.emplace_back(1, 0, 0, -left);
      if (i + 1 < count) part.planes.emplace_back(-1, 0, 0, left + width);
      result.parts.push_back(part);
    }
    return result;
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "splitter.@name@", "Slices of a surface, moved apart along the x axis.")
