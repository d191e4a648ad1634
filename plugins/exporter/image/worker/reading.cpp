/// One file becomes one Image.
#include "pictures.h"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <OpenImageIO/imageio.h>

#include <lumen/error.h>

#include "float_map.h"

namespace {

float linear(float encoded) { return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f); }

/// Red, green, blue or gray, but neither alpha nor depth.
bool is_color(const OIIO::ImageSpec& spec, int channel) { return channel != spec.alpha_channel && channel != spec.z_channel; }

/// Some of its readers give no reason.
[[noreturn]] void fail(const std::string& file, const std::string& reason) {
  throw lumen::Error(file, "cannot be read: " + (reason.empty() ? "its contents are cut off or no picture" : reason));
}

bool is_float_map(const std::string& path) {
  char magic[3] = {};
  std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
  return magic[0] == 'P' && (magic[1] == 'F' || magic[1] == 'f') && std::isspace(static_cast<unsigned char>(magic[2]));
}

}  // namespace

void read_picture(const lumen::WorkerRequest& request, lumen::WorkerReply& reply, lumen::WorkerProgress progress) {
  const std::string& path = request.arguments.at("path");
  const std::string file = std::filesystem::path(path).filename().string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw lumen::Error(file, "there is no such file", "check the path " + path);
  if (!std::filesystem::is_regular_file(status)) throw lumen::Error(file, "is no regular file");

  if (is_float_map(path)) {
    reply.data.push_back(read_float_map(path));
    return;
  }
  const auto input = OIIO::ImageInput::open(path);
  if (!input) fail(file, OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  constexpr int largest_side = 1 << 16, most_channels = 1024;
  constexpr std::uint64_t most_numbers = std::uint64_t{1} << 28;
  if (spec.width < 1 || spec.height < 1 || spec.width > largest_side || spec.height > largest_side || spec.depth > 1 ||
      spec.nchannels < 1 || spec.nchannels > most_channels ||
      std::uint64_t(spec.width) * std::uint64_t(spec.height) * std::uint64_t(spec.nchannels) > most_numbers)
    throw lumen::Error(file, "claims " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " x " + std::to_string(spec.depth) +
                                 " pixels of " + std::to_string(spec.nchannels) + " channels, which is too large");
  progress(0.1f);

  std::vector<float> pixels(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())) fail(file, input->geterror());
  if (!spec.format.is_floating_point())
    for (std::size_t index = 0; index < pixels.size(); ++index)
      if (is_color(spec, static_cast<int>(index % std::size_t(spec.nchannels)))) pixels[index] = linear(pixels[index]);

  auto image = std::make_shared<lumen::Image>();
  image->origin = file;
  image->width = spec.width;
  image->height = spec.height;
  image->channels.assign(spec.channelnames.begin(), spec.channelnames.end());
  image->pixels = std::move(pixels);
  image->finish();
  reply.data.push_back(std::move(image));
}
