/// Writing a file completely or not at all.
#pragma once

#include <string>

namespace lumen {

/// A name beside the target. What is written there becomes the target by commit(), else it goes with this object.
class TemporaryFile {
 public:
  /// Throws Error: no such folder, or the target is there and no regular file.
  explicit TemporaryFile(std::string target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }  ///< has the target's extension
  void commit();                                     ///< renames it to the target; throws Error

 private:
  std::string target_, path_;
};

}  // namespace lumen
