/// Layers as files hold them: 8-bit formats get displayable values, several layers become one picture.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include <lumen/camera.h>
#include <lumen/image.h>

namespace lumenshop {

/// EXR, PFM and HDR keep linear 32-bit numbers; all other formats get 8-bit-ready ones.
bool keeps_floats(const std::filesystem::path& file);

/// IEC 61966-2-1, linear 0..1 to encoded 0..1; clamps.
float srgb_encoded(float linear);

/// Near and far of the scene's bounding sphere along the view axis: eye distances in world units, near < far.
glm::vec2 scene_extent(const lumen::Camera& camera, const lumen::Bounds& scene);

struct DisplayOptions {
  bool encode_srgb = true;       ///< of colors
  glm::vec2 extent{0, 1};        ///< eye distances that depth 0 and 1 stand for
};

/// A layer in 0..1 for 8 bits: colors straight (not associated) and sRGB, alpha only if some pixel is not opaque;
/// normals .5 n + .5; depth over the extent; ids modulo 256 as bytes; all else clamped.
std::shared_ptr<lumen::Image> displayable(const lumen::Image& layer, const std::string& name, const DisplayOptions& options);

/// All layers in one picture: "diffuse.R", "depth.Z", "normal.X" ... They must have one size.
std::shared_ptr<lumen::Image> combined(const std::vector<std::pair<std::string, std::shared_ptr<lumen::Image>>>& layers);

}  // namespace lumenshop
