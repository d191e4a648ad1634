#include "window/layout.h"

#include <algorithm>
#include <cmath>

namespace lumenshop {

Layout arranged(glm::vec2 window, float scale, const PanelSizes& sizes, bool figure) {
  Layout layout;
  if (figure) {
    layout.view = {{0, 0}, window};
    return layout;
  }
  const auto pixels = [&](float units) { return std::round(units * scale); };
  const float top = pixels(Layout::menu_height), bottom = std::max(top, window.y - pixels(Layout::status_height));
  layout.menu = {{0, 0}, {window.x, top}};
  layout.status = {{0, bottom}, window};

  // What both panels may have beside the view: each is shrunk in proportion.
  const float left_wish = sizes.outline_open ? pixels(std::max(sizes.outline, Layout::smallest)) : 0;
  const float right_wish = sizes.properties_open ? pixels(std::max(sizes.properties, Layout::smallest)) : 0;
  const float room = std::max(0.0f, window.x - pixels(Layout::smallest_view));
  const float shrink = left_wish + right_wish > room && left_wish + right_wish > 0 ? room / (left_wish + right_wish) : 1;
  const float left = std::floor(left_wish * shrink), right = window.x - std::floor(right_wish * shrink);

  const float bottom_wish = sizes.bottom_open ? pixels(std::max(sizes.bottom, 60.0f)) : 0;
  const float view_bottom = std::floor(std::max(top, bottom - std::min(bottom_wish, (bottom - top) * 0.6f)));

  const float gap = pixels(Layout::splitter);
  if (left > 0) {
    layout.outline = {{0, top}, {left, bottom}};
    layout.outline_splitter = {{left - gap / 2, top}, {left + gap / 2, bottom}};
  }
  if (right < window.x) {
    layout.properties = {{right, top}, {window.x, bottom}};
    layout.properties_splitter = {{right - gap / 2, top}, {right + gap / 2, bottom}};
  }
  layout.view = {{left, top}, {right, view_bottom}};
  if (view_bottom < bottom) {
    layout.bottom = {{left, view_bottom}, {right, bottom}};
    layout.bottom_splitter = {{left, view_bottom - gap / 2}, {right, view_bottom + gap / 2}};
  }
  return layout;
}

}  // namespace lumenshop
