#include "window/question.h"

#include <utility>

#include <imgui.h>

#include <lumen/ui/look.h>

namespace lumenshop {

void Question::ask(std::string title, std::string text, std::vector<Answer> answers) {
  title_ = std::move(title);
  text_ = std::move(text);
  answers_ = std::move(answers);
  appears_ = true;
}

void Question::draw() {
  if (!is_open()) return;
  lumen::ui::Look& look = lumen::ui::look();
  const std::string name = title_ + "###question";
  if (std::exchange(appears_, false)) ImGui::OpenPopup(name.c_str());
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({look(420), 0});
  if (!ImGui::BeginPopupModal(name.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    answers_.clear();
    return;
  }
  look.panel = "question";
  ImGui::PushTextWrapPos(0);
  lumen::ui::text(text_, look.colors.text);
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, look(6)});
  int chosen = -1;
  for (std::size_t index = 0; index < answers_.size(); ++index) {
    if (index > 0) ImGui::SameLine();
    if (ImGui::Button(answers_[index].label.c_str(), {look(100), 0})) chosen = static_cast<int>(index);
    lumen::ui::record(answers_[index].label);
  }
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
  if (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) chosen = 0;
  if (pressed(ImGuiKey_Escape)) chosen = static_cast<int>(answers_.size()) - 1;
  std::function<void()> action;
  if (chosen >= 0) {
    action = std::move(answers_[static_cast<std::size_t>(chosen)].action);
    answers_.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (action) action();
}

}  // namespace lumenshop
