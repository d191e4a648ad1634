/// Transparencies that gather the fragments of a pixel in a list, and what holds them: storage of shaders/lib/fragment_lists.glsl that
/// grows with what the frames need, up to a bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <lumen/gl/buffer.h>
#include <lumen/transparency.h>

class FragmentLists {
 public:
  static constexpr double node_bytes = 20, most_megabytes = 1024;

  /// Draws all surfaces with the function `store` of the shader, again if they turn out to need more room than there is but
  /// less than the bound. What does not fit is reported by `owner`. The storage stays bound for the passes that read it.
  void gather(lumen::TransparencyFrame& frame, const char* shader, double megabytes, const lumen::Plugin& owner) {
    const std::uint64_t bound = most_nodes(megabytes);
    std::uint64_t needed = draw(frame, shader, std::clamp<std::uint64_t>(capacity_, 1024, bound));
    if (needed > capacity_ && capacity_ < bound) needed = draw(frame, shader, std::min(needed + needed / 4, bound));
    if (needed <= capacity_) return;
    const std::string lost = std::to_string(needed - capacity_) + " of " + std::to_string(needed) + " transparent fragments found no room";
    const std::string megabytes_needed = std::to_string(int(std::ceil(double(needed) * node_bytes / 1e6)));
    owner.report(lumen::Severity::warning, lost + " and are missing: " + (needed <= most_nodes(most_megabytes) ? "raise memory to " + megabytes_needed + " MB" : "draw a smaller picture"));
  }

  void release() { *this = {}; }
  std::size_t bytes() const { return heads_.size() + links_.size() + colors_.size(); }

 private:
  /// The links, 12 bytes each, are the larger of the two buffers.
  static std::uint64_t most_nodes(double megabytes) {
    return std::min(std::uint64_t(megabytes * 1e6 / node_bytes), largest_block() / 12 - 1);
  }

  static std::uint64_t largest_block() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return std::uint64_t(bytes);
  }

  /// How many fragments there were.
  std::uint64_t draw(lumen::TransparencyFrame& frame, const char* shader, std::uint64_t capacity) {
    if (capacity != capacity_) {
      links_ = {};  // freed before more is taken
      colors_ = {};
      links_ = lumen::gl::Buffer(std::size_t(capacity + 1) * 12);
      colors_ = lumen::gl::Buffer(std::size_t(capacity + 1) * 8);
      capacity_ = capacity;
    }
    const glm::ivec2 size = frame.size();
    const std::size_t head_bytes = (std::size_t(size.x) * std::size_t(size.y) + 1) * sizeof(GLuint);
    if (head_bytes > largest_block())
      throw lumen::Error("a picture of " + std::to_string(size.x) + "x" + std::to_string(size.y), "this driver has no buffer for so many lists", "draw a smaller one");
    if (heads_.size() < head_bytes) heads_ = lumen::gl::Buffer(head_bytes);
    const GLuint none = 0;
    glClearNamedBufferData(heads_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 10, heads_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 11, links_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 12, colors_.name());
    frame.surfaces(shader, {.function = "store"});
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    GLuint count = 0;
    glGetNamedBufferSubData(heads_.name(), 0, sizeof count, &count);
    return count;
  }

  lumen::gl::Buffer heads_, links_, colors_;
  std::uint64_t capacity_ = 0;
};

/// Its shader has store() and resolve(), which puts a pixel's list together.
class ListedTransparency : public lumen::Transparency {
 public:
  ListedTransparency(lumen::Binding& binding, const char* shader) : Transparency(binding), shader_(shader) {}

  lumen::Property<float> memory{this, "memory", 128.0f, {.min = 1, .max = FragmentLists::most_megabytes, .unit = "MB", .doc = "what the fragments may take, 20 bytes each; those that find no room are counted and missing", .group = "Storage", .logarithmic = true}};

  lumen::Writes transparent{this, "transparent", lumen::Format::RGBA32F};

  void render(lumen::TransparencyFrame& frame) override {
    lists_.gather(frame, shader_, double(memory), *this);
    frame.fullscreen(shader_, {.function = "resolve"});
  }
  void released() override { lists_.release(); }
  std::size_t bytes() const override { return lists_.bytes(); }

 private:
  const char* shader_;
  FragmentLists lists_;
};
