#include <lumen/ui/edit.h>

#include <imgui.h>

#include <lumen/ui/look.h>

namespace lumen::ui {
namespace {

constexpr double nudges_join = 0.7;  // seconds

void begin(Workbench& workbench, const std::string& path) {
  Look& it = look();
  if (it.editing == path) return;
  settle_now(workbench);
  workbench.begin_edit();
  it.editing = path;
}

/// The reference, or the list of them, with one to a new instance.
Value referring(Value value, const std::string& id) {
  if (auto* list = std::get_if<References>(&value)) list->ids.push_back(id);
  else std::get<Reference>(value).id = id;
  return value;
}

void add(Workbench& workbench, const std::string& path, const std::string& type, const Value& value) {
  settle_now(workbench);
  workbench.begin_edit();
  try {
    workbench.set(path, referring(value, workbench.add(type)));
    workbench.end_edit();
  } catch (...) {
    workbench.cancel_edit();
    throw;
  }
}

}  // namespace

void carry_out(Workbench& workbench, const std::string& path, const Edit& edit, const Value& value) {
  Look& it = look();
  try {
    if (edit.cancelled) {
      if (it.editing != path) return;
      it.editing.clear();
      workbench.cancel_edit();
      return;
    }
    if (edit.active || edit.nudged) {
      begin(workbench, path);
      it.editing_frame = ImGui::GetFrameCount();
      it.editing_until = 0;
      if (edit.nudged) {
        it.editing_until = ImGui::GetTime() + nudges_join;
        wake_in(nudges_join + 0.01);
      }
    }
    if (!edit.new_type.empty()) return add(workbench, path, edit.new_type, value);
    if (edit.changed) workbench.set(path, value);
  } catch (const Error& error) {
    it.notice = error.what();
  }
}

void settle(Workbench& workbench) {
  const Look& it = look();
  if (it.editing.empty() || it.editing_frame == ImGui::GetFrameCount()) return;
  if (ImGui::GetTime() >= it.editing_until) settle_now(workbench);
}

void settle_now(Workbench& workbench) {
  Look& it = look();
  if (it.editing.empty()) return;
  it.editing.clear();
  workbench.end_edit();
}

}  // namespace lumen::ui
