#include "frame/program_text.h"

#include <algorithm>
#include <cctype>

namespace lumenshop {

ProgramText::ProgramText(ShaderLibrary& library, GlslFile::Stage stage, FileNumbers& numbers)
    : library_(library), stage_(stage), numbers_(numbers), text_("#version 450 core\n") {}

int ProgramText::number_of(const std::string& name) {
  const auto found = std::find(numbers_.begin(), numbers_.end(), name);
  if (found != numbers_.end()) return int(found - numbers_.begin()) + 1;
  numbers_.push_back(name);
  return int(numbers_.size());
}

void ProgramText::generated(std::string_view text) {
  text_ += "#line 1\n";
  text_ += text;
  text_ += "\n";
}

void ProgramText::include(const std::string& name) {
  if (!included_.insert(name).second) return;
  const GlslFile& file = library_.file(name);
  for (const std::string& inner : file.includes()) include(inner);
  text_ += file.emit(stage_, {}, "", number_of(name));
}

void ProgramText::file(const std::string& name, std::vector<std::string_view> entries, std::string_view prefix) {
  const GlslFile& file = library_.file(name);
  for (const std::string& inner : file.includes()) include(inner);
  text_ += file.emit(stage_, entries, prefix, number_of(name));
}

std::string prefix_of(std::string_view file) {
  std::string prefix(file.substr(0, file.rfind('.')));
  for (char& c : prefix)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return prefix + "_";
}

const char* const fullscreen_triangle =
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 1.0, 1.0); }\n";

}  // namespace lumenshop
