#include "window/picture_texture.h"

#include <array>
#include <string>

#include <lumen/error.h>

namespace lumenshop {
namespace {

constexpr const char* vertex_text = R"(#version 450 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }
)";

constexpr const char* fragment_text = R"(#version 450 core
layout(binding = 0) uniform sampler2D picture;
layout(location = 0) uniform bool encode;
layout(location = 1) uniform vec3 canvas;  // sRGB
layout(location = 0) out vec4 result;
vec3 to_srgb(vec3 c) { return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-6)), vec3(1 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308))); }
vec3 from_srgb(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045))); }
void main() {
  vec4 color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  vec3 behind = (encode ? from_srgb(canvas) : canvas) * (1 - clamp(color.a, 0, 1));
  vec3 sum = clamp(color.rgb + behind, 0, 1);
  result = vec4(encode ? to_srgb(sum) : sum, 1);
}
)";

GLuint compiled(GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  std::array<char, 512> reason{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(reason.size()), nullptr, reason.data());
  glDeleteShader(shader);
  throw lumen::Error("window", std::string("the picture's shader does not compile: ") + reason.data());
}

}  // namespace

PictureTexture::PictureTexture() : vertices_(lumen::gl::VertexArray::create()) {
  const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_text), fragment = compiled(GL_FRAGMENT_SHADER, fragment_text);
  program_ = glCreateProgram();
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
}

PictureTexture::~PictureTexture() { glDeleteProgram(program_); }

void PictureTexture::update(const lumen::gl::Texture& picture, bool encode, glm::vec3 canvas, bool magnified) {
  if (!texture_ || texture_.size() != picture.size()) {
    framebuffer_ = {};
    texture_ = lumen::gl::Texture(lumen::Format::RGBA8, picture.size());
    if (magnified) texture_.linear();
    const lumen::gl::Texture* target = &texture_;
    framebuffer_ = lumen::gl::Framebuffer({&target, 1}, nullptr);
  }
  framebuffer_.bind();
  glViewport(0, 0, picture.size().x, picture.size().y);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glUseProgram(program_);
  glUniform1i(0, encode);
  glUniform3f(1, canvas.r, canvas.g, canvas.b);
  glBindTextureUnit(0, picture.name());
  vertices_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
}

}  // namespace lumenshop
