/// The pictures that shaders read through image properties, side by side in one texture, so that a new picture recompiles
/// nothing and takes no texture unit of its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec4.hpp>
#include <lumen/editor.h>
#include <lumen/gl/texture.h>
#include <lumen/image.h>

namespace lumenshop {

/// Thread: main, GL context current.
class ImageAtlas {
 public:
  /// Makes these pictures (no nulls, no repetitions) the contents; uploads only if they are others than before.
  void update(std::vector<std::shared_ptr<const lumen::Image>> images);
  /// Where a picture lies: `image` in shaders/lib/values.glsl. Zero if it is not there.
  glm::vec4 place_of(const lumen::Image& image) const;
  const lumen::gl::Texture& texture() const { return texture_; }
  /// Pictures that do not fit into a texture of this GL.
  const std::vector<std::string>& refused() const { return refused_; }

 private:
  void arrange();
  std::vector<std::shared_ptr<const lumen::Image>> images_;
  std::vector<glm::ivec2> corners_;  ///< of each picture, texels; -1 = refused
  std::vector<std::string> refused_;
  lumen::gl::Texture texture_;
};

}  // namespace lumenshop
