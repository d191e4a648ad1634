/// One Image becomes one file.
#include "pictures.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <OpenImageIO/imageio.h>

#include <lumen/error.h>

#include "float_map.h"

namespace {

constexpr const char* writable = "png exr pfm ppm jpg tif tga bmp hdr webp";

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return extension;
}

bool is_float_format(const std::string& extension) { return extension == ".exr" || extension == ".hdr"; }

/// The first channels of each pixel.
std::vector<float> first_channels(const lumen::Image& image, std::size_t kept) {
  const std::size_t channels = image.channels.size(), count = image.pixels.size() / channels;
  std::vector<float> result(count * kept);
  for (std::size_t pixel = 0; pixel < count; ++pixel) std::copy_n(image.pixels.data() + pixel * channels, kept, result.data() + pixel * kept);
  return result;
}

std::vector<std::uint8_t> rounded(std::span<const float> numbers) {
  std::vector<std::uint8_t> result(numbers.size());
  // NaN fails both comparisons and becomes black.
  std::transform(numbers.begin(), numbers.end(), result.begin(), [](float number) {
    return static_cast<std::uint8_t>(number > 0 ? (number < 1 ? number * 255.0f + 0.5f : 255.0f) : 0.0f);
  });
  return result;
}

}  // namespace

void write_picture(const lumen::WorkerRequest& request, lumen::WorkerProgress progress) {
  const std::string& path = request.arguments.at("path");
  const std::string name = request.arguments.contains("name") ? request.arguments.at("name") : path;
  const auto* image = request.inputs.empty() ? nullptr : dynamic_cast<const lumen::Image*>(request.inputs.front().get());
  if (!image) throw lumen::Error(name, "there is no picture to write");

  const std::string extension = lower_extension(path);
  if (extension == ".pfm") return write_float_map(*image, path, name);
  const auto output = OIIO::ImageOutput::create(path);
  if (!output) {
    OIIO::geterror();
    throw lumen::Error(name, "no picture format for '" + extension + "'", std::string("these can be written: ") + writable);
  }
  const std::string depth = request.arguments.contains("depth") ? request.arguments.at("depth") : "auto";
  const bool as_float = depth == "float" || (depth != "8" && is_float_format(extension));

  // Formats without an alpha channel or with fewer channels than the picture has get its first ones.
  auto channels = static_cast<int>(image->channels.size());
  if (channels > 4 && !output->supports("nchannels")) channels = 4;
  if (channels == 4 && !output->supports("alpha")) channels = 3;
  if (channels == 2 && extension != ".exr" && extension != ".tif" && extension != ".tiff" && extension != ".png") channels = 1;

  OIIO::ImageSpec spec(image->width, image->height, channels, as_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  spec.channelnames.assign(image->channels.begin(), image->channels.begin() + channels);
  const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
  spec.alpha_channel = alpha == spec.channelnames.end() ? -1 : static_cast<int>(alpha - spec.channelnames.begin());
  spec.attribute("Software", "lumenshop");
  spec.attribute("oiio:ColorSpace", as_float ? "Linear" : "sRGB");
  // Numbers are written as they are given: OpenImageIO must neither divide by alpha nor dither.
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("oiio:dither", 0);
  spec.attribute("CompressionQuality", 95);
  if (extension == ".exr") spec.attribute("compression", "zip");
  if (extension == ".png") spec.attribute("png:compressionLevel", 3);

  const std::vector<float> fewer = channels < static_cast<int>(image->channels.size()) ? first_channels(*image, static_cast<std::size_t>(channels)) : std::vector<float>();
  const std::span<const float> numbers = fewer.empty() ? image->pixels.view() : std::span<const float>(fewer);
  progress(0.2f);
  const auto fail = [&] { throw lumen::Error(name, "cannot be written: " + output->geterror()); };
  if (!output->open(path, spec)) fail();
  const bool written = as_float ? output->write_image(OIIO::TypeDesc::FLOAT, numbers.data()) : output->write_image(OIIO::TypeDesc::UINT8, rounded(numbers).data());
  if (!written) fail();
  if (!output->close()) fail();
}
