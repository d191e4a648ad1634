/// Slices of a surface, moved apart along the x axis.

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include <lumen/splitter.h>

namespace {

struct @Class@ : lumen::Splitter {
  using Splitter::Splitter;

  lumen::Property<int> slices{this, "slices", 3, {.min = 1, .max = 16, .doc = "how many parts"}};
  lumen::Property<float> gap{this, "gap", 0.1f, {.min = 0, .unit = "world", .doc = "between neighbors"}};

  std::vector<lumen::Part> parts(const lumen::Bounds& bounds) const override {
    const int count = slices;
    const float width = std::max(bounds.max.x - bounds.min.x, 0.0f) / float(count);
    std::vector<lumen::Part> result;
    for (int i = 0; i < count; ++i) {
      const float left = bounds.min.x + width * float(i);
      lumen::Part part;
      part.transform = glm::translate(glm::mat4(1), glm::vec3((float(i) - 0.5f * float(count - 1)) * gap, 0, 0));
      if (i > 0) part.planes.emplace_back(1, 0, 0, -left);
      if (i + 1 < count) part.planes.emplace_back(-1, 0, 0, left + width);
      result.push_back(part);
    }
    return result;
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "splitter.@name@", "Slices of a surface, moved apart along the x axis.")
