/// The shader files and the programs made of them.
///
/// Files are read once and again when they change. A program that does not compile keeps its last good version under
/// the same slot, and its errors are problems at file:line until they are mended.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <lumen/editor.h>

#include "frame/glsl_file.h"
#include "frame/program.h"

namespace lumenshop {

class ProgramText;

/// The #line numbers of a program: number i + 1 is files[i].
using FileNumbers = std::vector<std::string>;

class ShaderLibrary {
 public:
  /// Later folders are searched first. Files are named relative to their folder: "diffuse/lambert.glsl".
  explicit ShaderLibrary(std::vector<std::filesystem::path> folders);

  /// Throws lumen::Error if it is nowhere, longer than 1 MiB or cannot be taken apart.
  const GlslFile& file(const std::string& name);
  bool exists(const std::string& name);
  /// Grows with every change of the file, or of any file of lib/ and host/.
  std::uint64_t revision(const std::string& name);
  /// Grows with every change of any file.
  std::uint64_t revision() const { return changes_; }

  /// The program for a use ("wall geometry"). `assemble` writes its texts when `signature` or any file has changed.
  /// If it fails: the slot's last good program and a problem; null if there was none.
  Program* program(const std::string& slot, std::uint64_t signature, const std::function<void(ProgramText& vertex, ProgramText& fragment)>& assemble);

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
    std::uint64_t signature = 0;
    std::shared_ptr<Program> good;
    std::vector<lumen::Problem> problems;
  };
  lumen::Problem located(const std::string& slot, const CompilerMessage& message, const FileNumbers& files) const;
  std::vector<std::filesystem::path> folders_;
  std::map<std::string, Entry> files_;
  std::map<std::string, std::weak_ptr<Program>> programs_;  ///< by full text
  std::map<std::string, Slot> slots_;
  std::uint64_t changes_ = 1, lib_changes_ = 0;
};

}  // namespace lumenshop
