/// The helper process: started before GL, it forks a child for each piece of work that may die.
///
/// Children probe plugins and run worker modules with bounded memory and time. Their death is one message.
/// Thread: any; calls are serialized per child, several children run at once.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <lumen/worker.h>

namespace lumenshop {

class Helper {
 public:
  /// Starts `executable` (lumenshop-helper). Call before any GL. Throws lumen::Error.
  Helper(const std::filesystem::path& executable, const std::filesystem::path& workers_folder);
  ~Helper();

  /// Runs a worker module in a child. `progress` is called on this thread, every 50 ms at least, with how far it is; it
  /// cancels by returning false (then lumen::Cancelled is thrown and the child is killed). Throws lumen::Error: the worker's
  /// own message, "aorta.vtp: its reader ran out of memory (limit 256 MiB)", "... crashed (signal 11, SIGSEGV)", "... took longer than 600 s".
  lumen::WorkerReply run(const lumen::WorkerRequest& request, const std::function<bool(float)>& progress);

  /// Starts a child with the module loaded, so that the next run() of it has no start-up to wait for.
  void warm_up(const std::string& module);

  /// Loads a plugin library in a child and checks what `level` asks. Returns a description as JSON text (types and their
  /// properties). Throws lumen::Error saying how it failed.
  std::string probe(const std::filesystem::path& library, int level);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumenshop
