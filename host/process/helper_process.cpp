#include "process/helper_process.h"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <lumen/error.h>

#include "process/spawn.h"

namespace lumenshop {

HelperProcess::HelperProcess(std::filesystem::path executable, std::filesystem::path workers_folder)
    : executable_(std::move(executable)), workers_folder_(std::move(workers_folder)) {
  start();
}

HelperProcess::~HelperProcess() { stop(); }

void HelperProcess::start() {
  auto [ours, theirs] = Channel::connected();
  process_ = spawn({.arguments = {executable_.string(), workers_folder_.string()}, .channel = theirs.descriptor()});
  channel_ = std::move(ours);
}

void HelperProcess::stop() {
  if (process_ < 0) return;
  channel_ = Channel();   // it ends its children and itself when it sees this
  const lumen::Descriptor ended(static_cast<int>(::syscall(SYS_pidfd_open, process_, 0)));
  pollfd waited{ended.get(), POLLIN, 0};
  constexpr int patience_ms = 500;
  if (!ended || ::poll(&waited, 1, patience_ms) != 1) ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

HelperChild HelperProcess::fork_child() {
  auto [ours, theirs] = Channel::connected();
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0) throw lumen::Error("helper process", std::string("no pipe: ") + std::strerror(errno));
  lumen::Descriptor output(pipe[0]);
  Message order{MessageType::fork};
  order.descriptors.push_back(theirs.release());
  order.descriptors.emplace_back(pipe[1]);
  ::fcntl(output.get(), F_SETFL, O_NONBLOCK);

  const std::lock_guard lock(mutex_);
  if (process_ < 0 || !channel_.send(order)) {
    stop();
    start();
    if (!channel_.send(order)) throw lumen::Error(executable_.string(), "the helper process ends at once", "build or install it again");
  }
  return HelperChild(std::move(ours), std::move(output));
}

pid_t HelperProcess::process() const {
  const std::lock_guard lock(mutex_);
  return process_;
}

}  // namespace lumenshop
