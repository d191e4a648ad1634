#include "modules/watcher.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <sys/inotify.h>

#include <lumen/error.h>

namespace lumenshop {

namespace {

constexpr std::uint32_t interest = IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | IN_ONLYDIR;

void append(std::vector<std::filesystem::path>& files, std::filesystem::path file) {
  std::erase(files, file);
  files.push_back(std::move(file));
}

}  // namespace

Watcher::Watcher() : notify_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (!notify_) throw lumen::Error("watching files", std::string("the system gives no more: ") + std::strerror(errno), "raise fs.inotify.max_user_instances");
}

void Watcher::watch(const std::filesystem::path& folder, bool recursive) {
  roots_.push_back({folder, recursive});
  add_missing_roots(nullptr);
}

bool Watcher::add(const std::filesystem::path& folder, bool recursive, std::vector<std::filesystem::path>* files) {
  const int number = ::inotify_add_watch(notify_.get(), folder.c_str(), interest);
  if (number < 0) return false;
  folders_[number] = {folder, recursive, false};
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      if (recursive && !entry->is_symlink(ignored)) add(entry->path(), true, files);
    } else if (files) {
      append(*files, entry->path());
    }
  }
  return true;
}

void Watcher::add_missing_roots(std::vector<std::filesystem::path>* files) {
  for (Root& root : roots_) {
    if (root.watched) continue;
    root.watched = add(root.folder, root.recursive, files);
    // Something that will be made above it wakes us to look again.
    for (std::filesystem::path above = root.folder; !root.watched && above.has_relative_path();) {
      above = above.parent_path();
      const int number = ::inotify_add_watch(notify_.get(), above.c_str(), interest | IN_MASK_ADD);
      if (number < 0) continue;
      folders_.try_emplace(number, Folder{above, false, true});
      break;
    }
  }
}

std::vector<std::filesystem::path> Watcher::take() {
  std::vector<std::filesystem::path> files;
  alignas(inotify_event) std::array<char, 16384> buffer;
  bool look_again = false;
  ssize_t size;
  while ((size = ::read(notify_.get(), buffer.data(), buffer.size())) > 0) {
    for (const char* at = buffer.data(); at < buffer.data() + size;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(at);
      at += sizeof(inotify_event) + event->len;
      if ((event->mask & IN_Q_OVERFLOW) != 0) {
        // We do not know what we missed: everything may have changed.
        for (Root& root : roots_) root.watched = false;
        look_again = true;
        continue;
      }
      const auto found = folders_.find(event->wd);
      if (found == folders_.end()) continue;
      const Folder folder = found->second;
      if ((event->mask & IN_IGNORED) != 0) {
        folders_.erase(found);
        for (Root& root : roots_)
          if (root.folder == folder.path) root.watched = false;
        look_again = true;
        continue;
      }
      const std::filesystem::path path = folder.path / (event->len > 0 ? event->name : "");
      if ((event->mask & IN_ISDIR) != 0) {
        if (folder.recursive) add(path, true, &files);
        look_again = true;
      } else if (!folder.only_waiting && (event->mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) != 0) {
        append(files, path);
      }
    }
  }
  if (look_again) add_missing_roots(&files);
  return files;
}

}  // namespace lumenshop
