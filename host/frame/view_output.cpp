// What leaves a ViewRenderer: the picture, layers as images, and what is under a pixel.

#include <algorithm>
#include <limits>
#include <memory>
#include <span>

#include <lumen/gl/framebuffer.h>

#include "frame/hash.h"
#include "frame/view_state.h"

namespace lumenshop {
namespace {

/// A layer's channels in images, and how many of the texture's it takes; no channels: not a layer of this name.
std::vector<std::string> channels_of_layer(std::string_view name) {
  if (name == "color" || name == "transparent") return {"R", "G", "B", "A"};
  if (name == "albedo" || name == "ambient" || name == "diffuse" || name == "specular" || name == "id") return {"R", "G", "B"};
  if (name == "normal" || name == "position") return {"X", "Y", "Z"};
  if (name == "depth") return {"Z"};
  if (name == "occlusion" || name == "opacity") return {"Y"};
  return {};
}

/// Pixels of one row, as floats: channels_of(format) each.
void download_row(const lumen::gl::Texture& texture, glm::ivec2 begin, int width, float* row) {
  const int channels = lumen::channels_of(texture.format());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  if (texture.format() == lumen::Format::RGBA32UI) {
    std::vector<GLuint> numbers(std::size_t(width) * std::size_t(channels));
    glGetTextureSubImage(texture.name(), 0, begin.x, begin.y, 0, width, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, GLsizei(numbers.size() * sizeof(GLuint)), numbers.data());
    std::copy(numbers.begin(), numbers.end(), row);
  } else {
    constexpr GLenum formats[] = {0, GL_RED, GL_RG, 0, GL_RGBA};
    glGetTextureSubImage(texture.name(), 0, begin.x, begin.y, 0, width, 1, 1, formats[channels], GL_FLOAT, GLsizei(std::size_t(width * channels) * sizeof(float)), row);
  }
}

}  // namespace

const lumen::gl::Texture& ViewRenderer::picture() const {
  State& state = *state_;
  const lumen::gl::Texture* full = state.centers.find(state.picture);
  if (full == nullptr) throw lumen::Error("view '" + state.view + "'", "nothing has been drawn yet");
  if (state.geometry.border == 0) return *full;
  const std::uint64_t revision = Hash().add(std::string_view(state.picture)).add(state.centers.revision(state.picture)).value();
  if (revision != state.cropped_revision) {
    const int border = state.geometry.border;
    if (!state.cropped || state.cropped.size() != state.size || state.cropped.format() != full->format())
      state.cropped = lumen::gl::Texture(full->format(), state.size);
    glCopyImageSubData(full->name(), GL_TEXTURE_2D, 0, border, border, 0, state.cropped.name(), GL_TEXTURE_2D, 0, 0, 0, 0, state.size.x, state.size.y, 1);
    state.cropped_revision = revision;
  }
  return state.cropped;
}

std::shared_ptr<lumen::Image> ViewRenderer::layer(const std::string& name) {
  if (channels_of_layer(name).empty())
    throw lumen::Error("layer '" + name + "'", "there is no such layer",
                       "layers: color depth normal position albedo ambient diffuse specular occlusion opacity transparent id");
  auto image = state_->image_of(name);
  image->finish();
  return image;
}

std::shared_ptr<lumen::Image> ViewRenderer::State::image_of(const std::string& name) {
  std::string source = name;
  if (name == "color") source = picture;
  if (name == "position") source = "depth";
  if (name == "opacity") source = "transparent";
  if (samples > 1 && centers.find("mean " + source) != nullptr) source = "mean " + source;
  const lumen::gl::Texture* texture = centers.find(source);

  auto image = std::make_shared<lumen::Image>();
  image->origin = view + ", layer " + name;
  image->width = size.x;
  image->height = size.y;
  image->channels = channels_of_layer(name);
  const std::size_t count = image->channels.size();
  const std::size_t numbers = std::size_t(size.x) * std::size_t(size.y) * count;
  const auto pixels = std::make_shared_for_overwrite<float[]>(numbers);
  const std::size_t stride = texture == nullptr ? 0 : std::size_t(lumen::channels_of(texture->format()));
  if (stride < count) std::fill_n(pixels.get(), numbers, name == "depth" || name == "position" ? std::numeric_limits<float>::infinity() : 0.0f);
  if (texture != nullptr) {
    glFinish();  // Mesa 22.3's software driver may read rows of a texture before all of it is drawn
    const glm::mat4 to_world = glm::inverse(camera.view);
    std::vector<float> row(std::size_t(size.x) * stride);
    for (int y = 0; y < size.y; ++y) {  // row by row, since images begin at the top and have no border
      float* const to = &pixels[std::size_t(y) * std::size_t(size.x) * count];
      const glm::ivec2 begin(geometry.border, size.y - 1 - y + geometry.border);
      if (stride == count && name != "position") {
        download_row(*texture, begin, size.x, to);
        continue;
      }
      download_row(*texture, begin, size.x, row.data());
      for (int x = 0; x < size.x; ++x) {
        const float* const from = &row[std::size_t(x) * stride];
        if (name == "position") world_position(glm::ivec2(begin.x + x, begin.y), from[0], to_world, to + 3 * x);
        else if (name == "opacity") to[x] = from[3];
        else std::copy_n(from, std::min(stride, count), to + std::size_t(x) * count);
      }
    }
  }
  image->pixels = {std::span<const float>(pixels.get(), numbers), pixels};
  return image;
}

void ViewRenderer::State::world_position(glm::ivec2 pixel, float depth, const glm::mat4& to_world, float* position) const {
  const glm::vec2 uv = (glm::vec2(pixel) + 0.5f) / glm::vec2(geometry.size());
  const glm::vec2 plane = uv * glm::vec2(geometry.block.unproject) + glm::vec2(geometry.block.unproject.z, geometry.block.unproject.w);
  const glm::vec2 place = camera.orthographic ? plane : plane * depth;
  const glm::vec3 world = std::isinf(depth) ? glm::vec3(depth)  // the background is nowhere, in every direction
                                            : glm::vec3(to_world * glm::vec4(place, -depth, 1));
  position[0] = world.x, position[1] = world.y, position[2] = world.z;
}

ViewRenderer::Hit ViewRenderer::pick(glm::ivec2 pixel, const std::function<bool(const Instance&)>& wanted) {
  State& state = *state_;
  Hit hit;
  if (state.scene.view == nullptr || pixel.x < 0 || pixel.y < 0 || pixel.x >= state.size.x || pixel.y >= state.size.y) return hit;
  const glm::ivec2 size = state.geometry.size();
  const glm::ivec2 at(pixel.x + state.geometry.border, size.y - 1 - pixel.y - state.geometry.border);
  const lumen::gl::Texture id(lumen::Format::RGBA32UI, size), depth(lumen::Format::R32F, size), buffer(lumen::Format::depth32F, size);
  const lumen::gl::Texture* const targets[] = {&id, &depth};
  const lumen::gl::Framebuffer target(targets, &buffer);
  target.bind();
  glViewport(0, 0, size.x, size.y);
  glEnable(GL_SCISSOR_TEST);
  glScissor(at.x, at.y, 1, 1);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  const GLuint none[4] = {};
  const float one = 1;
  glClearNamedFramebufferuiv(target.name(), GL_COLOR, 0, none);
  glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &one);
  const SurfaceOutput output{
      .name = "pick",
      .write = [](ProgramText& text, const Instance&) {
        text.generated("layout(location = 0) out uvec4 lumen_id;\nlayout(location = 1) out float lumen_depth;\n"
                       "void main() {\n  Surface s = lumen_surface();\n"
                       "  lumen_id = uvec4(s.instance, s.part + 1, s.primitive + 1, 0);\n  lumen_depth = -s.position.z;\n}\n");
      },
      .identifies = true};
  const FrameContext frame = state.context(0, state.whole(), state.geometry, state.centers);
  for (const auto* surfaces : {&state.scene.opaque, &state.scene.transparent})
    for (const SceneSurface& surface : *surfaces)
      if (!wanted || wanted(*surface.instance)) draw_surface(frame, surface, output);
  glDisable(GL_SCISSOR_TEST);
  GLuint numbers[4] = {};
  float distance = 0;
  glGetTextureSubImage(id.name(), 0, at.x, at.y, 0, 1, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, sizeof numbers, numbers);
  glGetTextureSubImage(depth.name(), 0, at.x, at.y, 0, 1, 1, 1, GL_RED, GL_FLOAT, sizeof distance, &distance);
  if (numbers[0] == 0) return hit;
  hit.instance = int(numbers[0]);
  hit.part = int(numbers[1]);
  hit.primitive = int(numbers[2]);
  for (const auto* surfaces : {&state.scene.opaque, &state.scene.transparent})
    for (const SceneSurface& surface : *surfaces)
      if (surface.instance->number() == hit.instance) hit.moved = surface.split.parts.at(std::size_t(hit.part - 1)).transform;
  const glm::vec2 uv = (glm::vec2(at) + 0.5f) / glm::vec2(size);
  const glm::vec4 unproject = state.geometry.block.unproject;
  const glm::vec2 plane = uv * glm::vec2(unproject) + glm::vec2(unproject.z, unproject.w);
  const glm::vec3 eye(state.camera.orthographic ? plane : plane * distance, -distance);
  hit.position = glm::vec3(glm::inverse(state.camera.view) * glm::vec4(eye, 1));
  return hit;
}

}  // namespace lumenshop
