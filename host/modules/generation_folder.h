/// A private folder for the copies of libraries that this process has loaded.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace lumenshop {

/// Under $XDG_RUNTIME_DIR, else the folder for temporary files: where libraries may be loaded from, only its owner reads it.
/// It goes with this object; what killed processes left behind goes at the next start.
class GenerationFolder {
 public:
  GenerationFolder();   ///< throws lumen::Error
  ~GenerationFolder();
  GenerationFolder(const GenerationFolder&) = delete;
  GenerationFolder& operator=(const GenerationFolder&) = delete;

  /// Writes a file of a name that no file here had before: "occlusion.ssao.3.so". Throws lumen::Error.
  std::filesystem::path write(const std::filesystem::path& library, std::span<const std::byte> bytes);

 private:
  std::filesystem::path folder_;
  int next_ = 1;
};

}  // namespace lumenshop
