#include "window/descriptor_watch.h"

#include <cerrno>
#include <cstdint>
#include <cstring>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <lumen/error.h>

namespace lumenshop {

DescriptorWatch::DescriptorWatch(int descriptor, std::function<void()> wake) : nudge_(eventfd(0, EFD_CLOEXEC)) {
  if (nudge_ < 0) throw lumen::Error("window", std::string("no eventfd: ") + std::strerror(errno));
  thread_ = std::thread([this, descriptor, wake = std::move(wake)] { run(descriptor, wake); });
}

DescriptorWatch::~DescriptorWatch() {
  stop_ = true;
  rearm();
  thread_.join();
  close(nudge_);
}

void DescriptorWatch::rearm() {
  ready_ = false;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = write(nudge_, &one, sizeof one);  // fails only if the counter is full: then it is readable
}

void DescriptorWatch::run(int descriptor, const std::function<void()>& wake) {
  while (!stop_) {
    // While what was found is not yet taken, only the nudge is waited for: the descriptor would be readable all the time.
    pollfd watched[2] = {{nudge_, POLLIN, 0}, {ready_ ? -1 : descriptor, POLLIN, 0}};
    if (poll(watched, 2, -1) < 0 && errno != EINTR) return;
    if (watched[0].revents & POLLIN) {
      std::uint64_t count = 0;
      [[maybe_unused]] const auto got = read(nudge_, &count, sizeof count);
    }
    if (watched[1].revents & (POLLERR | POLLHUP | POLLNVAL)) descriptor = -1;
    if (!stop_ && !ready_ && (watched[1].revents & POLLIN)) {
      ready_ = true;
      wake();
    }
  }
}

}  // namespace lumenshop
