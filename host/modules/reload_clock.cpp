#include "modules/reload_clock.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include <sys/timerfd.h>

#include <lumen/error.h>

namespace lumenshop {

namespace {

constexpr std::chrono::milliseconds quiet(10), longest(100);

}  // namespace

ReloadClock::ReloadClock() : timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)) {
  if (!timer_) throw lumen::Error("watching files", std::string("no timer: ") + std::strerror(errno));
}

void ReloadClock::changed() {
  const Clock::time_point now = Clock::now();
  if (!waiting_) first_ = now;
  waiting_ = true;
  due_ = std::min(now + quiet, first_ + longest);
  arm(std::max<Clock::duration>(due_ - now, std::chrono::nanoseconds(1)));
}

void ReloadClock::stop() {
  if (!waiting_) return;
  waiting_ = false;
  arm(Clock::duration(0));
}

bool ReloadClock::settled() const { return waiting_ && Clock::now() >= due_; }

void ReloadClock::arm(Clock::duration after) const {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(after);
  itimerspec when{};
  when.it_value.tv_sec = seconds.count();
  when.it_value.tv_nsec = std::chrono::nanoseconds(after - seconds).count();
  ::timerfd_settime(timer_.get(), 0, &when, nullptr);
}

}  // namespace lumenshop
