#include "command/host_cpu.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lumenshop {
namespace {

std::vector<std::string> own_arguments() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::string> arguments;
  for (std::size_t begin = 0; begin < text.size();) {
    arguments.emplace_back(text.c_str() + begin);
    begin += arguments.back().size() + 1;
  }
  return arguments;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

std::optional<Quartiles> host_cpu_of_child() {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return std::nullopt;

  std::vector<std::string> arguments = own_arguments();
  arguments.push_back("--host-cpu");
  std::vector<std::string> environment{"GALLIUM_NOOP=1"};
  for (char** variable = environ; *variable; ++variable) environment.emplace_back(*variable);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, pointers(arguments).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  close(pipe_ends[1]);
  if (failed) {
    close(pipe_ends[0]);
    return std::nullopt;
  }

  Quartiles cpu;
  std::FILE* reader = fdopen(pipe_ends[0], "r");
  const int read = std::fscanf(reader, "%lf %lf %lf", &cpu.first, &cpu.median, &cpu.third);
  std::fclose(reader);
  int status = 0;
  waitpid(child, &status, 0);
  return read == 3 && WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::optional(cpu) : std::nullopt;
}

}  // namespace lumenshop
