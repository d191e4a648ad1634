#include "helper/zygote.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>

#include <lumen/error.h>

#include "helper/child.h"
#include "process/wire.h"

namespace lumenshop {

namespace {

sigset_t child_signal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGCHLD);
  return set;
}

/// The first steps of a new child: nothing of the helper process stays but the child's own channel.
[[noreturn]] void become_child(const Channel& channel, const lumen::Descriptor& output, pid_t parent, const std::filesystem::path& workers_folder) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  const sigset_t set = child_signal();
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
  ::dup2(output.get(), STDOUT_FILENO);
  ::dup2(output.get(), STDERR_FILENO);
  constexpr int own = 3;
  if (::dup3(channel.descriptor(), own, O_CLOEXEC) < 0) ::_exit(1);
  ::close_range(own + 1, ~0U, 0);
  serve(Channel(lumen::Descriptor(own)), workers_folder);
}

}  // namespace

Zygote::Zygote(Channel program, std::filesystem::path workers_folder) : program_(std::move(program)), workers_folder_(std::move(workers_folder)) {
  ::close_range(static_cast<unsigned>(program_.descriptor()) + 1, ~0U, 0);
  const sigset_t set = child_signal();
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
  signals_ = lumen::Descriptor(::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
  if (!signals_) throw lumen::Error("helper process", "no descriptor for signals");
}

Zygote::~Zygote() {
  for (const Child& child : children_) ::kill(child.process, SIGKILL);
  for (const Child& child : children_) ::waitpid(child.process, nullptr, 0);
}

void Zygote::run() {
  std::vector<pollfd> waited;
  for (;;) {
    waited = {{program_.descriptor(), POLLIN, 0}, {signals_.get(), POLLIN, 0}};
    // No events asked for: only the program's hanging up wakes us. Messages are the child's.
    for (const Child& child : children_) waited.push_back({child.killed ? -1 : child.channel.descriptor(), 0, 0});
    if (::poll(waited.data(), waited.size(), -1) < 0 && errno != EINTR) return;
    for (std::size_t index = 0; index < children_.size(); ++index) {
      if ((waited[index + 2].revents & (POLLHUP | POLLERR)) == 0) continue;
      ::kill(children_[index].process, SIGKILL);
      children_[index].killed = true;
    }
    if (waited[1].revents != 0) reap();
    if (waited[0].revents != 0 && !take_order()) return;
  }
}

bool Zygote::take_order() {
  std::optional<Message> order = program_.receive();
  if (!order) return false;
  if (order->type == MessageType::fork && order->descriptors.size() == 2) start_child(std::move(*order));
  return true;
}

void Zygote::start_child(Message order) {
  Channel channel(std::move(order.descriptors[0]));
  const lumen::Descriptor output = std::move(order.descriptors[1]);
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) become_child(channel, output, parent, workers_folder_);
  if (process < 0) {
    channel.send_if_possible(MessageType::failure, std::string("no process for it: ") + std::strerror(errno));
    return;
  }
  children_.push_back({process, std::move(channel)});
}

void Zygote::reap() {
  signalfd_siginfo information;
  while (::read(signals_.get(), &information, sizeof information) > 0) {
  }
  int status;
  for (pid_t process; (process = ::waitpid(-1, &status, WNOHANG)) > 0;) {
    const auto child = std::find_if(children_.begin(), children_.end(), [&](const Child& candidate) { return candidate.process == process; });
    if (child == children_.end()) continue;
    WireWriter writer;
    writer.number(static_cast<std::uint64_t>(status));
    child->channel.send_if_possible(MessageType::exited, writer.take());
    children_.erase(child);
  }
}

}  // namespace lumenshop
