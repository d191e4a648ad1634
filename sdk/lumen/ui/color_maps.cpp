#include <lumen/ui/color_maps.h>

#include <array>
#include <vector>

#include <lumen/ui/color.h>

namespace lumen::ui {
namespace {

constexpr std::array<std::string_view, 5> names = {"viridis", "cividis", "gray", "cool to warm", "heat"};

/// sRGB, evenly spaced.
std::vector<std::string_view> colors_of(std::string_view map) {
  if (map == "viridis") return {"440154", "472D7B", "3B528B", "2C728E", "21918C", "28AE80", "5EC962", "ADDC30", "FDE725"};
  if (map == "cividis") return {"00204D", "00336F", "39486B", "575C6D", "707173", "8A8779", "A69D75", "C4B56C", "E4CF5B", "FFEA46"};
  if (map == "gray") return {"000000", "404040", "808080", "BFBFBF", "FFFFFF"};
  if (map == "cool to warm") return {"3B4CC0", "8DB0FE", "DDDDDD", "F49A7B", "B40426"};
  if (map == "heat") return {"000000", "8B0000", "E25822", "FFC040", "FFFFFF"};
  return {};
}

}  // namespace

std::span<const std::string_view> color_map_names() { return names; }

TransferFunction with_colors(const TransferFunction& function, std::string_view map) {
  const auto colors = colors_of(map);
  if (colors.empty()) return function;
  TransferFunction result{function.range, {}};
  for (std::size_t index = 0; index < colors.size(); ++index) {
    const float along = static_cast<float>(index) / static_cast<float>(colors.size() - 1);
    const float x = function.range.x + along * (function.range.y - function.range.x);
    result.points.push_back({x, glm::vec4(color_of(colors[index]).value_or(glm::vec3(0)), function.at(x).a)});
  }
  return result;
}

}  // namespace lumen::ui
