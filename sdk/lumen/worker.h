/// Worker modules: code that reads untrusted files or needs heavy libraries, in a process of its own.
///
/// A worker module is a library in the workers folder that only the helper process loads. Data goes both ways through
/// shared memory. The host checks all that comes back (sizes, indices, finite numbers).
#pragma once

#include <map>
#include <string>
#include <vector>

#include <lumen/abi.h>
#include <lumen/error.h>
#include <lumen/plugin.h>

namespace lumen {

struct WorkerRequest {
  std::string module;                            ///< "vtk", "openimageio"
  std::string verb;                              ///< what the module is to do: "read", "write"
  std::map<std::string, std::string> arguments;  ///< texts
  std::vector<DataPointer> inputs;
  std::string untrusted_file = {};               ///< bounds the memory: max(256 MiB, 200 times this file); empty = 4 GiB
};

struct WorkerReply {
  std::map<std::string, std::string> values;
  std::vector<DataPointer> data;
  struct Note { Severity severity; std::string text; };
  std::vector<Note> notes;                       ///< shown in Problems: "12 degenerate cells skipped"
};

/// How a worker says how far it is: 0..1. The process ends here when the job was cancelled.
using WorkerProgress = void (*)(float fraction);

/// The only symbol that a worker module exports, as `lumen_worker`.
struct WorkerTable {
  const char* abi;
  /// Throws Error (or any std::exception) on failure.
  void (*run)(const WorkerRequest& request, WorkerReply& reply, WorkerProgress progress);
};

}  // namespace lumen

/// Exports FUNCTION as the module's entry: once per module, at file scope.
#define LUMEN_WORKER(FUNCTION) \
  extern "C" [[gnu::visibility("default"), gnu::used]] const ::lumen::WorkerTable lumen_worker = {LUMEN_ABI, FUNCTION};
