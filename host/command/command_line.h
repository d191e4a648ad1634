/// The command line as plain values: what main() hands to the commands.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

namespace lumenshop {

/// Exit codes of the program.
enum ExitCode { exit_well = 0, exit_failed = 1, exit_usage = 2 };

/// The command line itself is wrong: exit_usage. what(): one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `--set ID.PROPERTY=VALUE`; the value is JSON, else a string.
struct Override {
  std::string path, value;
};

/// `--frames A:B`: both ends included; 25 frames are a second.
struct FrameRange {
  int first = 0, last = 0;
};

struct WindowOptions {
  std::vector<std::filesystem::path> files;
  glm::ivec2 size{1440, 900};                ///< pixels of the window
  std::filesystem::path script;              ///< steps of a person to play (window/script.h); empty = none
};

struct RenderOptions {
  std::vector<std::filesystem::path> files;  ///< one session, or data
  std::filesystem::path output;
  glm::ivec2 size{1280, 1024};               ///< pixels
  std::string view;                          ///< empty = the first
  std::string layer = "color";               ///< or "all"
  std::vector<Override> overrides;
  std::optional<FrameRange> frames;
};

struct ExportOptions {
  std::filesystem::path session;
  std::string property;                      ///< "instance.property"
  std::filesystem::path output;
  std::vector<Override> overrides;
};

struct BenchOptions {
  std::vector<std::filesystem::path> files;
  glm::ivec2 size{1280, 1024};
  int frames = 30;
  std::string view;
  std::vector<Override> overrides;
  bool still = false;                        ///< the camera does not turn
  bool final = false;                        ///< all refinements of each frame, not the first alone
  std::optional<Override> alternate;         ///< --set-each: `value` holds the values, separated by commas
  bool json = false;
  bool host_cpu = false;                     ///< only the CPU time of frames, see host_cpu.h
};

struct DescribeOptions {
  std::string type;                          ///< empty = all
  bool json = false;
};

struct CheckOptions {
  std::filesystem::path library;
  int level = 3;                             ///< 1..10
};

struct NewOptions {
  std::string kind, name;
  std::filesystem::path folder;              ///< of the sources; empty = those that this program was built from
};

struct CommandLine {
  std::vector<std::filesystem::path> plugin_folders;
  std::variant<WindowOptions, RenderOptions, ExportOptions, BenchOptions, DescribeOptions, CheckOptions, NewOptions> command;
};

/// What to run, or a text to print instead (help, version). Throws UsageError.
std::variant<CommandLine, std::string> parse_command_line(int argument_count, const char* const* arguments);

}  // namespace lumenshop
