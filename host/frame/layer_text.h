/// GLSL by which passes read textures, and the names of shader files.
#pragma once

#include <string>

#include <lumen/frame.h>

#include "model/instance.h"

namespace lumenshop {

/// The function NAME_at(uv) over a sampler, with `channels` components.
std::string accessor_text(const std::string& name, const std::string& sampler, int channels);
/// Samplers and accessors of a pass's inputs.
std::string inputs_text(const lumen::TextureInputs& inputs);
/// "diffuse.lambert" -> "diffuse/lambert.glsl".
std::string shader_file(const Instance& instance);

}  // namespace lumenshop
