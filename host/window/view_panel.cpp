#include "window/view_panel.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>
#include <glm/vector_relational.hpp>
#include <imgui.h>

#include <lumen/ui/look.h>

#include "model/view.h"
#include "window/glfw_window.h"

namespace lumenshop {
namespace {

/// Words on a dark plate that is read over any picture.
void chip(ImVec2 corner, const std::string& words, float align_x, float align_y) {
  const lumen::ui::Look& look = lumen::ui::look();
  const ImVec2 text = ImGui::CalcTextSize(words.c_str());
  const ImVec2 size(text.x + look(16), text.y + look(8));
  const ImVec2 min(corner.x - align_x * size.x, corner.y - align_y * size.y);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(min, {min.x + size.x, min.y + size.y}, lumen::ui::faded(look.colors.panel, 0.9f), look(3));
  list->AddText({min.x + look(8), min.y + look(4)}, look.colors.text, words.c_str());
}

}  // namespace

ViewPanel::ViewPanel(Workshop& workshop) : workshop_(workshop) {}

ViewRenderer* ViewPanel::renderer() {
  if (workshop_.session().views().empty()) {
    view_.clear();
    return nullptr;
  }
  view_ = workshop_.session().views().front()->id();
  try {
    return &workshop_.view(view_);
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
  return nullptr;
}

void ViewPanel::begin_input(const Settings& settings, const std::string& selection) {
  input_.begin({.session = &workshop_.session(), .renderer = renderer(), .view = view_, .selection = selection, .size = glm::max(size_, glm::ivec2(1)),
                .time = GlfwWindow::time(), .blender_keys = settings.blender_keys, .reduced_motion = settings.reduced_motion});
}

void ViewPanel::draw(const Context& context) {
  place_ = context.place;
  size_ = glm::max(glm::ivec2(glm::round(place_.size())), glm::ivec2(1));
  begin_input(context.settings, context.selection);

  ImGui::SetNextWindowPos({place_.min.x, place_.min.y});
  ImGui::SetNextWindowSize({place_.size().x, place_.size().y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  // Without a background: the frame was cleared to the canvas.
  ImGui::Begin("##view", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse);
  // Claims presses on the picture, so that ImGui neither moves the window nor hands them to what lies behind.
  ImGui::InvisibleButton("picture", {place_.size().x, place_.size().y}, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  lumen::ui::record("picture");
  if (picture_ && *picture_ && !view_.empty()) {
    const auto name = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(picture_->texture().name()));
    // Rows of GL textures run upward.
    ImGui::GetWindowDrawList()->AddImage(name, {place_.min.x, place_.min.y}, {place_.max.x, place_.max.y}, {0, 1}, {1, 0});
  }
  take_events(context, hovered);
  input_.tick();
  if (view_.empty()) draw_empty(place_);
  else draw_chips(context);
  if (!view_.empty() && !context.figure) draw_labels();
  if (hovered && input_.cursor() == lumen::Cursor::hand) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (hovered && input_.cursor() == lumen::Cursor::move) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (std::exchange(open_menu_, false)) ImGui::OpenPopup("view menu");
  ImGui::PopStyleVar();
  if (ImGui::BeginPopup("view menu")) {
    context.context_menu();
    ImGui::EndPopup();
  }
  ImGui::End();
}

void ViewPanel::draw_chips(const Context& context) {
  chip_shown_ = false;
  const lumen::ui::Look& look = lumen::ui::look();
  const float inset = look(5);
  if (!failure_.empty()) chip({place_.min.x + inset, place_.min.y + inset}, failure_, 0, 0);
  if (context.figure) return;
  if (failure_.empty()) chip({place_.min.x + inset, place_.min.y + inset}, view_, 0, 0);
  const int percent = static_cast<int>(std::lround(progress_ * 100));
  std::string words;
  if (divider_ > 1) words = divider_ == 2 ? "\xC2\xBD resolution" : "\xC2\xBC resolution";
  if (unfinished_ || divider_ > 1) words += (words.empty() ? "" : " \xE2\x80\xA2 ") + ("refining " + std::to_string(divider_ > 1 ? 0 : percent) + " %");
  chip_shown_ = !words.empty();
  if (chip_shown_) chip({place_.min.x + inset, place_.max.y - inset}, words, 0, 1);
}

void ViewPanel::draw_labels() {
  const lumen::ui::Look& look = lumen::ui::look();
  ImGui::PushClipRect({place_.min.x, place_.min.y}, {place_.max.x, place_.max.y}, true);
  for (const ViewInputRouter::PlacedLabel& label : input_.labels()) {
    // Toward the middle, so that it stays within the view.
    const glm::bvec2 beyond = glm::greaterThan(label.pixel, 0.6f * glm::vec2(size_));
    const glm::vec2 place = place_.min + label.pixel, away = look(12) * glm::vec2(beyond.x ? -1 : 1, beyond.y ? -1 : 1);
    chip({place.x + away.x, place.y + away.y}, label.text, away.x < 0 ? 1 : 0, away.y < 0 ? 1 : 0);
    lumen::ui::record("label:" + label.instance, {place.x - 1, place.y - 1}, {place.x + 1, place.y + 1});
  }
  ImGui::PopClipRect();
}

void ViewPanel::draw_empty(const Rectangle& place) {
  const lumen::ui::Look& look = lumen::ui::look();
  const std::string words = "Nothing to show yet. Drop a mesh or a session here, or open one with Ctrl+O.";
  const float width = std::min(look(420), place.size().x - look(40));
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, width);
  const glm::vec2 corner = place.min + 0.5f * (place.size() - glm::vec2(size.x, size.y));
  ImGui::GetWindowDrawList()->AddText(nullptr, 0, {corner.x, corner.y}, look.colors.label, words.c_str(), nullptr, width);
}

void ViewPanel::refresh(bool editing) {
  ViewRenderer* view = renderer();
  unfinished_ = false;
  if (!view) return;
  const double now = GlfwWindow::time();
  const std::uint64_t revision = workshop_.session().revision();
  const bool changed = revision != drawn_revision_;
  // Only what a person moves may be coarse for a moment; a job's result or a reload is drawn whole.
  if (changed && (editing || input_.captured() || input_.animating() || wheeled_)) resolution_.changed(now);
  drawn_revision_ = revision;
  wheeled_ = false;
  divider_ = resolution_.divider(now);
  const glm::ivec2 size = glm::max((size_ + divider_ - 1) / divider_, glm::ivec2(1));
  if (!changed && size == view->size() && resolution_.moving(now)) {
    // Nothing but a refinement would run, and the next move would have to wait for it.
    unfinished_ = view->unfinished();
    return;
  }
  try {
    failure_.clear();
    view->resize(size);
    const double begin = GlfwWindow::time();
    if (view->draw()) {
      const Instance* instance = workshop_.session().find(view_);
      const auto* options = instance ? instance->as<View>(lumen::Kind::view) : nullptr;
      if (!picture_) picture_ = std::make_unique<PictureTexture>();
      const ImVec4 canvas = ImGui::ColorConvertU32ToFloat4(lumen::ui::look().colors.canvas);
      picture_->update(view->picture(), !options || options->encode_srgb, {canvas.x, canvas.y, canvas.z}, divider_ > 1);
      glFinish();  // llvmpipe draws when it is waited for: without this the time would be another frame's
      const double seconds = GlfwWindow::time() - begin;
      milliseconds_ = seconds * 1000;
      if (resolution_.moving(now)) resolution_.took(seconds, divider_);
    }
    unfinished_ = view->unfinished();
    progress_ = view->progress();
    drawn_revision_ = workshop_.session().revision();
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
}

std::string ViewPanel::instance_at(glm::vec2 point) {
  return view_.empty() || !place_.contains(point) ? std::string() : input_.instance_at(point - place_.min);
}

bool ViewPanel::busy() const {
  if (input_.animating()) return true;
  // The chip was drawn before the last refinement: one more frame takes it away.
  if (chip_shown_ && !unfinished_ && divider_ == 1) return true;
  // While the person moves things, refinement waits: it would only delay the next picture.
  return (unfinished_ || divider_ > 1) && !resolution_.moving(GlfwWindow::time());
}

double ViewPanel::wake_at() const {
  const bool coarse = divider_ > 1 || unfinished_;
  return coarse && resolution_.moving(GlfwWindow::time()) ? resolution_.rests_at() + 0.001 : 0;
}

void ViewPanel::release() {
  input_.let_go();
  picture_.reset();
  divider_ = 1;
}

}  // namespace lumenshop
