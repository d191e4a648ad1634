/// The commands. Each returns an exit code; what ends it early is thrown as lumen::Error.
#pragma once

#include "command/command_line.h"

namespace lumenshop {

int run_window(const WindowOptions& options, const std::vector<std::filesystem::path>& plugin_folders);
int run_render(const RenderOptions& options, const std::vector<std::filesystem::path>& plugin_folders);
int run_export(const ExportOptions& options, const std::vector<std::filesystem::path>& plugin_folders);
int run_bench(const BenchOptions& options, const std::vector<std::filesystem::path>& plugin_folders);
int run_describe(const DescribeOptions& options, const std::vector<std::filesystem::path>& plugin_folders);
int run_check(const CheckOptions& options);
int run_new(const NewOptions& options);

}  // namespace lumenshop
