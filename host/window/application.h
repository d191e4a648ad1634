/// The window's program: the session in its panels, commands, files, background work.
///
/// Thread: main. frame() is one ImGui frame; between frames update() takes what happened in the background.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "window/add_popup.h"
#include "window/command_table.h"
#include "window/descriptor_watch.h"
#include "window/editor_panel.h"
#include "window/file_browser.h"
#include "window/gui.h"
#include "window/live_frame_check.h"
#include "window/outline.h"
#include "window/question.h"
#include "window/restore.h"
#include "window/settings.h"
#include "window/toasts.h"
#include "window/view_panel.h"
#include "window/workbench.h"
#include "workshop.h"

namespace lumenshop {

class Application {
 public:
  struct Files {
    std::filesystem::path settings;  ///< read now, written when something changes; empty = neither
    std::filesystem::path state;     ///< the folder of copies of unsaved work; empty = none
  };
  Application(Workshop& workshop, GlfwWindow& window, Gui& gui, Files files);
  ~Application();

  void open(const std::vector<std::filesystem::path>& files);  ///< between frames; what fails becomes a toast
  void frame(const std::vector<WindowEvent>& events);
  /// Jobs, builds, reloads. True if there is something new to draw.
  bool update();
  bool busy() const { return view_.busy(); }             ///< wants the next frame at once
  double wake_at() const;                                ///< or one at this time; 0 = only after an event
  bool closing() const { return closing_; }

  SessionWorkbench& workbench() { return workbench_; }
  const CommandTable& commands() const { return commands_; }
  Session& session() { return workshop_.session(); }

 private:
  // application.cpp
  void draw_panels(const std::vector<WindowEvent>& events);
  void draw_bottom(const Rectangle& place);
  /// An installed editor other than the properties: a tab of the bottom panel each, the problems first.
  struct BottomPanel {
    std::string name;                      ///< "problems": its type's name
    std::unique_ptr<EditorPanel> panel;
  };
  void find_bottom_panels();
  BottomPanel& bottom_panel();             ///< the one that is shown
  void take_keys(const std::vector<WindowEvent>& events);
  void apply_look();
  void save_settings();
  std::string title() const;
  // application_commands.cpp
  void add_commands();
  void add_file_commands();
  void add_edit_commands();
  void add_view_commands();
  void add_window_commands();
  Command bottom_command(const std::string& panel);
  Command view_key(const char* id, const char* title, const char* keys, bool separated = false);
  // application_files.cpp
  void ask_to_open();
  void ask_to_save(std::function<void()> then = {});
  void save(const std::filesystem::path& file, const std::function<void()>& then);
  void unless_modified(const std::string& what, std::function<void()> then);
  void offer_restore();
  void take_drop(const std::vector<std::filesystem::path>& files);
  void browse(const std::string& from);
  void screenshot();
  // application_edits.cpp
  void attempt(const std::function<void()>& action);
  void history(void (History::*move)());
  void add(const std::string& type);
  void remove_selected();
  void toggle_selected();
  void rename(const std::string& id, const std::string& to);

  Workshop& workshop_;
  GlfwWindow& window_;
  Gui& gui_;
  std::filesystem::path settings_file_;
  Settings settings_;
  Restore restore_;
  std::optional<Restore::Leftover> restored_;   ///< what was restored: its copy stays until it is saved
  Toasts toasts_;
  CommandTable commands_;
  SessionWorkbench workbench_;
  LiveFrameCheck check_;
  std::unique_ptr<Reloader> reloader_;
  std::unique_ptr<DescriptorWatch> watch_;
  ViewPanel view_;
  Outline outline_;
  EditorPanel properties_;
  std::vector<BottomPanel> bottom_panels_;
  bool focus_bottom_ = false;              ///< a key opened it: it takes the keyboard
  FileBrowser browser_;
  Question question_;
  AddPopup add_popup_;
  bool figure_ = false, closing_ = false, open_help_ = false;
  std::function<void()> replace_;  ///< another session, before the next frame: this one still shows the old one's textures
  bool apply_look_ = false;   ///< theme or scale changed: before the next frame, for fonts cannot change within one
  std::string shown_title_;
  float shown_scale_ = 0;
};

}  // namespace lumenshop
