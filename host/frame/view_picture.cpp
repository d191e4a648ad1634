/// How the picture comes about: the scene at the pixels' centers, the samples of antialiasing, the compositors.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <lumen/compositor.h>
#include <lumen/interactor.h>
#include <lumen/occlusion.h>
#include <lumen/renderer.h>
#include <lumen/splitter.h>
#include <lumen/transparency.h>

#include "frame/hash.h"
#include "frame/transparent_layers.h"
#include "frame/view_state.h"

namespace lumenshop {

using lumen::Kind;

namespace {

/// Antialiasing draws the picture in windows, since its layers need four times the memory: of a quarter of a million samples, or of
/// half as many samples as a large picture has pixels, so that they keep within the GL's limit.
int windows_across(glm::ivec2 pixels) {
  constexpr double samples_at_once = 1 << 18;
  return std::clamp(int(std::ceil(std::sqrt(4.0 * pixels.x * pixels.y / samples_at_once))), 1, 3);
}

bool reads_none(const Instance& instance, std::initializer_list<std::string_view> layers) {
  const auto& reads = instance.plugin()->reads();
  return std::none_of(reads.begin(), reads.end(), [&](const lumen::Reads* layer) { return std::find(layers.begin(), layers.end(), layer->layer()) != layers.end(); });
}

bool reads_only(const Instance& instance, std::initializer_list<std::string_view> layers) {
  const auto& reads = instance.plugin()->reads();
  return std::all_of(reads.begin(), reads.end(), [&](const lumen::Reads* layer) { return std::find(layers.begin(), layers.end(), layer->layer()) != layers.end(); });
}

}  // namespace

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

PictureWindow ViewRenderer::State::whole() const { return {.picture = size, .size = size, .border = border()}; }

FrameContext ViewRenderer::State::context(int set, const PictureWindow& window, const ViewGeometry& sample, LayerStore& layers) {
  frame_block.write(std::as_bytes(std::span(&sample.block, 1)));
  // Time is not part of it: only what asks for the time depends on it.
  FrameBlock timeless = sample.block;
  timeless.transparent_extent.w = 0;
  const glm::vec2 centers_size(size + 2 * border());
  const glm::vec4 to_centers(glm::vec2(sample.size()) / float(window.scale) / centers_size,
                             glm::vec2(window.origin - window.border + border()) / centers_size);
  return {session, shaders, values, shading, log, caps, layers, centers, scene, sample, main, frame_block, light_block, to_centers,
          Hash().add(timeless).add(sample.size()).add(sample.camera.pivot).add(sample.camera.distance).value(), Hash().add(lights).value(), kinds_of(lights), set};
}

ViewGeometry ViewRenderer::State::geometry_of(const PictureWindow& window) const {
  lumen::Bounds transparent;
  for (const SceneSurface& surface : scene.transparent)
    for (const lumen::Part& part : surface.split.parts)
      transparent.include(surface.instance->as<lumen::Renderer>(Kind::renderer)->bounds().transformed(part.transform));
  return make_geometry(camera, window, scene.bounds, scene.split_bounds, transparent, double(scene.view->time.get()));
}

void ViewRenderer::State::prepare_splitters() {
  std::vector<Instance*> all;
  for (auto* surfaces : {&scene.opaque, &scene.transparent})
    for (SceneSurface& surface : *surfaces) {
      surface.prepared.clear();
      for (Instance* splitter : surface.splitters)
        if (std::find(all.begin(), all.end(), splitter) == all.end()) all.push_back(splitter);
    }
  const FrameContext frame = context(0, {.picture = size, .size = size}, main, centers);
  for (Instance* splitter : all) {
    auto* plugin = splitter->as<lumen::Splitter>(Kind::splitter);
    PluginPassMemory& memory = memories[splitter->id()];
    PluginPass pass(frame, *splitter, memory, {}, {});
    // Kept here, since another view has the plugin draw what is seen there.
    if (pass.run([&](PluginPass& in) { plugin->prepare(in); })) memory.inputs = plugin->inputs();
    if (!plugin->removes()) continue;
    for (auto* surfaces : {&scene.opaque, &scene.transparent})
      for (SceneSurface& surface : *surfaces)
        if (std::find(surface.splitters.begin(), surface.splitters.end(), splitter) != surface.splitters.end()) surface.prepared[splitter] = memory.inputs;
  }
  values.update(session);  // they may have moved defaults
}

void ViewRenderer::State::draw_surfaces(const FrameContext& frame) {
  const bool centered = frame.set == 0;
  const bool albedo = (centered && requested.contains("albedo")) || std::any_of(scene.opaque.begin(), scene.opaque.end(), [](const SceneSurface& surface) {
    return surface.instance->as<lumen::Renderer>(Kind::renderer)->colors_itself();
  });
  run_geometry_pass(frame, {.albedo = albedo, .id = centered && requested.contains("id")});
}

void ViewRenderer::State::draw_occlusion(const FrameContext& frame) {
  if (scene.occlusion == nullptr) {
    frame.layers.drop("occlusion");
    frame.layers.drop("illumination");
    return;
  }
  PluginPass pass(frame, *scene.occlusion, memories[scene.occlusion->id()], {}, {});
  pass.run([&](PluginPass& in) { scene.occlusion->as<lumen::Occlusion>(Kind::occlusion)->render(in); });
}

std::string ViewRenderer::State::light_scene(const FrameContext& frame) {
  LayerStore& layers = frame.layers;
  run_lighting_pass(frame, summands() ? LightingOutput::summands : LightingOutput::lit);
  run_transparent_layers(frame, memories, reads_front());
  if (scene.transparency == nullptr || scene.transparent.empty()) {
    layers.drop("transparent");
    return "lit";
  }
  PluginPass pass(frame, *scene.transparency, memories[scene.transparency->id()], {{"color", "lit"}}, {});
  pass.run([&](PluginPass& in) { scene.transparency->as<lumen::Transparency>(Kind::transparency)->render(in); });
  if (layers.find("transparent") == nullptr) return "lit";
  if (scene.opaque.empty()) return "transparent";  // nothing behind it
  run_merge_pass(frame);
  return "merged";
}

bool ViewRenderer::State::summands() const { return requested.contains("ambient") || requested.contains("diffuse") || requested.contains("specular"); }

bool ViewRenderer::State::needs_centers() const {
  if (samples_wanted() == 1 || (scene.transparency != nullptr && !scene.transparent.empty())) return true;
  if (scene.occlusion != nullptr && !reads_only(*scene.occlusion, {"depth", "normal", "position"})) return true;
  const auto reads_more = [](const Instance* instance) { return !reads_only(*instance, {"color"}); };
  return std::any_of(scene.compositors.begin(), scene.compositors.end(), reads_more) || std::any_of(scene.overlays.begin(), scene.overlays.end(), reads_more) ||
         std::any_of(requested.begin(), requested.end(), [](const std::string& layer) { return layer != "color"; });
}

void ViewRenderer::State::drop_fine() {
  fine.clear();
  log.forget(1);
}

void ViewRenderer::State::forget_unused() {
  std::set<std::string> used;
  for (const auto* list : {&scene.compositors, &scene.overlays})
    for (const Instance* instance : *list) used.insert(instance->id());
  for (const Instance* instance : {scene.occlusion, scene.transparency})
    if (instance != nullptr) used.insert(instance->id());
  for (const auto* surfaces : {&scene.opaque, &scene.transparent})
    for (const SceneSurface& surface : *surfaces)
      for (const Instance* splitter : surface.splitters) used.insert(splitter->id());
  std::erase_if(memories, [&](const auto& memory) { return !used.contains(memory.first.substr(memory.first.rfind('/') + 1)); });
}

void ViewRenderer::State::draw_picture(bool final) {
  forget_unused();
  geometry = geometry_of(whole());
  main = geometry_of({.picture = size, .size = size});
  if (final && !needs_centers()) return draw_mean_alone();
  prepare_splitters();
  const FrameContext frame = context(0, whole(), geometry, centers);
  draw_surfaces(frame);
  draw_occlusion(frame);
  const std::string scene_layer = light_scene(frame);
  const std::uint64_t content = Hash().add(centers.revision(scene_layer)).add(centers.revision("transparent")).value();
  if (content != content_key) {
    content_key = content;
    samples = 1;
    return draw_compositors(scene_layer);
  }
  if (samples > samples_wanted()) samples = 1;  // fewer than before
  if (samples < samples_wanted() && !progressive_unfinished()) add_samples(false);
  if (samples >= samples_wanted()) drop_fine();
  draw_compositors(samples > 1 ? "mean" : scene_layer);
}

void ViewRenderer::State::prepare() {
  find();
  if (content_key != 0 || scene.view == nullptr || needs_centers()) return;
  geometry = geometry_of(whole());
  for (const SampleLayer& layer : sample_layers(scene.occlusion != nullptr)) centers.allocate(layer.name, layer.format, geometry.size());
}

void ViewRenderer::State::draw_mean_alone() {
  const bool occluded = scene.occlusion != nullptr;
  // What stands for the center of a pixel is its first sample.
  PictureWindow window = whole();
  window.offset = sample_offset(0, samples_wanted() / samples_of_round) - 0.25f;
  geometry = geometry_of(window);
  if (opaque_key() != content_key) samples = 0;
  if (samples == 0) {
    if (content_key != 0) centers.clear();  // not what prepare() made
    log.forget();
    prepare_splitters();
    while (samples < samples_wanted()) add_samples(occluded);
    drop_fine();
    content_key = opaque_key();
  }
  if (occluded && centers.find("mean open") != nullptr) {
    const FrameContext frame = context(0, window, geometry, centers);
    draw_occlusion(frame);
    if (progressive_unfinished()) return;
    add_attenuated(frame, *centers.find("mean open"), visibility_of(frame).layer, *centers.find("mean"), scene_pixels);
    centers.keep({"mean"});  // nobody reads the rest again
    log.forget(0);
    centers.drawn("mean");
    content_key = opaque_key();  // by now it is known which files the occlusion uses
  }
  draw_compositors("mean");
}

std::uint64_t ViewRenderer::State::opaque_key() {
  const FrameContext frame = context(0, whole(), geometry, centers);
  Hash hash;
  hash.add(surfaces_key(frame, scene.opaque)).add(frame.light_key).add(shading.signature(shaders)).add(shading.opaque_revision());
  hash.add(samples_wanted()).add(shaders.revision("host/lighting.glsl"));
  if (scene.occlusion != nullptr) {
    const PluginPassMemory& memory = memories[scene.occlusion->id()];
    hash.add(scene.occlusion->number()).add(scene.occlusion->draw_revision());
    for (const std::string& file : memory.files) hash.add(shaders.revision(file));
    if (memory.uses_time) hash.add(frame.geometry.block.transparent_extent.w);
  }
  return hash.value();
}

std::vector<ViewRenderer::State::SampleLayer> ViewRenderer::State::sample_layers(bool apart) const {
  constexpr float far = std::numeric_limits<float>::infinity();
  std::vector<SampleLayer> layers{{"mean", lumen::Format::RGBA32F}};
  for (const std::string& layer : requested)
    if (layer == "ambient" || layer == "diffuse" || layer == "specular" || layer == "transparent") layers.push_back({"mean " + layer, lumen::Format::RGBA32F});
  if (requested.contains("opacity") && !requested.contains("transparent")) layers.push_back({"mean transparent", lumen::Format::RGBA32F});
  if (apart)  // for the occlusion alone
    layers.insert(layers.end(), {{"normal", lumen::Format::RGBA16F}, {"depth", lumen::Format::R32F, far}, {"depth_buffer", lumen::Format::depth32F, 1}});
  return layers;
}

void ViewRenderer::State::begin_samples(bool apart) {
  for (const SampleLayer& layer : sample_layers(apart)) {
    const float empty[4] = {layer.empty, 0, 0, 0};
    const GLenum channels = layer.format == lumen::Format::depth32F ? GL_DEPTH_COMPONENT : layer.format == lumen::Format::R32F ? GL_RED : GL_RGBA;
    glClearTexImage(centers.allocate(layer.name, layer.format, geometry.size()).name(), 0, channels, GL_FLOAT, empty);
  }
}

void ViewRenderer::State::add_samples(bool apart) {
  const int round = samples / samples_of_round, rounds = samples_wanted() / samples_of_round;
  if (round == 0) begin_samples(apart);
  const int border = this->border();
  scene_pixels = pixels_of(geometry, scene.split_bounds);
  const int across = windows_across(scene_pixels.size());
  for (int i = 0; i < across * across; ++i) {
    const glm::ivec2 place(i % across, i / across);
    const PixelBox pixels{scene_pixels.begin + scene_pixels.size() * place / across, scene_pixels.begin + scene_pixels.size() * (place + 1) / across};
    if (pixels.size().x < 1 || pixels.size().y < 1) continue;
    const PictureWindow window{.picture = size, .origin = pixels.begin - border, .size = pixels.size(), .border = border, .scale = 2, .offset = sample_offset(round, rounds)};
    const ViewGeometry sample = geometry_of(window);
    const FrameContext frame = context(1, window, sample, fine);
    draw_surfaces(frame);
    std::string lit = "lit";
    if (apart) {
      run_lighting_pass(frame, LightingOutput::apart);
      if (round == 0) pick_samples(frame, centers, pixels);
    } else {
      lit = light_scene(frame);
    }
    add_to_mean(frame, *fine.find(lit), *centers.find("mean"), pixels, round);
    if (apart) {
      const lumen::gl::Texture& open = centers.allocate("mean open", lumen::Format::RGBA32F, glm::max(scene_pixels.size(), 1));
      add_to_mean(frame, *fine.find("open"), open, {pixels.begin - scene_pixels.begin, pixels.end - scene_pixels.begin}, round);
    }
    for (const char* layer : {"ambient", "diffuse", "specular", "transparent"}) {
      const lumen::gl::Texture *source = fine.find(layer), *mean = centers.find(std::string("mean ") + layer);
      if (source != nullptr && mean != nullptr) add_to_mean(frame, *source, *mean, pixels, round);
    }
  }
  for (const char* layer : {"mean", "mean ambient", "mean diffuse", "mean specular", "mean transparent"}) centers.drawn(layer);
  samples = samples_of_round * (round + 1);
}

bool ViewRenderer::State::reads_front() const {
  const auto reads = [](const Instance* instance) { return !reads_none(*instance, {"front_depth", "front_normal"}); };
  return std::any_of(scene.compositors.begin(), scene.compositors.end(), reads) || std::any_of(scene.overlays.begin(), scene.overlays.end(), reads);
}

void ViewRenderer::State::draw_compositors(const std::string& scene_layer) {
  const FrameContext frame = context(0, whole(), geometry, centers);
  picture = scene_layer;
  LayerNames reads = front_layers(centers);
  const auto run = [&](Instance& instance, auto&& draw) {
    const std::string output = "color of " + instance.id();
    reads["color"] = picture;
    PluginPass pass(frame, instance, memories[instance.id()], reads, {{"color", output}});
    pass.run(draw);
    picture = output;
  };
  for (Instance* instance : scene.compositors)
    run(*instance, [&](PluginPass& in) { instance->as<lumen::Compositor>(Kind::compositor)->render(in); });
  for (Instance* instance : scene.overlays)
    run(*instance, [&](PluginPass& in) { instance->as<lumen::Interactor>(Kind::interactor)->draw(in); });
}

}  // namespace lumenshop
