/// 8-bit RGB pictures for comparison: PNG files of the references and of what a failed test saw.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace lumenshop {

struct BytePicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< rows top-down
};

BytePicture read_png(const std::filesystem::path& file);                    ///< throws lumen::Error
void write_png(const BytePicture& picture, const std::filesystem::path& file);  ///< makes the folder; throws lumen::Error

/// The part of pixels of which some channel differs by more than `tolerance`; 1 if the sizes differ.
double differing_part(const BytePicture& a, const BytePicture& b, int tolerance);

}  // namespace lumenshop
