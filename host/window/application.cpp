#include "window/application.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

#include <lumen/ui/edit.h>

#include "installation.h"
#include "window/menu_bar.h"
#include "window/panel_window.h"
#include "window/shortcuts.h"
#include "window/status_bar.h"

namespace lumenshop {
namespace {

constexpr const char* problems_type = "editor.problems";

}  // namespace

Application::Application(Workshop& workshop, GlfwWindow& window, Gui& gui, Files files)
    : workshop_(workshop), window_(window), gui_(gui), settings_file_(std::move(files.settings)), settings_(Settings::load(settings_file_)), restore_(std::move(files.state)),
      workbench_(workshop, [this](const std::string& message) { toasts_.show(lumen::Severity::warning, "That does not work", message); }, GlfwWindow::wake),
      check_(workshop), view_(workshop), properties_(workshop.registry(), "editor.properties") {
  find_bottom_panels();
  add_commands();
  const Installation installation = Installation::find();
  reloader_ = std::make_unique<Reloader>(workshop_.registry(), workshop_.session(), check_,
                                         Reloader::Options{.shader_folder = installation.shaders(), .build_description = installation.build_description()});
  workbench_.set_reloader(reloader_.get());
  workbench_.set_picking([this](glm::vec2 point) { return view_.instance_at(point); });
  watch_ = std::make_unique<DescriptorWatch>(reloader_->descriptor(), GlfwWindow::wake);
  gui_.look().browse = [this](const std::string& from) { browse(from); };
  apply_look();
  offer_restore();
}

Application::~Application() {
  view_.release();
  workshop_.close_views();
}

std::string Application::title() const {
  const Session& session = workshop_.session();
  if (!session.title().empty()) return session.title();
  return session.file().empty() ? "untitled" : session.file().stem().string();
}

void Application::apply_look() {
  float forced = 0;
  if (const char* scale = std::getenv("LUMENSHOP_SCALE")) forced = std::strtof(scale, nullptr);
  const float scale = forced >= 0.5f && forced <= 4 ? forced * settings_.user_scale : window_.content_scale() * settings_.user_scale;
  gui_.set_look(settings_.theme, scale, settings_.reduced_motion);
  workbench_.set_scale(scale);
  workbench_.set_reduced_motion(settings_.reduced_motion);
  shown_scale_ = scale;
}

void Application::save_settings() {
  if (!settings_file_.empty()) settings_.save(settings_file_);
}

bool Application::update() {
  bool news = workshop_.scheduler().update();
  news |= workbench_.update();
  if (watch_->ready()) {
    for (const ReloadEvent& event : reloader_->poll()) {
      news = true;
      workbench_.reloaded(event, GlfwWindow::time());
      toasts_.dismiss(event.library);
      if (event.state == BuildState::kept)
        toasts_.show(lumen::Severity::error, event.library + ": generation " + std::to_string(event.generation) + " kept", event.message, event.library);
    }
    watch_->rearm();
    news = true;
  }
  return news || !workshop_.scheduler().running().empty();
}

double Application::wake_at() const {
  double next = 0;
  const auto consider = [&](double time) {
    if (time > 0) next = next > 0 ? std::min(next, time) : time;
  };
  consider(view_.wake_at());
  consider(workbench_.next_tick());
  consider(gui_.wake_at());
  consider(restore_.next(workshop_.session()));
  if (!workshop_.scheduler().running().empty()) consider(GlfwWindow::time() + 0.1);
  return next;
}

void Application::frame(const std::vector<WindowEvent>& events) {
  if (const auto replace = std::exchange(replace_, nullptr)) replace();
  if (std::exchange(apply_look_, false)) {
    apply_look();
    save_settings();
  }
  gui_.begin(events);
  workbench_.tick(GlfwWindow::time());
  for (const WindowEvent& event : events) {
    if (event.type == WindowEvent::Type::drop) take_drop(event.files);
    if (event.type == WindowEvent::Type::close) commands_.run("window.quit");
  }
  draw_panels(events);
  take_keys(events);
  lumen::ui::settle(workbench_);
  if (std::string notice = std::exchange(gui_.look().notice, {}); !notice.empty()) toasts_.show(lumen::Severity::warning, "That does not work", notice);

  workshop_.session().update();
  workshop_.scheduler().update();
  view_.refresh(!gui_.look().editing.empty());
  restore_.keep(workshop_.session(), GlfwWindow::time());
  gui_.end();
  if (const std::string title = this->title() + (workshop_.session().modified() ? " \xE2\x80\xA2" : "") + " - Lumenshop"; title != shown_title_) window_.set_title(shown_title_ = title);
}

void Application::draw_panels(const std::vector<WindowEvent>& events) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Layout layout = arranged({size.x, size.y}, shown_scale_, settings_.panels, figure_);
  lumen::ui::Look& look = gui_.look();

  look.panel = "view";
  const std::string no_letter;
  view_.draw({.place = layout.view, .events = events, .held_letter = ImGui::GetIO().WantTextInput ? no_letter : gui_.held_letter(),
              .selection = workbench_.selection(), .settings = settings_, .figure = figure_,
              .select = [this](const std::string& id) { workbench_.select(id); },
              .context_menu = [this] { draw_menu_entries(commands_, "View"); }});
  if (!figure_) {
    draw_menu_bar(layout.menu, commands_, title(), workshop_.session().modified());
    if (!layout.outline.empty()) {
      const PanelWindow panel("outline", layout.outline);
      outline_.draw(workbench_, {.rename = [this](const std::string& id, const std::string& to) { rename(id, to); }, .add = [this] { commands_.run("edit.add"); }});
    }
    if (!layout.properties.empty()) {
      const PanelWindow panel("properties", layout.properties);
      properties_.draw(workshop_.session(), workbench_);
    }
    if (!layout.bottom.empty()) draw_bottom(layout.bottom);
    draw_status_bar(layout.status, {.blender_keys = settings_.blender_keys, .building = reloader_->building(), .jobs = workshop_.scheduler().running(),
                                    .milliseconds = view_.milliseconds(), .size = view_.size(),
                                    .cancel = [this](const std::string& instance) { workshop_.scheduler().cancel(instance); }});
    if (drag_splitters(layout, shown_scale_, settings_.panels)) save_settings();
  }
  if (figure_) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  toasts_.draw(layout.view, figure_);
  browser_.draw();
  question_.draw();
  add_popup_.draw([this](const std::string& type) { add(type); });
  draw_shortcuts(commands_, open_help_);
}

void Application::find_bottom_panels() {
  // Problems is there even if no library has it: its panel says so.
  std::vector<std::string> types = {problems_type};
  for (const TypeInfo& info : workshop_.registry().types())
    if (info.kind == lumen::Kind::editor && info.id != "editor.properties" && info.id != problems_type) types.push_back(info.id);
  for (const std::string& type : types)
    bottom_panels_.push_back({type.substr(type.find('.') + 1), std::make_unique<EditorPanel>(workshop_.registry(), type)});
}

Application::BottomPanel& Application::bottom_panel() {
  for (BottomPanel& panel : bottom_panels_)
    if (panel.name == settings_.bottom_panel) return panel;
  return bottom_panels_.front();
}

void Application::draw_bottom(const Rectangle& place) {
  if (std::exchange(focus_bottom_, false)) ImGui::SetNextWindowFocus();
  const PanelWindow window(settings_.bottom_panel.c_str(), place);
  lumen::ui::Look& look = gui_.look();
  const auto tab = [&](const std::string& name, bool shown, const std::string& title) {
    const lumen::ui::FontScope font(look.heading);
    ImGui::PushStyleColor(ImGuiCol_Button, shown ? look.colors.field : lumen::ui::faded(look.colors.panel, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, shown ? look.colors.text : look.colors.label);
    if (ImGui::Button((title + "###tab " + name).c_str()) && !shown) commands_.run("panel." + name);
    lumen::ui::record("tab:" + name);
    ImGui::PopStyleColor(2);
    ImGui::SameLine(0, look(3));
  };
  const std::size_t count = workbench_.problems().size();
  for (const BottomPanel& bottom : bottom_panels_) {
    const bool problems = &bottom == &bottom_panels_.front();
    tab(bottom.name, &bottom == &bottom_panel(), bottom.panel->title(workshop_.session()) + (problems && count > 0 ? " " + std::to_string(count) : ""));
  }
  ImGui::NewLine();
  bottom_panel().panel->draw(workshop_.session(), workbench_);
}

void Application::take_keys(const std::vector<WindowEvent>& events) {
  const lumen::ui::Look& look = gui_.look();
  const bool typing = ImGui::GetIO().WantTextInput;
  const bool dialog = browser_.is_open() || question_.is_open() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  // A control under the pointer has these to itself.
  const bool taken = look.keys_frame == ImGui::GetFrameCount();
  for (const WindowEvent& event : events) {
    if (event.type != WindowEvent::Type::key || !event.down) continue;
    // Without ImGui's keyboard navigation, which would take the letter keys, popups do not know this key.
    if (dialog && event.name == "Esc" && !typing && !browser_.is_open() && !question_.is_open())
      ImGui::ClosePopupToLevel(std::max(0, ImGui::GetCurrentContext()->OpenPopupStack.Size - 1), true);
    if (dialog) continue;
    const bool editing_key = event.name == "Del" || event.name == "Backspace" || (event.control && (event.name == "C" || event.name == "V"));
    if (taken && editing_key) continue;
    if (!event.repeated && commands_.press(event.name, event.control, event.shift, typing)) continue;
    // While the view is dragged in, its picture is ImGui's active item.
    const bool gives_up = event.name == "Esc" && view_.input().captured();
    if (!typing && (ImGui::GetActiveID() == 0 || gives_up)) view_.key(event);
  }
}

}  // namespace lumenshop
