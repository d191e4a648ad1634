/// The program without a face: session, plugins, jobs and helper process in their order of life. The window, the commands
/// and the tests are built on it.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "frame/view_renderer.h"
#include "jobs/scheduler.h"
#include "model/session.h"
#include "modules/registry.h"
#include "process/helper.h"

namespace lumenshop {

class ShaderLibrary;

class Workshop {
 public:
  struct Options {
    std::vector<std::filesystem::path> plugin_folders;  ///< beside the installation's and the user's
    std::vector<std::string> warm_workers;              ///< worker modules that will be wanted: they load beside the plugins
    std::function<void()> wake;                         ///< see Scheduler
  };
  /// Starts the helper process and loads the plugins. Call before any GL.
  explicit Workshop(Options options = {});
  ~Workshop();

  /// A session file (.json), or data files with a fitting view. Throws lumen::Error.
  void open(const std::vector<std::filesystem::path>& files);

  Helper& helper() { return *helper_; }
  Registry& registry() { return *registry_; }
  Session& session() { return *session_; }
  Scheduler& scheduler() { return *scheduler_; }
  /// Made at the first call; the GL context must be current then and whenever it goes.
  ShaderLibrary& shaders();
  /// Where shader files are: the installation's, and those that folders of plugins bring.
  std::vector<std::filesystem::path> shader_folders() const;
  ViewRenderer& view(const std::string& id = {});       ///< default: the first of the session
  void close_views();                                   ///< before the GL context goes
  std::vector<lumen::Problem> problems() const;         ///< of all

 private:
  std::unique_ptr<Helper> helper_;
  std::unique_ptr<Registry> registry_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Scheduler> scheduler_;
  std::unique_ptr<ShaderLibrary> shaders_;
  std::map<std::string, std::unique_ptr<ViewRenderer>> views_;
};

}  // namespace lumenshop
