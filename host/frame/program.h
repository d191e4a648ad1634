/// A linked GL program and its uniforms by name.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>
#include <glm/mat4x4.hpp>
#include <lumen/gl/texture.h>

namespace lumenshop {

/// A message of the driver's compiler: `file` is the number of the #line directives, 0 = generated text, -1 if none was said.
struct CompilerMessage {
  int file = -1, line = 0, column = 0;
  std::string text;
};

class Program {
 public:
  /// Compiles and links. `ok()` is false and `messages()` says why if the driver refused.
  Program(const std::string& vertex, const std::string& fragment);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  bool ok() const { return name_ != 0; }
  const std::vector<CompilerMessage>& messages() const { return messages_; }
  GLuint name() const { return name_; }
  void use() const { glUseProgram(name_); }
  void set(std::string_view uniform, int value);
  void set(std::string_view uniform, float value);
  void set(std::string_view uniform, const glm::vec4& value);
  void set(std::string_view uniform, const glm::mat4& value);
  /// Binds the texture to the sampler; a sampler that the program does not use is ignored.
  void bind(std::string_view sampler, GLuint texture);

 private:
  int location(std::string_view uniform);
  GLuint name_ = 0;
  std::map<std::string, int, std::less<>> locations_, units_;
  std::vector<CompilerMessage> messages_;
};

}  // namespace lumenshop
