/// Files that hold a person's work: read only if they are plain files, written completely or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace lumenshop {

/// Never blocks (a pipe) and never reads without end (a device): anything but a regular file of at most `limit` bytes is
/// refused. Throws lumen::Error naming the file.
std::string read_regular_file(const std::filesystem::path& file, std::size_t limit);

/// Writes a temporary file beside it, syncs it and renames it over the old one. Throws lumen::Error; then the old file is
/// as it was and nothing is left behind. A symbolic link is kept, what it points to is replaced.
void write_file_atomically(const std::filesystem::path& file, std::string_view contents);

}  // namespace lumenshop
