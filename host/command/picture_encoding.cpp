#include "command/picture_encoding.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include <glm/common.hpp>

#include <lumen/error.h>

namespace lumenshop {
namespace {

/// What the numbers of a layer mean.
enum class Meaning { color, direction, depth, number, id };

Meaning meaning_of(const std::string& layer) {
  if (layer == "depth") return Meaning::depth;
  if (layer == "normal") return Meaning::direction;
  if (layer == "id") return Meaning::id;
  if (layer == "position" || layer == "occlusion" || layer == "opacity") return Meaning::number;
  return Meaning::color;
}

std::shared_ptr<lumen::Image> picture(const lumen::Image& like, std::vector<std::string> channels, lumen::Array<float> pixels) {
  auto image = std::make_shared<lumen::Image>();
  image->width = like.width;
  image->height = like.height;
  image->channels = std::move(channels);
  image->pixels = std::move(pixels);
  image->origin = like.origin;
  image->finish();
  return image;
}

/// srgb_encoded() by table: a step is a twentieth of an 8-bit one where the curve is steepest.
class SrgbTable {
 public:
  SrgbTable() : values_(65536) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = srgb_encoded(float(i) / 65535);
  }
  float operator()(float linear) const { return values_[linear > 0 ? std::uint32_t(std::min(linear, 1.0f) * 65535 + 0.5f) : 0]; }

 private:
  std::vector<float> values_;
};

std::shared_ptr<lumen::Image> displayable_color(const lumen::Image& layer, bool encode) {
  const std::size_t channels = layer.channels.size(), count = std::size_t(layer.width) * layer.height;
  const float* const stored = layer.pixels.data();
  bool translucent = false;
  if (channels == 4)
    for (std::size_t pixel = 0; pixel < count && !translucent; ++pixel) translucent = stored[4 * pixel + 3] < 0.9995f;
  const std::size_t kept = channels == 4 && !translucent ? 3 : channels;
  const SrgbTable encoded;
  const auto pixels = std::make_shared_for_overwrite<float[]>(count * kept);
  float* out = pixels.get();
  for (std::size_t pixel = 0; pixel < count; ++pixel) {
    const float* in = stored + pixel * channels;
    const float scale = translucent && in[3] > 0 ? 1 / in[3] : 1;
    for (std::size_t channel = 0; channel < std::min<std::size_t>(kept, 3); ++channel)
      *out++ = encode ? encoded(in[channel] * scale) : std::clamp(in[channel] * scale, 0.0f, 1.0f);
    if (kept == 4) *out++ = std::clamp(in[3], 0.0f, 1.0f);
  }
  std::vector<std::string> names(layer.channels.begin(), layer.channels.begin() + kept);
  if (kept >= 3) std::copy_n(std::begin({"R", "G", "B", "A"}), kept, names.begin());
  return picture(layer, std::move(names), {std::span<const float>(pixels.get(), count * kept), pixels});
}

}  // namespace

bool keeps_floats(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".exr" || extension == ".pfm" || extension == ".hdr";
}

float srgb_encoded(float linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 1;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

glm::vec2 scene_extent(const lumen::Camera& camera, const lumen::Bounds& scene) {
  if (scene.empty()) return {0, 1};
  const float radius = std::max(scene.radius(), 1e-6f);
  const float center = -(camera.view * glm::vec4(scene.center(), 1)).z;
  const float near = camera.orthographic ? center - radius : std::max(center - radius, 1e-4f * radius);
  return {near, std::max(center + radius, near + 1e-4f * radius)};
}

std::shared_ptr<lumen::Image> displayable(const lumen::Image& layer, const std::string& name, const DisplayOptions& options) {
  const Meaning meaning = meaning_of(name);
  if (meaning == Meaning::color) return displayable_color(layer, options.encode_srgb);
  std::vector<float> pixels(layer.pixels.begin(), layer.pixels.end());
  for (float& value : pixels) {
    switch (meaning) {
      case Meaning::direction: value = 0.5f * value + 0.5f; break;
      case Meaning::depth: value = (value - options.extent.x) / (options.extent.y - options.extent.x); break;
      case Meaning::id: value = std::fmod(std::max(value, 0.0f), 256.0f) / 255.0f; break;
      default: break;
    }
    value = std::isnan(value) ? 0.0f : std::clamp(value, 0.0f, 1.0f);
  }
  std::vector<std::string> channels = layer.channels;
  if (channels.size() == 3) channels = {"R", "G", "B"};
  if (channels.size() == 1) channels = {"Y"};
  return picture(layer, std::move(channels), std::move(pixels));
}

std::shared_ptr<lumen::Image> combined(const std::vector<std::pair<std::string, std::shared_ptr<lumen::Image>>>& layers) {
  if (layers.empty()) throw lumen::Error("layers", "there are none to write");
  const lumen::Image& first = *layers.front().second;
  std::vector<std::string> channels;
  for (const auto& [name, layer] : layers) {
    if (layer->width != first.width || layer->height != first.height) throw lumen::Error("layer " + name, "has another size than the others");
    for (const std::string& channel : layer->channels) channels.push_back(name + "." + channel);
  }
  const std::size_t count = std::size_t(first.width) * first.height;
  std::vector<float> pixels(count * channels.size());
  std::size_t offset = 0;
  for (const auto& [name, layer] : layers) {
    const std::size_t width = layer->channels.size();
    for (std::size_t pixel = 0; pixel < count; ++pixel)
      std::copy_n(&layer->pixels[pixel * width], width, &pixels[pixel * channels.size() + offset]);
    offset += width;
  }
  return picture(first, std::move(channels), std::move(pixels));
}

}  // namespace lumenshop
