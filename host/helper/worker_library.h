/// A worker module, loaded.
#pragma once

#include <filesystem>
#include <string>

#include <lumen/worker.h>

namespace lumenshop {

class WorkerLibrary {
 public:
  /// Loads <folder>/<module>.so. Throws lumen::Error: not there, cannot be loaded, another SDK's.
  WorkerLibrary(const std::filesystem::path& folder, std::string module);
  const std::string& module() const { return module_; }
  void run(const lumen::WorkerRequest& request, lumen::WorkerReply& reply, lumen::WorkerProgress progress) const { table_->run(request, reply, progress); }

 private:
  std::string module_;
  const lumen::WorkerTable* table_ = nullptr;
};

}  // namespace lumenshop
