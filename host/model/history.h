/// Undo: steps of (instance, property, JSON before, JSON after), so that they survive reloads.
///
/// Camera moves have a stack of their own: undoing an edit does not turn the view, and the other way round.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/json_value.h"

namespace lumenshop {

class Session;

/// One change. property empty: the whole instance came (before null), went (after null) or got another id (both strings).
struct Change {
  std::string instance, property;
  Json before, after;   ///< as the session file has it, of an instance with its "type"; null = not set
  int position = -1;    ///< where the instance stood in the session's order
  std::filesystem::path folder = {};  ///< where relative paths in `before` and `after` start
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
  bool can_undo() const { return edits_.position > 0; }
  bool can_redo() const { return edits_.position < edits_.steps.size(); }
  void undo();
  void redo();
  void jump(std::size_t position);              ///< 0 = before the first step
  const std::vector<Step>& steps() const { return edits_.steps; }
  std::size_t position() const { return edits_.position; }
  void clear();

  bool can_undo_camera() const { return camera_.position > 0; }
  bool can_redo_camera() const { return camera_.position < camera_.steps.size(); }
  void undo_camera();
  void redo_camera();

  void begin();                                 ///< nests
  /// Merges with the open step's change of the same property; a step of its own if none is open. Of `by_object` changes
  /// (an interactor's writes) those of one instance that follow within 0.7 s are one step.
  void record(Change change, bool by_object = false, bool moves_camera = false);
  void end();
  void cancel();                                ///< undoes what the open step did, however deep it is nested

  void renamed(const std::string& from, const std::string& to);  ///< camera steps follow; edits carry the renaming themselves

 private:
  struct Stack {
    std::vector<Step> steps;
    std::size_t position = 0;
    void push(Step step);
  };
  Session& session_;
  Stack edits_, camera_;
  std::optional<Step> open_;
  int depth_ = 0;
  bool replaying_ = false;
  bool joins_ = false;                          ///< the newest step may take further writes of its instance
  std::chrono::steady_clock::time_point last_;

  void add(Step& step, Change change);
  void finish();
  void apply(const Step& step, bool forward);
  void move(Stack& stack, bool forward);
};

}  // namespace lumenshop
