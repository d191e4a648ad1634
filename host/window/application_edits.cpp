// What commands do to the session: undo, add, remove, enable, rename.
#include <lumen/ui/edit.h>

#include "window/application.h"

namespace lumenshop {

void Application::attempt(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    toasts_.show(lumen::Severity::warning, "That does not work", error.what());
  }
}

void Application::history(void (History::*move)()) {
  lumen::ui::settle_now(workbench_);
  view_.let_go();
  attempt([&] { (session().history().*move)(); });
}

void Application::add(const std::string& type) {
  attempt([&] { workbench_.select(session().add(type).id()); });
}

void Application::remove_selected() {
  const std::string id = workbench_.selection();
  lumen::ui::settle_now(workbench_);
  attempt([&] { session().remove(id); });
}

void Application::toggle_selected() {
  const auto enabled = workbench_.property(workbench_.selection() + ".enabled");
  if (enabled && std::holds_alternative<bool>(enabled->value)) workbench_.set(workbench_.selection() + ".enabled", !std::get<bool>(enabled->value));
}

void Application::rename(const std::string& id, const std::string& to) {
  attempt([&] {
    session().rename(id, to);
    if (workbench_.selection().empty() || workbench_.selection() == id) workbench_.select(to);
  });
}

}  // namespace lumenshop
