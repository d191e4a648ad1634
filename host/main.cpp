/// The program: parses, runs one command, and turns what it throws into one message and an exit code.
#include <cstdio>
#include <exception>
#include <variant>

#include "command/commands.h"

namespace {

using namespace lumenshop;

struct Run {
  const std::vector<std::filesystem::path>& plugin_folders;
  int operator()(const WindowOptions& options) const { return run_window(options, plugin_folders); }
  int operator()(const RenderOptions& options) const { return run_render(options, plugin_folders); }
  int operator()(const ExportOptions& options) const { return run_export(options, plugin_folders); }
  int operator()(const BenchOptions& options) const { return run_bench(options, plugin_folders); }
  int operator()(const DescribeOptions& options) const { return run_describe(options, plugin_folders); }
  int operator()(const CheckOptions& options) const { return run_check(options); }
  int operator()(const NewOptions& options) const { return run_new(options); }
};

}  // namespace

int main(int argument_count, char** arguments) {
  try {
    const auto parsed = parse_command_line(argument_count, arguments);
    if (const auto* text = std::get_if<std::string>(&parsed)) {
      std::fputs(text->c_str(), stdout);
      return exit_well;
    }
    const auto& line = std::get<CommandLine>(parsed);
    return std::visit(Run{line.plugin_folders}, line.command);
  } catch (const UsageError& error) {
    std::fprintf(stderr, "lumenshop: %s\nRun 'lumenshop --help' for what there is.\n", error.what());
    return exit_usage;
  } catch (const std::bad_alloc&) {
    std::fputs("lumenshop: out of memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lumenshop: %s\n", error.what());
  } catch (...) {
    std::fputs("lumenshop: ended by an unknown exception\n", stderr);
  }
  return exit_failed;
}
