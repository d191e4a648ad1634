/// Where the panels stand: rectangles from the window's size and what the person chose. Pure.
#pragma once

#include <glm/vec2.hpp>

namespace lumenshop {

/// Pixels, origin top left.
struct Rectangle {
  glm::vec2 min{0}, max{0};
  glm::vec2 size() const { return max - min; }
  bool empty() const { return max.x <= min.x || max.y <= min.y; }
  bool contains(glm::vec2 point) const { return point.x >= min.x && point.y >= min.y && point.x < max.x && point.y < max.y; }
};

/// In UI units; what the settings remember.
struct PanelSizes {
  static constexpr float outline_default = 280, properties_default = 360, bottom_default = 130;
  static constexpr float bottom_roomy = 290;  ///< least height of a bottom panel of pictures or tables, when it is opened
  float outline = outline_default, properties = properties_default, bottom = bottom_default;
  bool outline_open = true, properties_open = true, bottom_open = true;
};

struct Layout {
  static constexpr float menu_height = 25, status_height = 26, splitter = 6, smallest = 200, smallest_view = 160;
  Rectangle menu, outline, view, bottom, properties, status;  ///< empty = not shown
  Rectangle outline_splitter, properties_splitter, bottom_splitter;
};

/// Sizes are clamped so that the view keeps its share. `figure`: the view alone.
Layout arranged(glm::vec2 window, float scale, const PanelSizes& sizes, bool figure);

}  // namespace lumenshop
