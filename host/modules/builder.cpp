#include "modules/builder.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <lumen/error.h>

#include "process/spawn.h"

namespace lumenshop {

namespace {

constexpr std::size_t output_kept = 1 << 20;

void join(const lumen::Descriptor& events, const lumen::Descriptor& source) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = source.get();
  if (::epoll_ctl(events.get(), EPOLL_CTL_ADD, source.get(), &event) != 0) throw lumen::Error("build", std::string("cannot be watched: ") + std::strerror(errno));
}

}  // namespace

BuildDescription BuildDescription::load(const std::filesystem::path& file) {
  try {
    std::ifstream stream(file);
    const nlohmann::json json = nlohmann::json::parse(stream);
    BuildDescription description{json.at("sources").get<std::string>(), json.at("build").get<std::string>(), json.at("command").get<std::vector<std::string>>()};
    if (description.command.empty()) throw lumen::Error(file.string(), "its command is empty");
    return description;
  } catch (const nlohmann::json::exception& error) {
    throw lumen::Error(file.string(), std::string("is no build description: ") + error.what());
  }
}

Builder::Builder(BuildDescription description) : description_(std::move(description)), events_(::epoll_create1(EPOLL_CLOEXEC)) {
  if (!events_) throw lumen::Error("build", std::string("no descriptor: ") + std::strerror(errno));
}

Builder::~Builder() {
  if (!running()) return;
  // The compiler and ninja remove their half-written files when they are asked to end.
  end_group(SIGTERM);
  pollfd ended{exit_.get(), POLLIN, 0};
  if (::poll(&ended, 1, 2000) <= 0) end_group(SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Builder::end_group(int signal) const { ::kill(-process_, signal); }

void Builder::start() {
  if (!running()) return spawn_build();
  if (!again_) end_group(SIGTERM);
  again_ = true;
}

void Builder::spawn_build() {
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0) throw lumen::Error("build", std::string("no pipe: ") + std::strerror(errno));
  output_ = lumen::Descriptor(pipe[0]);
  const lumen::Descriptor theirs(pipe[1]);
  ::fcntl(output_.get(), F_SETFL, O_NONBLOCK);
  text_.clear();
  again_ = false;
  process_ = spawn({.arguments = description_.command, .folder = description_.build, .output = theirs.get(), .own_group = true});
  exit_ = lumen::Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, process_, 0)));
  join(events_, output_);
  join(events_, exit_);
}

void Builder::take_output() {
  std::array<char, 16384> buffer;
  ssize_t size;
  while (output_ && (size = ::read(output_.get(), buffer.data(), buffer.size())) >= 0) {
    if (size == 0) output_.reset();  // leaves the epoll by itself
    text_.append(buffer.data(), static_cast<std::size_t>(size));
    if (text_.size() > output_kept) text_.erase(0, text_.size() - output_kept);
  }
}

std::optional<Builder::Outcome> Builder::poll() {
  if (!running()) return std::nullopt;
  take_output();
  int status = 0;
  if (::waitpid(process_, &status, WNOHANG) != process_) return std::nullopt;
  take_output();
  process_ = -1;
  exit_.reset();
  output_.reset();
  if (again_) {
    spawn_build();
    return std::nullopt;
  }
  return Outcome{WIFEXITED(status) && WEXITSTATUS(status) == 0, std::move(text_)};
}

}  // namespace lumenshop
