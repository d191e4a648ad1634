#include "window/editor_panel.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <lumen/ui/look.h>

namespace lumenshop {

using lumen::Kind;

EditorPanel::EditorPanel(Registry& registry, std::string type) : registry_(registry), type_(std::move(type)), own_(registry) {}

lumen::Editor* EditorPanel::editor(Session& session) {
  for (const auto& instance : session.plugins())
    if (instance->type() == type_ && instance->enabled())
      if (auto* editor = instance->as<lumen::Editor>(Kind::editor)) return editor;
  if (!registry_.has(type_)) {
    failure_ = "No library has " + type_ + "; build it, or install the program again.";
    return nullptr;
  }
  try {
    if (own_.plugins().empty()) own_.add(type_);
    Instance& instance = *own_.plugins().front();
    if (instance.generation() != registry_.generation(type_)) {
      Rebuild rebuild(own_, registry_, {type_});
      rebuild.swap();
      rebuild.keep();
    }
    own_.update();
    failure_.clear();
    return instance.as<lumen::Editor>(Kind::editor);
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
  return nullptr;
}

std::string EditorPanel::title(Session& session) {
  const lumen::Editor* found = editor(session);
  return found ? found->title() : type_;
}

void EditorPanel::draw(Session& session, lumen::Workbench& workbench) {
  const ImGuiID window = ImGui::GetCurrentWindow()->ID;
  const int depth = ImGui::GetCurrentContext()->CurrentWindowStack.Size;
  if (lumen::Editor* found = editor(session)) {
    try {
      found->draw(workbench);
    } catch (const std::exception& error) {
      // Whatever it had begun is ended, so that the rest of the window is drawn as ever.
      while (ImGui::GetCurrentContext()->CurrentWindowStack.Size > depth && ImGui::GetCurrentWindow()->ID != window) {
        ImGui::ErrorCheckEndWindowRecover(nullptr);
        if (ImGui::GetCurrentWindow()->Flags & ImGuiWindowFlags_ChildWindow) ImGui::EndChild();
        else ImGui::End();
      }
      ImGui::ErrorCheckEndWindowRecover(nullptr);
      failure_ = type_ + ": " + error.what();
    }
  }
  if (failure_.empty()) return;
  ImGui::PushTextWrapPos(0);
  lumen::ui::text(failure_, lumen::ui::look().colors.error);
  ImGui::PopTextWrapPos();
}

}  // namespace lumenshop
