// Files: open, save, drop, screenshot, and what is asked before work would be lost.
#include <algorithm>
#include <utility>

#include <lumen/ui/edit.h>

#include "command/picture_encoding.h"
#include "format_catalog.h"
#include "model/view.h"
#include "window/application.h"

namespace lumenshop {

void Application::open(const std::vector<std::filesystem::path>& files) {
  lumen::ui::settle_now(workbench_);
  view_.release();
  // Renderers remember revisions of instances by id: those of another session would look like the same ones.
  workshop_.close_views();
  try {
    workshop_.open(files);
    workbench_.select({});
    if (files.size() == 1 && files.front().extension() == ".json") {
      settings_.remember(files.front());
      save_settings();
    }
    // Something to look at in the panel from the start: what is drawn.
    for (const auto& plugin : session().plugins())
      if (plugin->kind() == lumen::Kind::renderer && workbench_.selection().empty()) workbench_.select(plugin->id());
  } catch (const std::exception& error) {
    toasts_.show(lumen::Severity::error, "Could not open " + (files.empty() ? std::string("nothing") : files.front().filename().string()), error.what());
  }
}

void Application::ask_to_open() {
  std::vector<std::string> extensions = FormatCatalog(workshop_.registry()).readable();
  extensions.push_back(".json");
  browser_.open("Open a session or data", session().folder(), std::move(extensions), [this](const std::filesystem::path& file) {
    unless_modified("opening another one", [this, file] { replace_ = [this, file] { open({file}); }; });
  });
}

void Application::ask_to_save(std::function<void()> then) {
  const std::string name = session().file().empty() ? "untitled.json" : session().file().filename().string();
  browser_.save("Save the session as", session().folder(), name, ".json", [this, then = std::move(then)](const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error) || file == session().file()) return save(file, then);
    question_.ask("Replace it?", file.filename().string() + " is there already.", {{"Replace", [this, file, then] { save(file, then); }}, {"Cancel"}});
  });
}

void Application::save(const std::filesystem::path& file, const std::function<void()>& then) {
  lumen::ui::settle_now(workbench_);
  attempt([&] {
    session().save(file);
    if (const auto leftover = std::exchange(restored_, std::nullopt)) Restore::discard(*leftover);
    settings_.remember(file);
    save_settings();
    toasts_.show(lumen::Severity::note, "Saved " + file.filename().string());
    if (then) then();
  });
}

void Application::unless_modified(const std::string& what, std::function<void()> then) {
  if (!session().modified() || session().plugins().empty()) return then();
  const auto save_first = [this, then] {
    if (session().file().empty()) ask_to_save(then);
    else save(session().file(), then);
  };
  question_.ask("Save changes?", "The session has changes that are not saved. Save them before " + what + "?", {{"Save", save_first}, {"Discard", then}, {"Cancel"}});
}

void Application::offer_restore() {
  auto leftover = restore_.find();
  if (!leftover) return;
  const std::string name = leftover->session.empty() ? "a session without a name" : leftover->session.filename().string();
  question_.ask("Restore unsaved work?", "The program ended unexpectedly. It kept " + name + " as it was at " + leftover->time + ".",
                {{"Restore", [this, leftover] { replace_ = [this, leftover] {
                    view_.release();
                    workshop_.close_views();
                    attempt([&] {
                      session().load(leftover->contents, leftover->folder);
                      restored_ = leftover;
                    });
                  }; }},
                 {"Discard", [leftover] { Restore::discard(*leftover); }},
                 {"Later"}});
}

void Application::take_drop(const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return;
  unless_modified("opening what was dropped", [this, files] { replace_ = [this, files] { open(files); }; });
}

void Application::browse(const std::string& from) {
  std::filesystem::path start = from.empty() ? session().folder() : std::filesystem::path(from);
  if (start.is_relative()) start = session().folder() / start;
  browser_.open("Choose a file", start, {}, [this](const std::filesystem::path& file) { gui_.look().browsed = file.string(); });
}

void Application::screenshot() {
  attempt([&] {
    ViewRenderer& view = workshop_.view(view_.view());
    view.resize(glm::max(view_.size(), glm::ivec2(1)));
    view.finish();
    std::filesystem::path folder = session().folder().empty() ? std::filesystem::current_path() : session().folder();
    const std::string stem = (session().file().empty() ? std::string("lumenshop") : session().file().stem().string()) + "-" + view_.view();
    std::filesystem::path file;
    std::error_code error;
    // Never over a picture that is there.
    for (int number = 1; number < 10'000 && (file.empty() || std::filesystem::exists(file, error)); ++number) file = folder / (stem + "-" + std::to_string(number) + ".png");
    const Instance* instance = session().find(view_.view());
    const auto* options = instance ? instance->as<View>(lumen::Kind::view) : nullptr;
    auto picture = displayable(*view.layer("color"), "color", {.encode_srgb = !options || options->encode_srgb, .extent = scene_extent(view.camera(), view.scene_bounds())});
    const FormatCatalog formats(workshop_.registry());
    workshop_.scheduler().write_file(formats.exporter_of(file, lumen::DataKind::image), std::move(picture), file);
    toasts_.show(lumen::Severity::note, "Wrote " + file.filename().string(), file.parent_path().string());
  });
}

}  // namespace lumenshop
