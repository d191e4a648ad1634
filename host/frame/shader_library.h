/// The shader files and the programs made of them.
///
/// Files are read once and again when they change. A program that does not compile keeps its last good version under
/// the same slot, and its errors are problems at file:line until they are mended.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <lumen/editor.h>

#include "frame/glsl_file.h"
#include "frame/program.h"

namespace lumenshop {

class ShaderLibrary {
 public:
  /// Later folders are searched first. Files are named relative to their folder: "diffuse/lambert.glsl".
  explicit ShaderLibrary(std::vector<std::filesystem::path> folders);

  /// Throws lumen::Error if it is nowhere, longer than 1 MiB or cannot be taken apart.
  const GlslFile& file(const std::string& name);
  bool exists(const std::string& name);
  /// Grows with every change of the file, or of any file of lib/; 0 for files that are nowhere.
  std::uint64_t revision(const std::string& name);
  /// Grows with every change of any file.
  std::uint64_t revision() const { return changes_; }

  /// The program of these texts. `slot` names its use ("lighting main"); `files` are the #line numbers' names.
  /// If it fails: the last good one of the slot, or null if there was none.
  std::shared_ptr<Program> program(const std::string& slot, const std::string& vertex, const std::string& fragment,
                                   const std::vector<std::string>& files);
  /// The file could not even be assembled: the slot's last good program, and the reason as a problem.
  std::shared_ptr<Program> last_good(const std::string& slot, const lumen::Problem& reason);

  /// Reads these files again when next asked for.
  void changed(const std::vector<std::filesystem::path>& files);
  std::vector<lumen::Problem> problems() const;
  std::filesystem::path find(const std::string& name) const;  ///< empty if it is nowhere

 private:
  struct Entry {
    std::unique_ptr<GlslFile> file;
    std::uint64_t revision = 1;
  };
  struct Slot {
    std::shared_ptr<Program> good;
    std::vector<lumen::Problem> problems;
  };
  std::vector<std::filesystem::path> folders_;
  std::map<std::string, Entry> files_;
  std::map<std::string, std::weak_ptr<Program>> programs_;  ///< by full text
  std::map<std::string, Slot> slots_;
  std::uint64_t changes_ = 1, lib_changes_ = 0;
};

}  // namespace lumenshop
