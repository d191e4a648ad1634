/// A text header of three words, then rows of little- or big-endian floats from the bottom up.
#include "float_map.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>

#include <lumen/error.h>

void write_float_map(const lumen::Image& image, const std::string& path, const std::string& name) {
  const std::size_t channels = image.channels.size(), kept = channels >= 3 ? 3 : 1;
  const auto width = static_cast<std::size_t>(image.width);
  std::ofstream stream(path, std::ios::binary);
  // A negative scale says little-endian.
  stream << (kept == 3 ? "PF\n" : "Pf\n") << image.width << " " << image.height << "\n-1.0\n";
  std::vector<float> row(width * kept);
  for (int y = image.height - 1; y >= 0; --y) {
    const float* source = image.pixels.data() + static_cast<std::size_t>(y) * width * channels;
    for (std::size_t x = 0; x < width; ++x) std::copy_n(source + x * channels, kept, row.data() + x * kept);
    stream.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
  }
  if (!stream.flush()) throw lumen::Error(name, "cannot be written", "check the folder and the space on the disk");
}

std::shared_ptr<lumen::Image> read_float_map(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  std::ifstream stream(path, std::ios::binary);
  std::string magic;
  long width = 0, height = 0;
  double scale = 0;
  stream >> std::setw(3) >> magic >> width >> height >> scale;
  stream.get();  // the one white space before the numbers
  constexpr long largest_side = 1 << 16;
  if (!stream || (magic != "PF" && magic != "Pf") || scale == 0 || width < 1 || height < 1 || width > largest_side || height > largest_side)
    throw lumen::Error(file, "not a portable float map", "expected PF or Pf, width, height and scale");
  const std::size_t channels = magic == "PF" ? 3 : 1, per_row = static_cast<std::size_t>(width) * channels;
  const std::size_t numbers = per_row * static_cast<std::size_t>(height);
  std::error_code error;
  if (numbers > std::size_t{1} << 28 || numbers * sizeof(float) > std::filesystem::file_size(path, error))
    throw lumen::Error(file, "is cut off: its header names " + std::to_string(width) + " x " + std::to_string(height) + " pixels");

  std::vector<float> pixels(numbers);
  for (long y = height - 1; y >= 0; --y)
    stream.read(reinterpret_cast<char*>(pixels.data() + static_cast<std::size_t>(y) * per_row), static_cast<std::streamsize>(per_row * sizeof(float)));
  if (!stream) throw lumen::Error(file, "is cut off");
  if (scale > 0)
    for (float& number : pixels) number = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(number)));

  auto image = std::make_shared<lumen::Image>();
  image->origin = file;
  image->width = static_cast<int>(width);
  image->height = static_cast<int>(height);
  image->channels = channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
  image->pixels = std::move(pixels);
  image->finish();
  return image;
}
