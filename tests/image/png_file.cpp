#include "image/png_file.h"

#include <cstdlib>

#include <png.h>

#include <lumen/error.h>

namespace lumenshop {

BytePicture read_png(const std::filesystem::path& file) {
  png_image png{.version = PNG_IMAGE_VERSION};
  if (!png_image_begin_read_from_file(&png, file.c_str())) throw lumen::Error(file.string(), png.message);
  png.format = PNG_FORMAT_RGB;
  BytePicture picture{int(png.width), int(png.height), std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  if (!png_image_finish_read(&png, nullptr, picture.rgb.data(), 0, nullptr)) throw lumen::Error(file.string(), png.message);
  return picture;
}

void write_png(const BytePicture& picture, const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  png_image png{.version = PNG_IMAGE_VERSION, .width = png_uint_32(picture.width), .height = png_uint_32(picture.height), .format = PNG_FORMAT_RGB};
  if (!png_image_write_to_file(&png, file.c_str(), 0, picture.rgb.data(), 0, nullptr)) throw lumen::Error(file.string(), png.message);
}

double differing_part(const BytePicture& a, const BytePicture& b, int tolerance) {
  if (a.width != b.width || a.height != b.height || a.rgb.empty()) return 1;
  std::size_t differing = 0;
  for (std::size_t pixel = 0; pixel < a.rgb.size(); pixel += 3) {
    bool differs = false;
    for (std::size_t channel = 0; channel < 3; ++channel) differs |= std::abs(a.rgb[pixel + channel] - b.rgb[pixel + channel]) > tolerance;
    differing += differs;
  }
  return double(differing) / (double(a.rgb.size()) / 3);
}

}  // namespace lumenshop
