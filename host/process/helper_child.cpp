#include "process/helper_child.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <poll.h>
#include <sys/wait.h>

#include <lumen/job.h>

#include "process/wire.h"

namespace lumenshop {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds progress_interval(50);
constexpr std::size_t printed_kept = 4096;

}  // namespace

bool HelperChild::alive() const {
  // Nothing but the news of its death comes from a child that waits for work.
  pollfd waited{channel_.descriptor(), POLLIN, 0};
  return ::poll(&waited, 1, 0) == 0;
}

Message HelperChild::wait(const Watch& watch) {
  const Clock::time_point deadline = Clock::now() + watch.time_limit;
  Clock::time_point next_progress = Clock::now();
  float fraction = 0;
  for (;;) {
    if (watch.progress && Clock::now() >= next_progress) {
      if (!watch.progress(fraction)) throw lumen::Cancelled();
      next_progress = Clock::now() + progress_interval;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>((watch.progress ? std::min(deadline, next_progress) : deadline) - Clock::now());
    std::array<pollfd, 2> waited{pollfd{channel_.descriptor(), POLLIN, 0}, pollfd{output_.get(), POLLIN, 0}};
    const int ready = ::poll(waited.data(), waited.size(), static_cast<int>(std::max(left, std::chrono::milliseconds(0)).count()));
    if (ready < 0 && errno != EINTR) throw lumen::Error(watch.subject, std::string("cannot wait for its process: ") + std::strerror(errno));
    if (Clock::now() >= deadline) throw lumen::Error(watch.subject, watch.actor + "took longer than " + watch.time_limit_text + (stage_.empty() ? "" : " while " + stage_));
    if (ready <= 0) continue;
    if (waited[1].revents != 0) take_output();
    if (waited[0].revents == 0) continue;

    std::optional<Message> message = channel_.receive();
    if (!message) throw lumen::Error(watch.subject, "the helper process ended", "it is started again at the next try");
    switch (message->type) {
      case MessageType::progress: fraction = std::clamp(WireReader(message->payload).real(), 0.0f, 1.0f); break;
      case MessageType::stage: stage_ = std::move(message->payload); break;
      case MessageType::out_of_memory: out_of_memory_ = true; break;
      case MessageType::reply: return std::move(*message);
      case MessageType::failure:
        if (out_of_memory_) throw_out_of_memory(watch);
        throw lumen::Error(message->payload);
      case MessageType::exited: throw_death(static_cast<int>(WireReader(message->payload).number()), watch);
      default: throw lumen::Error(watch.subject, "its process sent nonsense");
    }
  }
}

void HelperChild::take_output() {
  std::array<char, 4096> buffer;
  ssize_t size;
  while ((size = ::read(output_.get(), buffer.data(), buffer.size())) > 0) {
    printed_.append(buffer.data(), static_cast<std::size_t>(size));
    if (printed_.size() > printed_kept) printed_.erase(0, printed_.size() - printed_kept);
  }
  // Its end: not to be polled again, or the wait would spin.
  if (size == 0) output_.reset();
}

std::string HelperChild::last_line() const {
  std::size_t end = printed_.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return {};
  const std::size_t begin = printed_.find_last_of('\n', end);
  std::string line = printed_.substr(begin + 1, end - begin);
  line.erase(0, line.find_first_not_of(" \t"));
  std::erase_if(line, [](char letter) { return static_cast<unsigned char>(letter) < ' '; });
  return line.substr(0, 200);
}

void HelperChild::throw_out_of_memory(const Watch& watch) const {
  throw lumen::Error(watch.subject, watch.actor + "ran out of memory (limit " + std::to_string(watch.memory_limit >> 20) + " MiB)");
}

void HelperChild::throw_death(int status, const Watch& watch) {
  if (out_of_memory_) throw_out_of_memory(watch);
  if (output_) take_output();
  std::string what;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const char* const name = ::sigabbrev_np(signal);
    if (signal == SIGXCPU) what = "took longer than " + watch.time_limit_text;
    else if (signal == SIGKILL) what = "was killed (signal 9, SIGKILL)";
    else what = "crashed (signal " + std::to_string(signal) + (name ? std::string(", SIG") + name : "") + ")";
  } else {
    what = "ended by itself (exit code " + std::to_string(WEXITSTATUS(status)) + ")";
  }
  what.insert(0, watch.actor);
  if (!stage_.empty()) what += " while " + stage_;
  const std::string line = last_line();
  throw lumen::Error(watch.subject, line.empty() ? what : what + ": " + line);
}

}  // namespace lumenshop
