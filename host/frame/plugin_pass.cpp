#include "frame/plugin_pass.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

#include <lumen/interactor.h>
#include <lumen/renderer.h>

#include "frame/depth_pass.h"
#include "frame/hash.h"
#include "frame/surface_pass.h"
#include "frame/transparent_layers.h"

namespace lumenshop {

PluginPass::PluginPass(const FrameContext& context, Instance& instance, PluginPassMemory& memory, LayerNames reads, LayerNames writes, std::string name)
    : context_(context),
      instance_(instance),
      memory_(memory),
      reads_(std::move(reads)),
      writes_(std::move(writes)),
      name_(name.empty() ? instance.id() : std::move(name)),
      pixels_{glm::ivec2(0), size()} {}

std::string PluginPass::stored(const LayerNames& names, const std::string& layer) const {
  const auto found = names.find(layer);
  return found == names.end() ? layer : found->second;
}

std::uint64_t PluginPass::key() const {
  Hash hash;
  hash.add(instance_.number()).add(instance_.draw_revision()).add(context_.geometry_key);
  for (const lumen::Reads* reads : instance_.plugin()->reads()) hash.add(context_.layers.revision(stored(reads_, reads->layer() == "position" ? "depth" : reads->layer())));
  for (const std::string& file : memory_.files) hash.add(context_.shaders.revision(file));
  if (memory_.uses_time) hash.add(context_.geometry.block.transparent_extent.w);
  if (memory_.uses_lights) hash.add(context_.light_key);
  if (memory_.uses_geometry) hash.add(surfaces_key(context_, context_.scene.opaque)).add(surfaces_key(context_, context_.scene.transparent));
  if (instance_.kind() == lumen::Kind::transparency)
    hash.add(surfaces_key(context_, context_.scene.transparent)).add(context_.light_key).add(context_.shading.value_revision())
        .add(context_.shading.signature(context_.shaders)).add(context_.layers.revision("depth"))
        .add(transparent_occlusion_revision(context_));
  return hash.value();
}

bool PluginPass::run(const std::function<void(PluginPass&)>& draw) {
  for (const lumen::Writes* writes : instance_.plugin()->writes())
    context_.layers.allocate(stored(writes_, writes->layer()), writes->format(), size());
  const std::uint64_t base = key();
  if (context_.set == 0) {
    if (base != memory_.base_key) memory_.iteration = 0;
    else if (memory_.unfinished) ++memory_.iteration;
  }
  memory_.base_key = context_.set == 0 ? base : memory_.base_key;
  const std::uint64_t full = Hash().add(base).add(memory_.iteration).value();
  return context_.log.run(name_, context_.set, full, [&] {
    if (instance_.kind() != lumen::Kind::splitter) instance_.clear_reports();  // these report while they split
    memory_.unfinished = false;
    try {
      draw_within([&] { draw(*this); });
    } catch (const std::exception& error) {
      instance_.report(lumen::Severity::error, error.what());
    }
    for (const lumen::Writes* writes : instance_.plugin()->writes()) context_.layers.drawn(stored(writes_, writes->layer()));
    // What this run was the first to use belongs to its key from now on.
    memory_.base_key = context_.set == 0 ? key() : memory_.base_key;
    context_.log.set_key(name_, context_.set, Hash().add(key()).add(memory_.iteration).value());
  });
}

void PluginPass::draw_within(const std::function<void()>& draw) {
  if (instance_.kind() != lumen::Kind::transparency) return draw();
  // Where transparent surfaces are, and where they were: outside, what it writes is zero already.
  pixels_ = context_.geometry.transparent;
  for (const lumen::Writes* writes : instance_.plugin()->writes()) pixels_ = united(pixels_, nonzero(*writes));
  for (const lumen::Writes* writes : instance_.plugin()->writes()) nonzero(*writes) = pixels_;
  draw();
  for (const lumen::Writes* writes : instance_.plugin()->writes()) nonzero(*writes) = context_.geometry.transparent;
}

double PluginPass::time() const {
  memory_.uses_time = true;
  return double(context_.geometry.block.transparent_extent.w);
}

const lumen::gl::Texture& PluginPass::layer(const lumen::Reads& reads) const {
  const lumen::gl::Texture* texture = context_.layers.find(stored(reads_, reads.layer()));
  if (texture == nullptr) throw lumen::Error(instance_.id(), "reads layer '" + reads.layer() + "', which nothing in this view writes");
  return *texture;
}

const lumen::gl::Texture& PluginPass::layer(const lumen::Writes& writes) const {
  return *context_.layers.find(stored(writes_, writes.layer()));
}

const lumen::gl::Texture& PluginPass::scratch(std::string_view name, lumen::Format format, glm::ivec2 size) {
  return context_.layers.allocate(name_ + "/" + std::string(name), format, size);
}

bool PluginPass::leads() const {
  if (memory_.lead == nullptr) memory_.lead = instance_.take_lead();
  return memory_.lead != nullptr;
}

glm::vec3 PluginPass::view_position(glm::ivec2 pixel, float depth) const {
  const glm::vec4& unproject = context_.geometry.block.unproject;
  const glm::vec2 plane = (glm::vec2(pixel) + 0.5f) / glm::vec2(size()) * glm::vec2(unproject) + glm::vec2(unproject.z, unproject.w);
  return {context_.geometry.camera.orthographic ? plane : plane * depth, -depth};
}

std::vector<lumen::Light> PluginPass::lights() const {
  memory_.uses_lights = true;
  std::vector<lumen::Light> lights;
  for (Instance* light : context_.scene.lights) lights.push_back(light->as<lumen::Interactor>(lumen::Kind::interactor)->light(context_.geometry.camera));
  return lights;
}

std::vector<lumen::TracedSurface> PluginPass::traced_surfaces() const {
  memory_.uses_geometry = true;
  std::vector<lumen::TracedSurface> surfaces;
  for (const auto* list : {&context_.scene.opaque, &context_.scene.transparent})
    for (const SceneSurface& surface : *list) {
      lumen::TracedSurface traced = surface.instance->as<lumen::Renderer>(lumen::Kind::renderer)->traced();
      if (traced.mesh == nullptr) continue;
      traced.split = surface.split;
      traced.transparent = list == &context_.scene.transparent;
      traced.removes = surface.removes();
      surfaces.push_back(std::move(traced));
    }
  return surfaces;
}

void PluginPass::draw_depth(const lumen::Camera& camera, const lumen::gl::Texture& depth, const lumen::DepthDraw& what) {
  memory_.uses_geometry = true;
  lumenshop::draw_depth(context_, camera, depth, what);
}

void PluginPass::parallel(int count, const std::function<void(int, int)>& body) const {
  // More parts than threads, since parts of a picture differ in cost.
  const int threads = std::max(1, int(std::thread::hardware_concurrency()));
  const int parts = std::min(count, threads * 8);
  std::mutex mutex;
  std::exception_ptr failure;
  int next = 0;
  const auto work = [&] {
    for (;;) {
      int part;
      {
        const std::lock_guard lock(mutex);
        if (next >= parts || failure != nullptr) return;
        part = next++;
      }
      try {
        body(int(std::int64_t(count) * part / parts), int(std::int64_t(count) * (part + 1) / parts));
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int i = 1; i < std::min(threads, parts); ++i) workers.emplace_back(work);
    work();
  }
  if (failure != nullptr) std::rethrow_exception(failure);
}

}  // namespace lumenshop
