#include <lumen/gl/texture.h>

#include <lumen/error.h>

namespace lumen::gl {
namespace {

struct Layout {
  GLenum internal, external, type;
};

Layout layout_of(Format format) {
  switch (format) {
    case Format::R8: return {GL_R8, GL_RED, GL_FLOAT};
    case Format::RG8: return {GL_RG8, GL_RG, GL_FLOAT};
    case Format::RGBA8: return {GL_RGBA8, GL_RGBA, GL_FLOAT};
    case Format::R16F: return {GL_R16F, GL_RED, GL_FLOAT};
    case Format::RG16F: return {GL_RG16F, GL_RG, GL_FLOAT};
    case Format::RGBA16F: return {GL_RGBA16F, GL_RGBA, GL_FLOAT};
    case Format::R32F: return {GL_R32F, GL_RED, GL_FLOAT};
    case Format::RG32F: return {GL_RG32F, GL_RG, GL_FLOAT};
    case Format::RGBA32F: return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case Format::R32UI: return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
    case Format::RG32UI: return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT};
    case Format::RGBA32UI: return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    case Format::depth32F: return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  throw Error("gl", "unknown texture format");
}

}  // namespace

Texture::Texture(Format format, glm::ivec2 size) : format_(format), size_(size) {
  glCreateTextures(GL_TEXTURE_2D, 1, &name_);
  glTextureStorage2D(name_, 1, layout_of(format).internal, size.x, size.y);
  glTextureParameteri(name_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(name_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(name_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture::~Texture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

void Texture::upload(const float* pixels) const { upload(pixels, {0, 0}, size_); }

void Texture::upload(const float* pixels, glm::ivec2 corner, glm::ivec2 size) const {
  const Layout layout = layout_of(format_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(name_, 0, corner.x, corner.y, size.x, size.y, layout.external, GL_FLOAT, pixels);
}

void Texture::linear() const {
  glTextureParameteri(name_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(name_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

std::vector<float> Texture::download() const {
  const Layout layout = layout_of(format_);
  const std::size_t count = std::size_t(size_.x) * size_.y * channels_of(format_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  std::vector<float> pixels(count);
  glFinish();  // Mesa 22.3's software driver may read a texture before all of it is drawn
  if (layout.type == GL_UNSIGNED_INT) {
    std::vector<GLuint> integers(count);
    glGetTextureImage(name_, 0, layout.external, GL_UNSIGNED_INT, GLsizei(count * sizeof(GLuint)), integers.data());
    pixels.assign(integers.begin(), integers.end());
  } else {
    glGetTextureImage(name_, 0, layout.external, GL_FLOAT, GLsizei(count * sizeof(float)), pixels.data());
  }
  return pixels;
}

}  // namespace lumen::gl
