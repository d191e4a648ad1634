#include "model/regular_file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <lumen/error.h>

namespace lumenshop {
namespace {

/// An open file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  int reset() {
    const int result = number_ >= 0 ? ::close(number_) : 0;
    number_ = -1;
    return result;
  }

 private:
  int number_;
};

std::string reason() { return std::strerror(errno); }

std::string what_it_is(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

/// The folder's entry is on disk, too. Not every file system can: a failure here loses nothing that is written.
void sync_folder(const std::filesystem::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.get() >= 0) ::fsync(descriptor.get());
}

std::filesystem::path behind_links(const std::filesystem::path& file) {
  std::error_code failed;
  const auto target = std::filesystem::is_symlink(file, failed) ? std::filesystem::weakly_canonical(file, failed) : file;
  return failed ? file : target;
}

/// A new file of a name that nobody has, with the rights that the person's mask gives.
int create_beside(const std::filesystem::path& folder, const std::string& name, std::filesystem::path& created) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    created = folder / ("." + name + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp");
    const int descriptor = ::open(created.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

}  // namespace

std::string read_regular_file(const std::filesystem::path& file, std::size_t limit) {
  const std::string name = file.string();
  // O_NONBLOCK: opening a pipe that nobody writes would wait forever.
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (descriptor.get() < 0) throw lumen::Error(name, "cannot be opened: " + reason());
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0) throw lumen::Error(name, "cannot be read: " + reason());
  if (!S_ISREG(status.st_mode)) throw lumen::Error(name, "is " + what_it_is(status.st_mode) + ", not a regular file");
  const std::string too_large = "is larger than " + std::to_string(limit >> 20) + " MiB";
  if (static_cast<std::uint64_t>(status.st_size) > limit) throw lumen::Error(name, too_large);

  // Files of /proc say size 0, others may grow while they are read: the limit counts, not the size.
  std::string contents(static_cast<std::size_t>(status.st_size) + 1, '\0');
  std::size_t filled = 0;
  for (;;) {
    if (filled == contents.size()) contents.resize(std::min(limit + 1, 2 * contents.size() + 4096));
    const ssize_t count = ::read(descriptor.get(), contents.data() + filled, contents.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw lumen::Error(name, "cannot be read: " + reason());
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
    if (filled > limit) throw lumen::Error(name, too_large);
  }
  contents.resize(filled);
  return contents;
}

void write_file_atomically(const std::filesystem::path& file, std::string_view contents) {
  const std::filesystem::path target = behind_links(file);
  const std::string name = file.string();
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode)) throw lumen::Error(name, "is " + what_it_is(old.st_mode) + ", not a regular file; nothing was written");

  const auto folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
  std::filesystem::path temporary;
  Descriptor descriptor(create_beside(folder, target.filename().string(), temporary));
  if (descriptor.get() < 0) throw lumen::Error(name, "cannot be written: " + reason(), "choose a folder that exists and that you may write to");

  const auto fail = [&] {
    const std::string why = reason();
    ::unlink(temporary.c_str());
    throw lumen::Error(name, "cannot be written: " + why, exists ? "the old file is as it was" : "");
  };
  for (std::size_t written = 0; written < contents.size();) {
    const ssize_t count = ::write(descriptor.get(), contents.data() + written, contents.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail();
    written += static_cast<std::size_t>(count);
  }
  if (exists && ::fchmod(descriptor.get(), old.st_mode & 07777) != 0) fail();
  if (::fsync(descriptor.get()) != 0 || descriptor.reset() != 0) fail();
  if (::rename(temporary.c_str(), target.c_str()) != 0) fail();
  sync_folder(folder);
}

}  // namespace lumenshop
