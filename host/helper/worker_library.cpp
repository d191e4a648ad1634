#include "helper/worker_library.h"

#include <algorithm>

#include "modules/handshake.h"
#include "modules/load_library.h"

namespace lumenshop {

WorkerLibrary::WorkerLibrary(const std::filesystem::path& folder, std::string module) : module_(std::move(module)) {
  const bool well_formed = !module_.empty() && std::all_of(module_.begin(), module_.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
  });
  if (!well_formed) throw lumen::Error("worker module", "'" + module_ + "' is no module's name");
  const std::filesystem::path file = folder / (module_ + ".so");
  table_ = static_cast<const lumen::WorkerTable*>(find_symbol(load_library(file, "worker module " + module_), "lumen_worker"));
  if (!table_) throw lumen::Error("worker module " + module_, "it exports no lumen_worker");
  if (const std::string problem = abi_problem(table_->abi); !problem.empty()) throw lumen::Error("worker module " + module_, problem);
}

}  // namespace lumenshop
