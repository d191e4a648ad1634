#include "frame/layer_text.h"

#include <algorithm>

namespace lumenshop {

std::string accessor_text(const std::string& name, const std::string& sampler, int channels) {
  const char* types[] = {"", "float", "vec2", "vec3", "vec4"};
  const char* swizzles[] = {"", ".r", ".rg", ".rgb", ""};
  return std::string(types[channels]) + " " + name + "_at(vec2 uv) { return textureLod(" + sampler + ", uv, 0.0)" + swizzles[channels] + "; }\n";
}

std::string inputs_text(const lumen::TextureInputs& inputs) {
  std::string text;
  for (const auto& [name, texture] : inputs)
    text += std::string("uniform sampler2D ") + name + ";\n" + accessor_text(name, name, lumen::channels_of(texture->format()));
  return text;
}

std::string shader_file(const Instance& instance) {
  std::string file = instance.type();
  std::replace(file.begin(), file.end(), '.', '/');
  return file + ".glsl";
}

}  // namespace lumenshop
