/// Pictures: checks and bounds.
#include <lumen/image.h>

#include <set>

#include <checks/data_check.h>
#include <lumen/error.h>

namespace lumen {

std::size_t Image::bytes() const { return pixels.view().size_bytes(); }

Bounds Image::bounds() const {
  Bounds box;
  box.min = glm::vec3(0);
  box.max = glm::vec3(width, height, 0);
  return box;
}

std::string Image::summary() const {
  return grouped(std::size_t(width)) + " x " + grouped(std::size_t(height)) + " pixels, " + std::to_string(channels.size()) + " channels";
}

void Image::finish() {
  const auto fail = [&](const std::string& what) { throw Error(detail::name_of_origin(*this), what); };
  constexpr int largest_side = 1 << 20;
  if (width < 1 || height < 1 || width > largest_side || height > largest_side)
    fail("a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels; each side must be 1 to 1,048,576");
  if (channels.empty() || channels.size() > 1024) fail(std::to_string(channels.size()) + " channels; 1 to 1024 are possible");
  std::set<std::string_view> names;
  for (const std::string& channel : channels)
    if (channel.empty() || !names.insert(channel).second) fail("channel '" + channel + "' has no name of its own");
  const std::size_t wanted = std::size_t(width) * std::size_t(height) * channels.size();
  if (pixels.size() != wanted) fail(grouped(pixels.size()) + " numbers for " + grouped(wanted) + " of the pixels' channels");
}

}  // namespace lumen
