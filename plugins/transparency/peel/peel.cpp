/// Exact transparency without lists: each drawing takes the nearest and the farthest layer that are left.
/// Bavoil, Myers, Order Independent Transparency with Dual Depth Peeling, NVIDIA 2008.

#include <limits>
#include <span>
#include <string>

#include <lumen/gl/buffer.h>
#include <lumen/transparency.h>

namespace {

struct Peel : lumen::Transparency {
  using Transparency::Transparency;

  lumen::Property<int> peels{this, "peels", 8, {.min = 1, .max = 64, .doc = "how often two layers are taken off, as far as there are any; what is left then is blended by weighted sums"}};
  lumen::Property<float> decay{this, "decay", 4.0f, {.min = 0, .max = 20, .doc = "how strongly near fragments outweigh far ones in what is left: exp(-decay z), z = 0 at the nearest, 1 at the farthest surface", .advanced = true}};

  lumen::Writes transparent{this, "transparent", lumen::Format::RGBA32F};

  void render(lumen::TransparencyFrame& frame) override {
    constexpr const char* shader = "transparency/peel.glsl";
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const auto scratch = [&](const char* name, lumen::Format format) { return &frame.scratch(name, format, frame.size()); };
    const lumen::gl::Texture* extent = scratch("extent", lumen::Format::RG32F);
    const lumen::gl::Texture* next = scratch("other_extent", lumen::Format::RG32F);
    const lumen::gl::Texture* front = scratch("front", lumen::Format::RGBA32F);
    const lumen::gl::Texture* back = scratch("back", lumen::Format::RGBA32F);
    const lumen::gl::Texture* sum = scratch("sum", lumen::Format::RGBA32F);
    const lumen::gl::Texture* revealage = scratch("revealage", lumen::Format::R32F);
    frame.surfaces(shader, {.function = "find", .targets = {{extent, "extent", lumen::Blend::maximum, glm::vec4(-infinity)}}, .lit = false});
    if (!left_) left_ = lumen::gl::Buffer(sizeof(GLuint));
    const lumen::FullscreenPass resolve{.function = "resolve", .inputs = {{"front", front}, {"back", back}}};
    for (int i = 0; i < peels; ++i) {
      const auto clear = i == 0 ? std::optional(glm::vec4(0)) : std::nullopt;
      const GLuint none = 0;
      glClearNamedBufferData(left_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 10, left_.name());
      if (i + 1 < peels)
        frame.surfaces(shader, {.function = "peel",
                                .targets = {{front, "front", lumen::Blend::under, clear},
                                            {back, "back", lumen::Blend::over, clear},
                                            {next, "next_extent", lumen::Blend::maximum, glm::vec4(-infinity)}},
                                .inputs = {{"extent", extent}}});
      else
        frame.surfaces(shader, {.function = "peel_last",
                                .targets = {{front, "front", lumen::Blend::under, clear},
                                            {back, "back", lumen::Blend::over, clear},
                                            {sum, "sum", lumen::Blend::add, glm::vec4(0)},
                                            {revealage, "revealage", lumen::Blend::multiply_by_one_minus_source, glm::vec4(1)}},
                                .inputs = {{"extent", extent}}});
      const GLuint left = fragments_left();
      if (left == 0) return frame.fullscreen(shader, resolve);
      std::swap(extent, next);
      if (i + 1 == peels)
        report(lumen::Severity::warning, std::to_string(left) + " fragments lie between the peeled layers and are blended by weighted sums: raise peels");
    }
    frame.fullscreen(shader, {.function = "resolve_left", .inputs = {{"front", front}, {"back", back}, {"sum", sum}, {"revealage", revealage}}});
  }
  void released() override { left_ = {}; }

 private:
  /// What the last drawing counted; before the last peel, only whether there are any.
  GLuint fragments_left() const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    GLuint count = 0;
    glGetNamedBufferSubData(left_.name(), 0, sizeof count, &count);
    return count;
  }

  lumen::gl::Buffer left_;
};

}  // namespace

LUMEN_PLUGIN(Peel, "transparency.peel", "Exact transparency by dual depth peeling: two layers per drawing, as many drawings as there are layers. Fragments of equal depth blend in the order of drawing. Bavoil, Myers, Order Independent Transparency with Dual Depth Peeling, NVIDIA 2008.")
