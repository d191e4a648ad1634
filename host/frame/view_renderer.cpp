#include "frame/view_renderer.h"

#include <algorithm>
#include <span>

#include <lumen/interactor.h>
#include <lumen/splitter.h>

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

void ViewRenderer::State::find() {
  session.update();
  scene = find_scene(session, view, substitute);
  if (tell_splitters()) scene = find_scene(session, view, substitute);  // a plane that is drawn, say, has moved
  if (scene.interactors.empty() && scene.camera == nullptr) return;
  tell_interactors();
}

bool ViewRenderer::State::tell_splitters() {
  const auto before = session.revision();
  std::map<std::string, std::pair<lumen::Bounds, int>> known;
  for (const auto* surfaces : {&scene.opaque, &scene.transparent})
    for (const SceneSurface& surface : *surfaces)
      for (const Instance* splitter : surface.splitters) {
        const auto [entry, is_new] = known.try_emplace(splitter->id());
        if (!is_new) continue;
        entry->second = {bounds_cut_by(session, *splitter), splitter->generation()};
        const auto told = told_splitters.find(splitter->id());
        const lumen::Bounds& bounds = entry->second.first;
        if (told != told_splitters.end() && told->second.second == splitter->generation() && told->second.first.min == bounds.min && told->second.first.max == bounds.max) continue;
        splitter->as<lumen::Splitter>(Kind::splitter)->surfaces_changed(bounds);
      }
  told_splitters = std::move(known);
  session.update();
  return session.revision() != before;
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

bool ViewRenderer::draw() { return state_->draw(false); }

bool ViewRenderer::State::draw(bool final) {
  session.update();
  if (!stale && drawn_session == session.revision() && drawn_shaders == shaders.revision() && !unfinished()) return false;
  find();
  if (stale) drop_fine();
  stale = false;
  camera = scene.camera != nullptr ? scene.camera->as<lumen::Interactor>(Kind::interactor)->camera()
                                   : fitting_camera(scene.bounds, float(size.x) / float(size.y));
  split_surfaces(scene, camera, split_store);
  lights = make_lights(scene, camera);
  light_block.write(std::as_bytes(std::span(&lights, 1)));
  values.update(session);
  shading.update(session, scene.lit_surfaces(), values);
  problems = scene.problems;
  const auto runs_before = log.total_runs();
  const int samples_before = samples;
  draw_picture(final);
  drawn_session = session.revision();
  drawn_shaders = shaders.revision();
  return log.total_runs() != runs_before || samples != samples_before;
}

bool ViewRenderer::unfinished() const { return state_->unfinished(); }

void ViewRenderer::finish() {
  do state_->draw(true);
  while (unfinished());
}

void ViewRenderer::prepare() { state_->prepare(); }

float ViewRenderer::progress() const {
  // Refinements of passes come before the samples of antialiasing.
  constexpr float passes_share = 0.8f;
  float slowest = 1;
  for (const auto& [name, memory] : state_->memories)
    if (memory.unfinished) slowest = std::min(slowest, memory.progress);
  if (slowest < 1) return passes_share * slowest;
  return std::min(1.0f, float(state_->samples) / float(std::max(1, state_->samples_wanted())));
}

void ViewRenderer::substitute(const std::string& instance) {
  state_->substitute = instance;
  state_->stale = true;
}

std::size_t ViewRenderer::bytes_of(const Instance& instance) const {
  const LayerStore& layers = state_->centers;
  std::size_t sum = layers.bytes(instance.id() + "/");
  for (int layer = 0; layer < 4; ++layer) sum += layers.bytes("transparent " + std::to_string(layer) + "/" + instance.id() + "/");
  if (instance.plugin() == nullptr) return sum;
  for (const lumen::Writes* writes : instance.plugin()->writes()) sum += layers.bytes(writes->layer());
  return sum + instance.plugin()->bytes();
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
