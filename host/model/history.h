/// Undo: steps of (instance, property, JSON before, JSON after), so that they survive reloads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/json_value.h"

namespace lumenshop {

class Session;

/// One change. property empty: the whole instance came (before null) or went (after null).
struct Change {
  std::string instance, property;
  Json before, after;   ///< as the session file has it; null = not set
  int position = -1;    ///< where the instance stood in the session's order
};

struct Step {
  std::string title;    ///< "wall.roughness 0.2 -> 0.35"
  std::vector<Change> changes;
  bool camera = false;  ///< kept on a stack of its own
};

/// At most 1000 steps; the oldest go.
class History {
 public:
  explicit History(Session& session);
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ < steps_.size(); }
  void undo();
  void redo();
  void jump(std::size_t position);              ///< 0 = before the first step
  const std::vector<Step>& steps() const { return steps_; }
  std::size_t position() const { return position_; }
  void clear();

  void begin();                                 ///< nests
  void record(Change change);                   ///< merges with the open step's change of the same property
  void end();
  void cancel();                                ///< undoes what the open step did

 private:
  Session& session_;
  std::vector<Step> steps_;
  std::size_t position_ = 0;
  std::optional<Step> open_;
  int depth_ = 0;
  bool replaying_ = false;
  void apply(const Change& change, bool forward);
};

}  // namespace lumenshop
