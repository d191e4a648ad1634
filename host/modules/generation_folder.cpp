#include "modules/generation_folder.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <lumen/descriptor.h>
#include <lumen/error.h>

namespace lumenshop {

namespace {

const std::string prefix = "lumenshop-generations-";

std::vector<std::filesystem::path> candidates() {
  std::vector<std::filesystem::path> folders;
  if (const char* const folder = std::getenv("XDG_RUNTIME_DIR"); folder && folder[0] == '/') folders.emplace_back(folder);
  std::error_code error;
  if (const std::filesystem::path folder = std::filesystem::temp_directory_path(error); !error) folders.push_back(folder);
  return folders;
}

bool may_execute(const std::filesystem::path& folder) {
  struct statvfs status {};
  return ::statvfs(folder.c_str(), &status) == 0 && (status.f_flag & ST_NOEXEC) == 0;
}

/// Removes the folders of processes that are gone.
void tidy(const std::filesystem::path& parent) {
  std::error_code error;
  for (std::filesystem::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const int process = std::atoi(name.c_str() + prefix.size());
    struct stat status {};
    const bool ours = ::lstat(entry->path().c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::geteuid();
    std::error_code ignored;
    if (ours && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) std::filesystem::remove_all(entry->path(), ignored);
  }
}

}  // namespace

GenerationFolder::GenerationFolder() {
  for (const std::filesystem::path& parent : candidates()) {
    if (!may_execute(parent)) continue;
    tidy(parent);
    std::string name = (parent / (prefix + std::to_string(::getpid()) + "-XXXXXX")).string();
    if (::mkdtemp(name.data())) {
      folder_ = name;
      return;
    }
  }
  throw lumen::Error("plugins", "there is no folder to copy libraries to", "set XDG_RUNTIME_DIR or TMPDIR to one that may hold programs");
}

GenerationFolder::~GenerationFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path GenerationFolder::write(const std::filesystem::path& library, std::span<const std::byte> bytes) {
  const std::filesystem::path file = folder_ / (library.stem().string() + "." + std::to_string(next_++) + ".so");
  const lumen::Descriptor descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0700));
  bool written = static_cast<bool>(descriptor);
  for (std::size_t done = 0; written && done < bytes.size();) {
    const ssize_t count = ::write(descriptor.get(), bytes.data() + done, bytes.size() - done);
    written = count > 0 || errno == EINTR;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  if (!written) throw lumen::Error(file.string(), std::string("cannot be written: ") + std::strerror(errno));
  return file;
}

}  // namespace lumenshop
