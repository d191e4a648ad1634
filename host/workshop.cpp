#include "workshop.h"

#include <lumen/error.h>

#include "format_catalog.h"
#include "frame/shader_library.h"
#include "installation.h"

namespace lumenshop {
namespace {

std::vector<std::filesystem::path> plugin_folders(const Installation& installation, const std::vector<std::filesystem::path>& more) {
  std::vector<std::filesystem::path> folders{installation.plugins()};
  if (const auto users = Installation::user_plugins(); std::filesystem::is_directory(users)) folders.push_back(users);
  for (const auto& folder : more) {
    if (!std::filesystem::is_directory(folder)) throw lumen::Error(folder.string(), "no such folder of plugins");
    folders.push_back(std::filesystem::absolute(folder).lexically_normal());
  }
  return folders;
}

}  // namespace

Workshop::Workshop(Options options) {
  const Installation installation = Installation::find();
  helper_ = std::make_unique<Helper>(installation.helper(), installation.workers());
  for (const std::string& module : options.warm_workers) helper_->warm_up(module);
  registry_ = std::make_unique<Registry>(plugin_folders(installation, options.plugin_folders), helper_.get());
  registry_->load_all();
  session_ = std::make_unique<Session>(*registry_);
  scheduler_ = std::make_unique<Scheduler>(*session_, helper_.get(), std::move(options.wake));
}

Workshop::~Workshop() = default;

void Workshop::open(const std::vector<std::filesystem::path>& files) {
  const auto is_session = [](const std::filesystem::path& file) { return file.extension() == ".json"; };
  if (files.size() == 1 && is_session(files.front())) {
    session_->load(files.front());
    return;
  }
  for (const auto& file : files) {
    if (is_session(file)) throw lumen::Error(file.string(), "a session is opened alone, without other files");
    if (!std::filesystem::exists(file)) throw lumen::Error(file.string(), "no such file");
  }
  const FormatCatalog formats(*registry_);
  session_->load_data(files, [&](const std::filesystem::path& file) { return formats.importer_of(file); });
}

ShaderLibrary& Workshop::shaders() {
  if (!shaders_) shaders_ = std::make_unique<ShaderLibrary>(shader_folders());
  return *shaders_;
}

std::vector<std::filesystem::path> Workshop::shader_folders() const {
  std::vector<std::filesystem::path> folders{Installation::find().shaders()};
  for (const auto& folder : registry_->folders())
    if (std::filesystem::is_directory(folder / "shaders")) folders.push_back(folder / "shaders");
  return folders;
}

ViewRenderer& Workshop::view(const std::string& id) {
  if (id.empty() && session_->views().empty())
    throw lumen::Error(session_->file().empty() ? "session" : session_->file().string(), "has no view to draw");
  const std::string name = id.empty() ? session_->views().front()->id() : id;
  if (const Instance* instance = session_->find(name); !instance || instance->kind() != lumen::Kind::view) {
    std::string views;
    for (const auto& view : session_->views()) views += (views.empty() ? "" : ", ") + view->id();
    throw lumen::Error(name, "no such view", "the session has: " + (views.empty() ? std::string("none") : views));
  }
  std::unique_ptr<ViewRenderer>& renderer = views_[name];
  if (!renderer) renderer = std::make_unique<ViewRenderer>(*session_, shaders(), name);
  return *renderer;
}

void Workshop::close_views() {
  views_.clear();
  shaders_.reset();
}

std::vector<lumen::Problem> Workshop::problems() const {
  std::vector<lumen::Problem> all = registry_->problems();
  const auto append = [&](const std::vector<lumen::Problem>& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(session_->problems());
  for (const auto& [id, renderer] : views_) append(renderer->problems());
  return all;
}

}  // namespace lumenshop
