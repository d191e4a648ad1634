#include "process/spawn.h"

#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <lumen/error.h>

namespace lumenshop {

namespace {

class Actions {
 public:
  explicit Actions(const SpawnOptions& options) {
    ::posix_spawn_file_actions_init(&actions_);
    // Ours may have the numbers 0 to 3: they are moved before those are taken.
    if (options.channel >= 0) ::posix_spawn_file_actions_adddup2(&actions_, options.channel, 3);
    if (options.output >= 0) ::posix_spawn_file_actions_adddup2(&actions_, options.output, STDOUT_FILENO);
    else ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (!options.folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions_, options.folder.c_str());
  }
  ~Actions() { ::posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

class Attributes {
 public:
  explicit Attributes(const SpawnOptions& options) {
    ::posix_spawnattr_init(&attributes_);
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    int flags = POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK;
    if (options.own_group) flags |= POSIX_SPAWN_SETPGROUP;
    ::posix_spawnattr_setflags(&attributes_, static_cast<short>(flags));
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

}  // namespace

pid_t spawn(const SpawnOptions& options) {
  std::vector<std::string> copies = options.arguments;
  std::vector<char*> arguments;
  for (std::string& argument : copies) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  pid_t process = -1;
  const Actions actions(options);
  const Attributes attributes(options);
  if (const int error = ::posix_spawnp(&process, arguments[0], actions.get(), attributes.get(), arguments.data(), environ); error != 0)
    throw lumen::Error(options.arguments.at(0), std::string("it does not start: ") + std::strerror(error));
  return process;
}

}  // namespace lumenshop
