/// Ambient occlusion by rays: the truth that the image-space techniques are measured against. Cosine-weighted, so that the
/// mean of the rays that hit is 1 - visibility; refined while nothing changes.
/// Cook, Porter, Carpenter, Distributed Ray Tracing, SIGGRAPH 1984; Landis, Production-Ready Global Illumination, SIGGRAPH 2002 courses.

#include <cmath>

#include <lumen/mesh.h>
#include <lumen/occlusion.h>

#include "ray_scene.h"

namespace {

/// Point `index` of Sobol's sequence in two dimensions, turned on the torus by `shift`.
glm::vec2 sobol(std::uint32_t index, glm::vec2 shift) {
  std::uint32_t x = 0, y = 0, column = 1u << 31;
  for (std::uint32_t bit = 0; bit < 32 && (index >> bit) != 0; ++bit) {
    if ((index >> bit) & 1u) {
      x ^= 1u << (31 - bit);
      y ^= column;
    }
    column ^= column >> 1;
  }
  return glm::fract(glm::vec2(x >> 8, y >> 8) / 16777216.0f + shift);
}

/// Two numbers in 0..1 from a pixel. Jarzynski, Olano, Hash Functions for GPU Rendering, JCGT 2020 (pcg2d).
glm::vec2 hash(glm::uvec2 v) {
  v = v * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round) {
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
  }
  return glm::vec2(v >> 8u) / 16777216.0f;
}

struct Traced : lumen::Occlusion {
  using Occlusion::Occlusion;

  lumen::Property<float> radius{this, "radius", 2.0f, {.min = 0.001, .max = 2, .unit = "scene radii", .doc = "how far an occluder reaches; 2 is everything", .logarithmic = true}};
  lumen::Property<float> strength{this, "strength", 1.0f, {.min = 0, .max = 8, .doc = "exponent of the visibility; 1 is as measured"}};
  lumen::Property<int> samples{this, "samples", 64, {.min = 1, .max = 16384, .doc = "rays per pixel of the finished picture"}};
  lumen::Property<int> samples_per_step{this, "samples_per_step", 4, {.min = 1, .max = 256, .doc = "rays per pixel between two pictures", .advanced = true}};
  lumen::Property<bool> transparent_surfaces{this, "transparent_surfaces", false, {.doc = "transparent surfaces occlude, as if they were opaque"}};

  lumen::Reads depth{this, "depth"}, normal{this, "normal"};
  lumen::Writes occlusion{this, "occlusion", lumen::Format::R32F};

  void render(lumen::Frame& frame) override {
    update_scene(frame);
    const int first = frame.iteration() * samples_per_step;
    const int last = std::min(first + samples_per_step, samples.get());
    const auto& hits = frame.scratch("hits", lumen::Format::R32F, frame.size());
    std::vector<float> sum = first == 0 ? std::vector<float>(std::size_t(frame.size().x) * std::size_t(frame.size().y)) : hits.download();
    trace(frame, first, last, sum);
    hits.upload(sum.data());
    for (float& value : sum) value = 1 - std::pow(1 - value / float(last), strength.get());
    frame.layer(occlusion).upload(sum.data());
    if (last < samples) frame.unfinished(float(last) / float(samples));
  }

  void released() override { scene_.reset(); }
  std::size_t bytes() const override { return scene_ == nullptr ? 0 : scene_->bytes(); }

 private:
  void update_scene(const lumen::Frame& frame) {
    std::vector<lumen::TracedSurface> surfaces = frame.traced_surfaces();
    if (!transparent_surfaces) std::erase_if(surfaces, [](const lumen::TracedSurface& surface) { return surface.transparent; });
    for (const lumen::TracedSurface& surface : surfaces)
      if (surface.removes) report(lumen::Severity::note, "rays meet what a splitter's shader removes from '" + surface.mesh->origin + "', too");
    if (scene_ != nullptr && scene_->shows(surfaces)) return;
    scene_.reset();  // the old memory goes first
    scene_ = std::make_unique<RayScene>(std::move(surfaces));
  }

  /// Adds to `sum`, rows bottom-up, how many of the rays first..last of each covered pixel hit something.
  void trace(const lumen::Frame& frame, int first, int last, std::vector<float>& sum) const {
    const std::vector<float> depths = frame.layer(depth).download(), normals = frame.layer(normal).download();
    const int stride = lumen::channels_of(frame.layer(normal).format());
    const glm::ivec2 size = frame.size();
    const glm::mat4 to_world = glm::inverse(frame.camera().view);
    const float reach = radius >= 2 ? std::numeric_limits<float>::infinity() : radius * frame.scene_radius();
    frame.parallel(size.y, [&](int top, int bottom) {
      for (int y = top; y < bottom; ++y)
        for (int x = 0; x < size.x; ++x) {
          const std::size_t pixel = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
          if (!std::isfinite(depths[pixel])) continue;
          const float* n = &normals[pixel * std::size_t(stride)];
          const glm::vec3 up = glm::mat3(to_world) * glm::vec3(n[0], n[1], n[2]);
          if (!(glm::dot(up, up) > 0.5f)) continue;
          const glm::vec3 position = frame.view_position({x, y}, depths[pixel]);
          const glm::vec3 to_eye = frame.camera().orthographic ? glm::vec3(0, 0, 1) : glm::normalize(-position);
          // Off the surface by more than the depth's rounding, by less than anything that is seen; toward the eye, too, where
          // nothing is in the way: at silhouettes the averaged normal may point into the surface.
          const float off = 1e-4f * frame.scene_radius();
          const glm::vec3 origin = glm::vec3(to_world * glm::vec4(position + off * to_eye, 1)) + off * up;
          sum[pixel] += hits(origin, up, reach, hash(glm::uvec2(x, y)), first, last);
        }
    });
  }

  float hits(glm::vec3 origin, glm::vec3 up, float reach, glm::vec2 shift, int first, int last) const {
    const glm::vec3 tangent = glm::normalize(std::abs(up.z) > 0.5f ? glm::vec3(up.z, 0, -up.x) : glm::vec3(-up.y, up.x, 0));
    const glm::vec3 bitangent = glm::cross(up, tangent);
    int count = 0;
    for (int i = first; i < last; ++i) {
      const glm::vec2 u = sobol(std::uint32_t(i), shift);
      const float around = 6.2831853f * u.x, out = std::sqrt(u.y);
      const glm::vec3 direction = out * (std::cos(around) * tangent + std::sin(around) * bitangent) + std::sqrt(1 - u.y) * up;
      count += scene_->occluded(origin, direction, reach) ? 1 : 0;
    }
    return float(count);
  }

  std::unique_ptr<RayScene> scene_;
};

}  // namespace

LUMEN_PLUGIN(Traced, "occlusion.traced", "Ambient occlusion by rays, cosine-weighted: the truth that the image-space techniques are measured against.")
