/// Tells which files in some folders have been written.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include <lumen/descriptor.h>

namespace lumenshop {

/// Thread: one at a time.
class Watcher {
 public:
  Watcher();   ///< throws lumen::Error

  /// Watches a folder, with all that is or comes below it if `recursive`. One that is not there (yet, or any more) is watched
  /// as soon as it is.
  void watch(const std::filesystem::path& folder, bool recursive);

  /// Readable when take() has something.
  int descriptor() const { return notify_.get(); }
  /// Files that were closed after writing or moved in since the last call, each once, in the order of their last change.
  std::vector<std::filesystem::path> take();

 private:
  struct Root {
    std::filesystem::path folder;
    bool recursive;
    bool watched = false;
  };
  struct Folder {
    std::filesystem::path path;
    bool recursive;
    bool only_waiting;   ///< for a missing root below it
  };
  bool add(const std::filesystem::path& folder, bool recursive, std::vector<std::filesystem::path>* files);
  void add_missing_roots(std::vector<std::filesystem::path>* files);

  lumen::Descriptor notify_;
  std::vector<Root> roots_;
  std::map<int, Folder> folders_;   ///< by watch number
};

}  // namespace lumenshop
