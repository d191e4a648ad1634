#include "frame/layer_store.h"

#include <algorithm>

namespace lumenshop {

const lumen::gl::Texture& LayerStore::allocate(std::string_view name, lumen::Format format, glm::ivec2 size) {
  Layer& layer = layers_[std::string(name)];
  if (!layer.texture || layer.texture.format() != format || layer.texture.size() != size) {
    layer.texture = lumen::gl::Texture();  // the old memory goes first
    layer.texture = lumen::gl::Texture(format, size);
    layer.revision = ++clock_;
    layer.nonzero = {glm::ivec2(0), size};
  }
  return layer.texture;
}

const lumen::gl::Texture* LayerStore::find(std::string_view name) const {
  const auto found = layers_.find(name);
  return found == layers_.end() ? nullptr : &found->second.texture;
}

std::uint64_t LayerStore::revision(std::string_view name) const {
  const auto found = layers_.find(name);
  return found == layers_.end() ? 0 : found->second.revision;
}

std::size_t LayerStore::bytes(std::string_view prefix) const {
  std::size_t sum = 0;
  for (auto layer = layers_.lower_bound(prefix); layer != layers_.end() && layer->first.starts_with(prefix); ++layer) {
    const lumen::gl::Texture& texture = layer->second.texture;
    sum += std::size_t(texture.size().x) * std::size_t(texture.size().y) * lumen::bytes_of(texture.format());
  }
  return sum;
}

void LayerStore::drawn(std::string_view name) {
  if (const auto found = layers_.find(name); found != layers_.end()) found->second.revision = ++clock_;
}

void LayerStore::keep(std::initializer_list<std::string_view> names) {
  std::erase_if(layers_, [&](const auto& layer) { return std::find(names.begin(), names.end(), layer.first) == names.end(); });
}

void LayerStore::drop(std::string_view name) {
  if (const auto found = layers_.find(name); found != layers_.end()) layers_.erase(found);
}

}  // namespace lumenshop
