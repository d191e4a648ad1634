#include "frame/program.h"

#include <cctype>
#include <cstdlib>
#include <sstream>

#include <glm/gtc/type_ptr.hpp>

#include "frame/glsl_file.h"

namespace lumenshop {
namespace {

/// Mesa writes "0:14(7): error: text", others "0(14) : error C0000: text": a number that is not used, line, perhaps column.
CompilerMessage parse_message(const std::string& line) {
  CompilerMessage message{.text = line};
  const char* at = line.c_str();
  if (line.rfind("ERROR: ", 0) == 0) at += 7;
  char* end = nullptr;
  std::strtol(at, &end, 10);
  if (end == at || (*end != ':' && *end != '(')) return message;
  const char* number = end + 1;
  const long row = std::strtol(number, &end, 10);
  if (end == number) return message;
  message.file = int(row / lines_per_file);
  message.line = int(row % lines_per_file);
  if (*end == '(') {
    message.column = int(std::strtol(end + 1, &end, 10));
    if (*end == ')') ++end;
  } else if (*end == ')') {
    ++end;
  }
  while (*end == ' ' || *end == ':') ++end;
  message.text = end;
  return message;
}

void append_log(const std::string& log, std::vector<CompilerMessage>& messages) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line != "\0") messages.push_back(parse_message(line));
}

GLuint compile(GLenum stage, const std::string& source, std::vector<CompilerMessage>& messages) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0, length = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(length > 0 ? length : 1), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  append_log(log.c_str(), messages);
  glDeleteShader(shader);
  return 0;
}

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment) {
  const GLuint first = compile(GL_VERTEX_SHADER, vertex, messages_);
  const GLuint second = compile(GL_FRAGMENT_SHADER, fragment, messages_);
  if (first != 0 && second != 0) {
    name_ = glCreateProgram();
    glAttachShader(name_, first);
    glAttachShader(name_, second);
    glLinkProgram(name_);
    GLint good = 0, length = 0;
    glGetProgramiv(name_, GL_LINK_STATUS, &good);
    if (!good) {
      glGetProgramiv(name_, GL_INFO_LOG_LENGTH, &length);
      std::string log(std::size_t(length > 0 ? length : 1), '\0');
      glGetProgramInfoLog(name_, length, nullptr, log.data());
      append_log(log.c_str(), messages_);
      glDeleteProgram(name_);
      name_ = 0;
    }
  }
  glDeleteShader(first);
  glDeleteShader(second);
}

Program::~Program() {
  if (name_ != 0) glDeleteProgram(name_);
}

int Program::location(std::string_view uniform) {
  const auto found = locations_.find(uniform);
  if (found != locations_.end()) return found->second;
  const std::string name(uniform);
  return locations_[name] = glGetUniformLocation(name_, name.c_str());
}

void Program::set(std::string_view uniform, int value) { glProgramUniform1i(name_, location(uniform), value); }
void Program::set(std::string_view uniform, float value) { glProgramUniform1f(name_, location(uniform), value); }
void Program::set(std::string_view uniform, const glm::vec4& value) { glProgramUniform4fv(name_, location(uniform), 1, glm::value_ptr(value)); }
void Program::set(std::string_view uniform, const glm::mat4& value) {
  glProgramUniformMatrix4fv(name_, location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::bind(std::string_view sampler, GLuint texture) {
  const int at = location(sampler);
  if (at < 0) return;
  const auto [unit, added] = units_.try_emplace(std::string(sampler), int(units_.size()));
  if (added) glProgramUniform1i(name_, at, unit->second);
  glBindTextureUnit(GLuint(unit->second), texture);
}

}  // namespace lumenshop
