/// A cursor that the arrow keys move over things laid out in lines.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

class GridCursor {
 public:
  void begin_frame() { cells_.clear(); }
  /// The next one in reading order, where it is drawn. Names differ.
  void add(const std::string& name, ImVec2 corner) { cells_.push_back({name, corner}); }
  /// After all are added, in a window that has the keyboard: follows the arrow keys, Home and End. True if it went elsewhere.
  bool take_keys();

  bool is_at(const std::string& name) const { return !name.empty() && name == at_; }
  void put(const std::string& name) { at_ = name; }

 private:
  struct Cell {
    std::string name;
    ImVec2 corner;
  };
  /// The nearest of the next line below (`way` 1) or above (-1), or where it is.
  std::size_t across_lines(std::size_t from, int way) const;
  std::vector<Cell> cells_;
  std::string at_;   ///< empty: nowhere yet
};
