#include "grid_cursor.h"

#include <algorithm>
#include <cmath>

std::size_t GridCursor::across_lines(std::size_t from, int way) const {
  const ImVec2 here = cells_[from].corner;
  std::size_t best = from;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const float down = float(way) * (cells_[i].corner.y - here.y);
    if (down < 1) continue;
    const float best_down = float(way) * (cells_[best].corner.y - here.y);
    const bool same_line = best != from && std::abs(down - best_down) < 1;
    const bool nearer = std::abs(cells_[i].corner.x - here.x) < std::abs(cells_[best].corner.x - here.x);
    if (best == from || down < best_down - 1 || (same_line && nearer)) best = i;
  }
  return best;
}

bool GridCursor::take_keys() {
  if (cells_.empty()) return false;
  const auto found = std::find_if(cells_.begin(), cells_.end(), [&](const Cell& cell) { return cell.name == at_; });
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  const std::size_t here = std::size_t(found - cells_.begin()), last = cells_.size() - 1;
  const bool somewhere = found != cells_.end();
  std::size_t next = here;
  if (pressed(ImGuiKey_Home)) next = 0;
  else if (pressed(ImGuiKey_End)) next = last;
  else if (const bool on = pressed(ImGuiKey_RightArrow); on || pressed(ImGuiKey_LeftArrow)) next = !somewhere ? 0 : on ? std::min(here + 1, last) : here - std::min<std::size_t>(here, 1);
  else if (const bool down = pressed(ImGuiKey_DownArrow); down || pressed(ImGuiKey_UpArrow)) next = somewhere ? across_lines(here, down ? 1 : -1) : 0;
  if (next == here || next > last) return false;
  at_ = cells_[next].name;
  return true;
}
