/// Assembles the two texts of a program from library files, generated code and plugins' files.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "frame/shader_library.h"

namespace lumenshop {

class ProgramText {
 public:
  ProgramText(ShaderLibrary& library, GlslFile::Stage stage, FileNumbers& numbers);

  void generated(std::string_view text);
  /// A library file with all that it includes, once.
  void include(const std::string& name);
  /// What `entries` reach in a plugin's file, its library files before it; names get `prefix`.
  void file(const std::string& name, std::vector<std::string_view> entries, std::string_view prefix);
  const std::string& text() const { return text_; }

 private:
  int number_of(const std::string& name);
  ShaderLibrary& library_;
  GlslFile::Stage stage_;
  FileNumbers& numbers_;
  std::set<std::string> included_;
  std::string text_;
};

/// "diffuse/lambert.glsl" -> "diffuse_lambert_".
std::string prefix_of(std::string_view file);

/// A vertex stage that makes a triangle over the whole target at the far plane, for full-screen passes.
extern const char* const fullscreen_triangle;

}  // namespace lumenshop
