// The command table's contents.
#include <cctype>
#include <algorithm>

#include "window/application.h"

namespace lumenshop {

void Application::add_commands() {
  add_file_commands();
  add_edit_commands();
  add_view_commands();
  add_window_commands();
}

void Application::add_file_commands() {
  commands_.add({.id = "session.open", .menu = "File", .title = "Open...", .keys = "Ctrl+O", .run = [this] { ask_to_open(); }});
  commands_.add({.id = "session.save", .menu = "File", .title = "Save", .keys = "Ctrl+S", .run = [this] {
    if (session().file().empty()) ask_to_save();
    else save(session().file(), {});
  }});
  commands_.add({.id = "session.save_as", .menu = "File", .title = "Save as...", .keys = "Ctrl+Shift+S", .run = [this] { ask_to_save(); }});
  commands_.add({.id = "view.screenshot", .menu = "File", .title = "Write the picture", .keys = "F12", .run = [this] { screenshot(); },
                 .enabled = [this] { return !session().views().empty(); }, .separated = true});
  commands_.add({.id = "plugins.build", .menu = "File", .title = "Build plugins now", .keys = "F5", .run = [this] { reloader_->build_now(); }});
  commands_.add({.id = "window.quit", .menu = "File", .title = "Quit", .keys = "Ctrl+Q", .run = [this] {
    if (!question_.is_open()) unless_modified("leaving", [this] { closing_ = true; });
  }, .separated = true});
}

void Application::add_edit_commands() {
  const auto has_selection = [this] { return !workbench_.selection().empty(); };
  const auto has_plugin = [this] {
    const Instance* instance = session().find(workbench_.selection());
    return instance && instance->kind() != lumen::Kind::view;
  };
  commands_.add({.id = "edit.undo", .menu = "Edit", .title = "Undo", .keys = "Ctrl+Z", .run = [this] { history(&History::undo); },
                 .enabled = [this] { return session().history().can_undo() || !gui_.look().editing.empty(); }});
  commands_.add({.id = "edit.redo", .menu = "Edit", .title = "Redo", .keys = "Ctrl+Shift+Z", .run = [this] { history(&History::redo); },
                 .enabled = [this] { return session().history().can_redo(); }});
  commands_.add({.id = "edit.undo_camera", .menu = "Edit", .title = "Camera back", .keys = "BracketLeft", .run = [this] { history(&History::undo_camera); },
                 .enabled = [this] { return session().history().can_undo_camera(); }});
  commands_.add({.id = "edit.redo_camera", .menu = "Edit", .title = "Camera forward", .keys = "BracketRight", .run = [this] { history(&History::redo_camera); },
                 .enabled = [this] { return session().history().can_redo_camera(); }});
  commands_.add({.id = "edit.rename", .menu = "Edit", .title = "Rename", .keys = "F2", .run = [this] { outline_.begin_rename(workbench_.selection()); }, .enabled = has_selection, .separated = true});
  commands_.add({.id = "edit.enable", .menu = "Edit", .title = "Enable or disable", .keys = "H", .run = [this] { toggle_selected(); }, .enabled = has_plugin});
  commands_.add({.id = "edit.remove", .menu = "Edit", .title = "Delete", .keys = "Del", .run = [this] { remove_selected(); }, .enabled = has_selection});
  commands_.add({.id = "edit.add", .menu = "Add", .title = "Instance...", .keys = "Shift+A", .run = [this] {
    auto types = workshop_.registry().types();
    std::erase_if(types, [](const TypeInfo& type) { return type.kind == lumen::Kind::view; });
    add_popup_.open(std::move(types));
  }});
}

Command Application::view_key(const char* id, const char* title, const char* keys, bool separated) {
  // The camera understands these keys by itself; the table gives them a name, a menu and a place in the help.
  std::string name = keys;
  WindowEvent event;
  event.type = WindowEvent::Type::key;
  event.down = true;
  event.control = name.starts_with("Ctrl+");
  event.name = event.control ? name.substr(5) : name;
  return {.id = id, .menu = "View", .title = title, .keys = keys, .run = [this, event] { view_.key(event); },
          .enabled = [this] { return !session().views().empty(); }, .separated = separated};
}

void Application::add_view_commands() {
  commands_.add(view_key("view.fit", "Fit all", "Home"));
  commands_.add(view_key("view.fit_selection", "Fit the selection", "Period"));
  commands_.add(view_key("view.front", "Front", "1", true));
  commands_.add(view_key("view.right", "Right", "3"));
  commands_.add(view_key("view.top", "Top", "7"));
  commands_.add(view_key("view.back", "Back", "Ctrl+1"));
  commands_.add(view_key("view.left", "Left", "Ctrl+3"));
  commands_.add(view_key("view.bottom", "Bottom", "Ctrl+7"));
  commands_.add(view_key("view.orthographic", "Perspective or orthographic", "5", true));
  commands_.add({.id = "view.figure", .menu = "View", .title = "Figure mode", .keys = "F11", .run = [this] {
    figure_ = !figure_;
    window_.set_full_screen(figure_);
  }, .checked = [this] { return figure_; }, .separated = true});
  commands_.add({.id = "view.leave_figure", .menu = "", .title = "Leave figure mode", .keys = "Esc", .run = [this] {
    figure_ = false;
    window_.set_full_screen(false);
  }, .enabled = [this] { return figure_; }});
}

Command Application::bottom_command(const std::string& panel) {
  const auto shown = [this, panel] { return settings_.panels.bottom_open && bottom_panel().name == panel; };
  std::string title = panel;
  title.front() = char(std::toupper(static_cast<unsigned char>(title.front())));
  std::replace(title.begin(), title.end(), '_', ' ');
  const char* keys = panel == "problems" ? "Ctrl+M" : panel == "materials" ? "Shift+M" : "";
  return {.id = "panel." + panel, .menu = "Window", .title = title, .keys = keys, .run = [this, panel, shown] {
    settings_.panels.bottom_open = !shown();
    settings_.bottom_panel = panel;
    focus_bottom_ = settings_.panels.bottom_open;
    // Lines of text do with less than pictures and tables.
    if (panel != "problems") settings_.panels.bottom = std::max(settings_.panels.bottom, PanelSizes::bottom_roomy);
    save_settings();
  }, .checked = shown};
}

void Application::add_window_commands() {
  const auto panel = [this](bool PanelSizes::*open) {
    return [this, open] {
      settings_.panels.*open = !(settings_.panels.*open);
      save_settings();
    };
  };
  const auto shown = [this](bool PanelSizes::*open) { return [this, open] { return settings_.panels.*open; }; };
  commands_.add({.id = "window.outline", .menu = "Window", .title = "Outline", .keys = "T", .run = panel(&PanelSizes::outline_open), .checked = shown(&PanelSizes::outline_open)});
  commands_.add({.id = "window.properties", .menu = "Window", .title = "Properties", .keys = "N", .run = panel(&PanelSizes::properties_open), .checked = shown(&PanelSizes::properties_open)});
  for (const BottomPanel& panel : bottom_panels_) commands_.add(bottom_command(panel.name));
  commands_.add({.id = "window.panels", .menu = "Window", .title = "All panels", .keys = "Ctrl+B", .run = [this] {
    PanelSizes& panels = settings_.panels;
    const bool open = !(panels.outline_open || panels.properties_open || panels.bottom_open);
    panels.outline_open = panels.properties_open = panels.bottom_open = open;
    save_settings();
  }});
  commands_.add({.id = "window.reset", .menu = "Window", .title = "Reset layout", .run = [this] {
    settings_.panels = {};
    save_settings();
  }});
  const auto theme = [this](const char* id, const char* title, lumen::ui::Theme theme, bool separated) {
    commands_.add({.id = id, .menu = "Window", .title = title, .run = [this, theme] {
      settings_.theme = theme;
      apply_look_ = true;
    }, .checked = [this, theme] { return settings_.theme == theme; }, .separated = separated});
  };
  theme("window.dark", "Dark", lumen::ui::Theme::dark, true);
  theme("window.light", "Light", lumen::ui::Theme::light, false);
  theme("window.high_contrast", "High contrast", lumen::ui::Theme::high_contrast, false);
  const auto scale = [this](const char* id, const char* title, const char* keys, float change) {
    commands_.add({.id = id, .menu = "Window", .title = title, .keys = keys, .run = [this, change] {
      settings_.user_scale = change == 0 ? 1.0f : std::clamp(settings_.user_scale + change, 0.75f, 3.0f);
      apply_look_ = true;
    }, .separated = change > 0});
  };
  scale("window.larger", "Larger", "Ctrl+Plus", 0.25f);
  scale("window.smaller", "Smaller", "Ctrl+Minus", -0.25f);
  scale("window.normal_size", "Normal size", "Ctrl+0", 0);
  commands_.add({.id = "window.blender_keys", .menu = "Window", .title = "Mouse as in Blender", .run = [this] {
    settings_.blender_keys = !settings_.blender_keys;
    save_settings();
  }, .checked = [this] { return settings_.blender_keys; }, .separated = true});
  commands_.add({.id = "window.reduced_motion", .menu = "Window", .title = "Reduced motion", .run = [this] {
    settings_.reduced_motion = !settings_.reduced_motion;
    apply_look_ = true;
  }, .checked = [this] { return settings_.reduced_motion; }});
  commands_.add({.id = "help.keys", .menu = "Help", .title = "Keys and mouse", .keys = "F1", .run = [this] { open_help_ = true; }});
}

}  // namespace lumenshop
