/// A shared library as bytes: whether it is complete, and what it exports, without loading it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace lumenshop {

class ElfFile {
 public:
  /// Reads the whole file. Throws lumen::Error: no regular file, changed while being read, incomplete (cut off, half
  /// written), no shared library of this machine.
  explicit ElfFile(const std::filesystem::path& file);

  const std::vector<std::byte>& bytes() const { return bytes_; }
  /// Names of all defined dynamic symbols that others can see.
  std::vector<std::string> exports() const;
  /// Whether loading it writes to its code.
  bool relocates_text() const;

 private:
  template <class T> T read(std::uint64_t offset) const;                        ///< throws lumen::Error if it lies outside
  template <class T> std::vector<T> table(std::uint64_t offset, std::uint64_t count) const;
  bool holds(std::uint64_t offset, std::uint64_t size) const;
  void check() const;
  [[noreturn]] void fail(const std::string& what, const std::string& advice = {}) const;
  [[noreturn]] void fail_incomplete() const;

  std::filesystem::path file_;
  std::vector<std::byte> bytes_;
};

}  // namespace lumenshop
