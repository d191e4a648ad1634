/// The file of one frame of a sequence.
#pragma once

#include <filesystem>

namespace lumenshop {

/// Puts the frame's number into the name: in place of a run of # (as many digits), or of %d or %04d, else as _0001 before
/// the extension.
std::filesystem::path frame_name(const std::filesystem::path& pattern, int frame);

}  // namespace lumenshop
