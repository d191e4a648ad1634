#include "window/window.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "installation.h"
#include "window/application.h"
#include "window/script.h"

namespace lumenshop {
namespace {

/// $XDG_STATE_HOME/lumenshop, by default ~/.local/state/lumenshop; empty without a home.
std::filesystem::path state_folder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state == '/') return std::filesystem::path(state) / "lumenshop";
  const char* home = std::getenv("HOME");
  return home && *home ? std::filesystem::path(home) / ".local/state/lumenshop" : std::filesystem::path();
}

constexpr int frames_after_event = 3;  // ImGui settles a change over up to three frames

/// How long the loop may sleep: 0 not at all, negative until something happens.
double sleep_time(const Application& application, int frames_due, const std::optional<Script>& script) {
  if (frames_due > 0 || application.busy()) return 0;
  const double now = GlfwWindow::time();
  double until = application.wake_at();
  if (script) {
    if (script->wake_at() == 0) return 0;
    until = until > 0 ? std::min(until, script->wake_at()) : script->wake_at();
  }
  return until > 0 ? std::max(1e-4, until - now) : -1;
}

}  // namespace

void wake_window() { GlfwWindow::wake(); }

int show_window(Workshop& workshop, const WindowSetup& setup) {
  std::optional<Script> script;
  if (!setup.script.empty()) script.emplace(setup.script);
  InputQueue queue;
  GlfwWindow window(setup.size, "Lumenshop", queue);
  Gui gui(window);
  const Application::Files files = script ? Application::Files{} : Application::Files{Installation::user_config() / "ui.json", state_folder()};
  Application application(workshop, window, gui, files);
  if (script) script->attach(application, gui, window, queue);
  if (!setup.files.empty()) application.open(setup.files);

  long frames = 0;
  int frames_due = frames_after_event;
  while (!application.closing()) {
    const double wake = application.wake_at();
    GlfwWindow::wait(sleep_time(application, frames_due, script));
    if (script) {
      script->step(frames);
      if (script->finished()) break;
      if (script->wake_at() == 0) frames_due = std::max(frames_due, 1);
    }
    if (!queue.empty()) frames_due = frames_after_event;
    if (application.update() || (wake > 0 && GlfwWindow::time() >= wake)) frames_due = std::max(frames_due, 1);
    if (frames_due == 0 && !application.busy()) continue;  // woken by something that changes nothing
    application.frame(queue.take_frame());
    if (script) script->after_frame();
    window.swap();
    ++frames;
    if (frames_due > 0) --frames_due;
  }
  if (!script || script->failures().empty()) return 0;
  std::fputs(script->failures().c_str(), stderr);
  return 1;
}

}  // namespace lumenshop
