#include "frame/image_atlas.h"

#include <algorithm>
#include <numeric>

namespace lumenshop {
namespace {

/// Four floats per pixel: gray spreads to RGB, a missing alpha is 1.
std::vector<float> rgba(const lumen::Image& image) {
  const std::size_t channels = image.channels.size(), pixels = std::size_t(image.width) * std::size_t(image.height);
  std::vector<float> result(pixels * 4, 1.0f);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* from = image.pixels.data() + i * channels;
    float* to = &result[i * 4];
    if (channels < 3) {
      std::fill_n(to, 3, from[0]);
      if (channels == 2) to[3] = from[1];
    } else {
      std::copy_n(from, std::min<std::size_t>(channels, 4), to);
    }
  }
  return result;
}

}  // namespace

void ImageAtlas::update(std::vector<std::shared_ptr<const lumen::Image>> images) {
  if (texture_ && images == images_) return;
  images_ = std::move(images);
  arrange();
  for (std::size_t i = 0; i < images_.size(); ++i)
    if (corners_[i].x >= 0) texture_.upload(rgba(*images_[i]).data(), corners_[i], {images_[i]->width, images_[i]->height});
}

void ImageAtlas::arrange() {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  corners_.assign(images_.size(), glm::ivec2(-1));
  refused_.clear();
  std::vector<std::size_t> order(images_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return images_[a]->height > images_[b]->height; });
  // Rows of pictures from high to low; as wide as the widest picture or a comfortable square.
  double area = 0;
  int widest = 1;
  for (const auto& image : images_) {
    area += double(image->width) * image->height;
    if (image->width <= largest) widest = std::max(widest, image->width);
  }
  const int width = std::clamp(int(std::sqrt(area)), widest, std::max<int>(largest, widest));
  glm::ivec2 pen(0), used(1);
  int row_height = 0;
  for (const std::size_t i : order) {
    const glm::ivec2 size(images_[i]->width, images_[i]->height);
    if (pen.x + size.x > width) {
      pen = {0, pen.y + row_height};
      row_height = 0;
    }
    if (size.x > width || pen.y + size.y > largest) {
      refused_.push_back(images_[i]->origin + ": the pictures of this session do not fit into one texture of " + std::to_string(largest) + " texels");
      continue;
    }
    corners_[i] = pen;
    pen.x += size.x;
    row_height = std::max(row_height, size.y);
    used = glm::max(used, corners_[i] + size);
  }
  if (texture_ && texture_.size() == used) return;
  texture_ = lumen::gl::Texture();  // the old memory goes first
  texture_ = lumen::gl::Texture(lumen::Format::RGBA32F, used);
  texture_.linear();
}

glm::vec4 ImageAtlas::place_of(const lumen::Image& image) const {
  for (std::size_t i = 0; i < images_.size(); ++i)
    if (images_[i].get() == &image && corners_[i].x >= 0) {
      const glm::vec2 size(texture_.size()), corner(corners_[i]), extent(image.width, image.height);
      // Pictures begin at the top, texture coordinates at the bottom.
      return {corner.x / size.x, (corner.y + extent.y) / size.y, extent.x / size.x, -extent.y / size.y};
    }
  return glm::vec4(0);
}

}  // namespace lumenshop
