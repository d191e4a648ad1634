#include "frame/view_renderer.h"

#include <algorithm>
#include <span>

#include <lumen/compositor.h>
#include <lumen/gl/framebuffer.h>
#include <lumen/interactor.h>
#include <lumen/occlusion.h>
#include <lumen/renderer.h>
#include <lumen/transparency.h>

#include "frame/hash.h"
#include "frame/transparent_layers.h"
#include "frame/view_state.h"

namespace lumenshop {

using lumen::Kind;

ViewRenderer::ViewRenderer(Session& session, ShaderLibrary& shaders, std::string view)
    : state_(std::make_unique<State>(session, shaders, std::move(view))) {}
ViewRenderer::~ViewRenderer() = default;

void ViewRenderer::resize(glm::ivec2 size) {
  if (size.x < 1 || size.y < 1 || size.x > 16384 || size.y > 16384)
    throw lumen::Error("size " + std::to_string(size.x) + "x" + std::to_string(size.y), "a picture has 1 to 16384 pixels each way");
  if (size == state_->size) return;
  state_->size = size;
  state_->stale = true;
}

glm::ivec2 ViewRenderer::size() const { return state_->size; }

void ViewRenderer::request(const std::vector<std::string>& layers) {
  state_->requested = {layers.begin(), layers.end()};
  state_->stale = true;
}

bool ViewRenderer::State::progressive_unfinished() const {
  return std::any_of(memories.begin(), memories.end(), [](const auto& memory) { return memory.second.unfinished; });
}

int ViewRenderer::State::border() const {
  int widest = 0;
  for (const Instance* instance : {scene.occlusion, scene.transparency})
    if (instance != nullptr)
      for (const lumen::Reads* reads : instance->plugin()->reads()) widest = std::max(widest, reads->border());
  return widest;
}

void ViewRenderer::State::find() {
  session.update();
  scene = find_scene(session, view);
  if (scene.interactors.empty() && scene.camera == nullptr) return;
  tell_interactors();
}

void ViewRenderer::State::tell_interactors() {
  const float aspect = float(size.x) / float(size.y);
  std::set<lumen::Plugin*> all;
  for (const auto* list : {&scene.interactors, &scene.lights})
    for (const Instance* instance : *list) all.insert(instance->plugin());
  if (scene.camera != nullptr) all.insert(scene.camera->plugin());
  // A reloaded interactor is another object, which knows nothing of the scene yet.
  const bool known = scene.bounds.min == told_bounds.min && scene.bounds.max == told_bounds.max && aspect == told_aspect && all == told;
  if (scene.bounds.empty() || known) return;
  told_bounds = scene.bounds;
  told_aspect = aspect;
  told = all;
  for (lumen::Plugin* plugin : all) static_cast<lumen::Interactor*>(plugin)->scene_changed(scene.bounds, aspect);
  session.update();
}

FrameContext ViewRenderer::State::context(int set, const ViewGeometry& sample, LayerStore& layers) {
  frame_block.write(std::as_bytes(std::span(&sample.block, 1)));
  // Time is not part of it: only what asks for the time depends on it.
  FrameBlock timeless = sample.block;
  timeless.transparent_extent.w = 0;
  return {session, shaders, values, shading, log, layers, centers, scene, sample, frame_block, light_block,
          Hash().add(timeless).add(sample.size()).add(sample.camera.pivot).add(sample.camera.distance).value(), Hash().add(lights).value(), lights.count.x, set};
}

std::string ViewRenderer::State::draw_scene(int set, glm::vec2 jitter, LayerStore& layers) {
  lumen::Bounds transparent;
  for (const SceneSurface& surface : scene.transparent)
    for (const lumen::Part& part : surface.parts)
      transparent.include(surface.instance->as<lumen::Renderer>(Kind::renderer)->bounds().transformed(part.transform));
  const ViewGeometry sample = make_geometry(camera, size, border(), jitter, scene.bounds, scene.split_bounds, transparent, double(scene.view->time.get()));
  if (set == 0) geometry = sample;
  const FrameContext frame = context(set, sample, layers);

  const bool albedo = requested.contains("albedo") || std::any_of(scene.opaque.begin(), scene.opaque.end(), [](const SceneSurface& surface) {
    return surface.instance->as<lumen::Renderer>(Kind::renderer)->colors_itself();
  });
  run_geometry_pass(frame, {.albedo = albedo, .id = set == 0 && requested.contains("id")});
  if (scene.occlusion != nullptr && set == 0) {
    PluginPass pass(frame, *scene.occlusion, memories[scene.occlusion->id()], {}, {});
    pass.run([&](PluginPass& in) { scene.occlusion->as<lumen::Occlusion>(Kind::occlusion)->render(in); });
  } else if (set == 0) {
    layers.drop("occlusion");
    layers.drop("illumination");
  }
  const bool summands = requested.contains("ambient") || requested.contains("diffuse") || requested.contains("specular");
  run_lighting_pass(frame, summands);
  if (scene.transparency == nullptr || scene.transparent.empty()) {
    layers.drop("transparent");
    return "lit";
  }
  run_transparent_occlusion(frame, memories);
  PluginPass pass(frame, *scene.transparency, memories[scene.transparency->id()], {{"color", "lit"}}, {});
  pass.run([&](PluginPass& in) { scene.transparency->as<lumen::Transparency>(Kind::transparency)->render(in); });
  if (layers.find("transparent") == nullptr) return "lit";
  run_merge_pass(frame);
  return "merged";
}

void ViewRenderer::State::draw_sample() {
  const std::string scene_layer = draw_scene(0, {0, 0}, centers);
  const std::uint64_t revision = Hash().add(centers.revision(scene_layer)).add(centers.revision("transparent")).value();
  if (revision != center_revision) {
    center_revision = revision;
    samples = 1;
    draw_compositors(scene_layer);
    return;
  }
  if (samples < samples_wanted() && !progressive_unfinished()) {
    std::vector<std::pair<std::string, std::string>> sums = {{scene_layer, "mean"}};
    for (const char* layer : {"ambient", "diffuse", "specular", "transparent"})
      if (requested.contains(layer) || (std::string_view(layer) == "transparent" && requested.contains("opacity")))
        if (centers.find(layer) != nullptr) sums.emplace_back(layer, std::string("mean ") + layer);
    const FrameContext frame = context(0, geometry, centers);
    if (samples == 1)
      for (const auto& [from, to] : sums) accumulate(frame, *centers.find(from), centers, to, 0);
    const std::string other = draw_scene(1, sample_offset(samples), others);
    for (const auto& [from, to] : sums)
      if (const lumen::gl::Texture* source = others.find(from == scene_layer ? other : from)) accumulate(frame, *source, centers, to, samples);
    ++samples;
  }
  if (samples >= samples_wanted()) others.clear();
  draw_compositors(samples > 1 ? "mean" : scene_layer);
}

void ViewRenderer::State::draw_compositors(const std::string& scene_layer) {
  const FrameContext frame = context(0, geometry, centers);
  picture = scene_layer;
  const auto run = [&](Instance& instance, auto&& draw) {
    const std::string output = "color of " + instance.id();
    PluginPass pass(frame, instance, memories[instance.id()], {{"color", picture}}, {{"color", output}});
    pass.run(draw);
    picture = output;
  };
  for (Instance* instance : scene.compositors)
    run(*instance, [&](PluginPass& in) { instance->as<lumen::Compositor>(Kind::compositor)->render(in); });
  for (Instance* instance : scene.overlays)
    run(*instance, [&](PluginPass& in) { instance->as<lumen::Interactor>(Kind::interactor)->draw(in); });
}

bool ViewRenderer::draw() {
  State& state = *state_;
  state.session.update();
  if (!state.stale && state.drawn_session == state.session.revision() && state.drawn_shaders == state.shaders.revision() && !unfinished()) return false;
  state.find();
  if (state.stale) state.others.clear();
  state.stale = false;
  state.camera = state.scene.camera != nullptr ? state.scene.camera->as<lumen::Interactor>(Kind::interactor)->camera()
                                               : fitting_camera(state.scene.bounds, float(state.size.x) / float(state.size.y));
  state.lights = make_lights(state.scene, state.camera);
  state.light_block.write(std::as_bytes(std::span(&state.lights, 1)));
  state.values.update(state.session);
  state.shading.update(state.session, state.scene.renderers(), state.values);
  state.problems = state.scene.problems;
  const auto before = state.log.total_runs();
  const int samples = state.samples;
  state.draw_sample();
  state.drawn_session = state.session.revision();
  state.drawn_shaders = state.shaders.revision();
  return state.log.total_runs() != before || state.samples != samples;
}

bool ViewRenderer::unfinished() const {
  return state_->stale || state_->samples < state_->samples_wanted() || state_->progressive_unfinished();
}

void ViewRenderer::finish() {
  do draw();
  while (unfinished());
}

float ViewRenderer::progress() const {
  return std::min(1.0f, float(state_->samples) / float(std::max(1, state_->samples_wanted())));
}

const lumen::Camera& ViewRenderer::camera() const { return state_->camera; }
lumen::Bounds ViewRenderer::scene_bounds() const { return state_->scene.bounds; }
std::vector<PassStatistics> ViewRenderer::statistics() const { return state_->log.statistics(); }
void ViewRenderer::reset_statistics() { state_->log.reset(); }
void ViewRenderer::set_timing(bool on) { state_->log.set_timing(on); }

std::vector<lumen::Problem> ViewRenderer::problems() const {
  std::vector<lumen::Problem> all = state_->problems;
  for (lumen::Problem& problem : state_->values.problems()) all.push_back(std::move(problem));
  for (lumen::Problem& problem : state_->shaders.problems()) all.push_back(std::move(problem));
  return all;
}

}  // namespace lumenshop
