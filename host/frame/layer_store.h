/// The textures of a view's layers, by name, with a revision that grows whenever one is drawn anew.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include <lumen/gl/texture.h>

#include "frame/view_geometry.h"

namespace lumenshop {

class LayerStore {
 public:
  /// The texture, made anew if format or size differ.
  const lumen::gl::Texture& allocate(std::string_view name, lumen::Format format, glm::ivec2 size);
  /// Null if nobody allocated it.
  const lumen::gl::Texture* find(std::string_view name) const;
  std::uint64_t revision(std::string_view name) const;  ///< 0 = not there
  std::size_t bytes(std::string_view prefix) const;     ///< of all layers whose name begins so
  void drawn(std::string_view name);                    ///< its contents are new
  /// Where an allocated layer may hold anything but zero: everywhere, until who draws it knows better.
  PixelBox& nonzero(std::string_view name) { return layers_.find(name)->second.nonzero; }
  void drop(std::string_view name);
  void keep(std::initializer_list<std::string_view> names);  ///< drops all others
  void clear() { layers_.clear(); }

 private:
  struct Layer {
    lumen::gl::Texture texture;
    std::uint64_t revision = 0;
    PixelBox nonzero;
  };
  std::map<std::string, Layer, std::less<>> layers_;
  std::uint64_t clock_ = 0;
};

}  // namespace lumenshop
