#include "model/history.h"

#include <algorithm>

#include "model/session.h"

namespace lumenshop {

namespace {

constexpr std::size_t most_steps = 1000;
constexpr auto one_gesture = std::chrono::milliseconds(700);

std::string short_text(const Json& json) {
  if (json.is_null()) return "default";
  if (json.is_object() && json.contains("link") && json["link"].is_string()) return "link to " + json["link"].get<std::string>();
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > 40) text.replace(37, std::string::npos, "...");
  return text;
}

std::string title_of(const Change& change) {
  if (!change.property.empty())
    return change.instance + "." + change.property + " " + short_text(change.before) + " -> " + short_text(change.after);
  if (change.before.is_null()) return "add " + change.instance;
  if (change.after.is_null()) return "remove " + change.instance;
  return "rename " + change.before.get<std::string>() + " to " + change.after.get<std::string>();
}

std::string title_of(const Step& step) {
  const std::string first = title_of(step.changes.front());
  const std::size_t more = step.changes.size() - 1;
  return more == 0 ? first : first + " and " + std::to_string(more) + " more";
}

}  // namespace

History::History(Session& session) : session_(session) {}

void History::Stack::push(Step step) {
  steps.resize(position);
  steps.push_back(std::move(step));
  if (steps.size() > most_steps) steps.erase(steps.begin());
  position = steps.size();
}

void History::clear() {
  edits_ = {};
  camera_ = {};
  open_.reset();
  depth_ = 0;
  joins_ = false;
}

void History::begin() {
  if (depth_++ == 0) open_ = Step{};
  joins_ = false;
}

void History::add(Step& step, Change change) {
  if (!change.property.empty())
    // Only back to the last structural change: an instance that went and came again is another.
    for (auto other = step.changes.rbegin(); other != step.changes.rend() && !other->property.empty(); ++other)
      if (other->instance == change.instance && other->property == change.property && other->folder == change.folder) {
        other->after = std::move(change.after);
        return;
      }
  step.changes.push_back(std::move(change));
}

void History::record(Change change, bool by_object, bool moves_camera) {
  if (replaying_) return;
  const auto now = std::chrono::steady_clock::now();
  if (open_) {
    open_->camera = moves_camera && (open_->changes.empty() || open_->camera);
    add(*open_, std::move(change));
    return;
  }
  Stack& stack = moves_camera ? camera_ : edits_;
  const bool joins = by_object && joins_ && now - last_ < one_gesture && stack.position > 0 && stack.position == stack.steps.size() &&
                     stack.steps.back().changes.front().instance == change.instance;
  if (joins) {
    Step& step = stack.steps.back();
    add(step, std::move(change));
    step.title = title_of(step);
  } else {
    Step step{.changes = {std::move(change)}, .camera = moves_camera};
    step.title = title_of(step);
    stack.push(std::move(step));
  }
  joins_ = by_object;
  last_ = now;
}

void History::end() {
  if (depth_ == 0 || --depth_ > 0) return;  // a cancelled edit has ended already
  finish();
}

void History::finish() {
  depth_ = 0;
  if (!open_) return;
  Step step = std::move(*open_);
  open_.reset();
  std::erase_if(step.changes, [](const Change& change) { return !change.property.empty() && change.before == change.after; });
  if (step.changes.empty()) return;
  step.title = title_of(step);
  Stack& stack = step.camera ? camera_ : edits_;
  stack.push(std::move(step));
}

void History::cancel() {
  if (!open_) return;
  const Step step = std::move(*open_);
  open_.reset();
  depth_ = 0;
  apply(step, false);
}

void History::apply(const Step& step, bool forward) {
  replaying_ = true;
  // Undone from the last to the first: each finds what it found when it was made.
  if (forward) std::for_each(step.changes.begin(), step.changes.end(), [&](const Change& change) { session_.replay(change, true); });
  else std::for_each(step.changes.rbegin(), step.changes.rend(), [&](const Change& change) { session_.replay(change, false); });
  replaying_ = false;
}

void History::move(Stack& stack, bool forward) {
  finish();
  joins_ = false;
  if (forward ? stack.position == stack.steps.size() : stack.position == 0) return;
  apply(stack.steps[forward ? stack.position : stack.position - 1], forward);
  forward ? ++stack.position : --stack.position;
}

void History::undo() { move(edits_, false); }
void History::redo() { move(edits_, true); }
void History::undo_camera() { move(camera_, false); }
void History::redo_camera() { move(camera_, true); }

void History::jump(std::size_t position) {
  finish();
  position = std::min(position, edits_.steps.size());
  while (edits_.position > position) undo();
  while (edits_.position < position) redo();
}

void History::renamed(const std::string& from, const std::string& to) {
  for (Step& step : camera_.steps)
    for (Change& change : step.changes)
      if (change.instance == from) change.instance = to;
}

}  // namespace lumenshop
