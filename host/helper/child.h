/// A child of the helper process: one piece of work, then the end.
#pragma once

#include <filesystem>

#include "process/channel.h"

namespace lumenshop {

/// Does what comes through the channel and ends the process, without running destructors of what it loaded.
[[noreturn]] void serve(Channel channel, const std::filesystem::path& workers_folder);

}  // namespace lumenshop
