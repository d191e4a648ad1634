#include "frame/view_scene.h"

#include <algorithm>

#include <lumen/interactor.h>
#include <lumen/mesh.h>
#include <lumen/renderer.h>
#include "frame/shading.h"

namespace lumenshop {
namespace {

using lumen::Kind;

/// A term says by lumen::Reads that it reads the surface's curvature.
bool reads_curvature(const Instance& term) {
  const auto& reads = term.plugin()->reads();
  return std::any_of(reads.begin(), reads.end(), [](const lumen::Reads* layer) { return layer->layer() == "curvature"; });
}

bool has_curvature(const lumen::Mesh& mesh) {
  const lumen::Attribute* tensor = mesh.attribute("curvature");
  return tensor != nullptr && tensor->components == 6 && tensor->on == lumen::Attribute::On::points && !mesh.normals.empty();
}

class Finder {
 public:
  Finder(const Session& session, const std::string& view, ViewScene& scene) : session_(session), view_(view), scene_(scene) {}

  /// The enabled instance of that kind, or null; what is named but not there is a problem that the session reports itself.
  Instance* find(const std::string& id, Kind kind) const {
    Instance* instance = id.empty() ? nullptr : session_.find(id);
    return instance != nullptr && instance->plugin() != nullptr && instance->kind() == kind && instance->enabled() ? instance : nullptr;
  }
  std::vector<Instance*> find_all(const lumen::References& references, Kind kind) const {
    std::vector<Instance*> found;
    for (const std::string& id : references.ids)
      if (Instance* instance = find(id, kind); instance != nullptr && std::find(found.begin(), found.end(), instance) == found.end())
        found.push_back(instance);
    return found;
  }
  void problem(lumen::Severity severity, const std::string& instance, const std::string& message) const {
    scene_.problems.push_back({.severity = severity, .instance = instance, .message = message});
  }

  /// `without`: a splitter that is left out.
  SceneSurface surface(Instance& instance, const std::string& without) const {
    SceneSurface surface{.instance = &instance};
    const int slot = instance.slot_of("splitter");
    if (slot < 0) return surface;
    if (const auto* references = std::get_if<lumen::References>(&instance.read(slot))) surface.splitters = find_all(*references, Kind::splitter);
    std::erase_if(surface.splitters, [&](const Instance* splitter) { return splitter->id() == without; });
    for (Instance* splitter : surface.splitters) {
      const int look = splitter->slot_of("interior");
      const auto* choice = look < 0 ? nullptr : std::get_if<lumen::Choice>(&splitter->read(look));
      if (surface.interior == nullptr && choice != nullptr && !(*choice == "none")) surface.interior = splitter;
    }
    return surface;
  }

 private:
  const Session& session_;
  std::string view_;
  ViewScene& scene_;
};

}  // namespace

std::vector<LitSurface> ViewScene::lit_surfaces() const {
  std::vector<LitSurface> all;
  for (const auto* list : {&opaque, &transparent})
    for (const SceneSurface& surface : *list) all.push_back({surface.instance, surface.interior, list == &transparent});
  return all;
}

ViewScene find_scene(const Session& session, const std::string& id, const std::string& substitute) {
  Instance* instance = session.find(id);
  auto* view = instance == nullptr ? nullptr : instance->as<View>(Kind::view);
  if (view == nullptr) throw lumen::Error("view '" + id + "'", "the session has no such view");
  ViewScene scene{.view = view};
  const Finder finder(session, id, scene);

  scene.camera = finder.find(view->camera.get().id, Kind::interactor);
  if (scene.camera != nullptr && !scene.camera->as<lumen::Interactor>(Kind::interactor)->is_camera()) scene.camera = nullptr;
  for (Instance* light : finder.find_all(view->lights, Kind::interactor))
    if (light->as<lumen::Interactor>(Kind::interactor)->is_light()) scene.lights.push_back(light);
  if (scene.lights.size() > Shading::light_limit) {
    finder.problem(lumen::Severity::warning, id, "only the first 16 lights shine");
    scene.lights.resize(Shading::light_limit);
  }
  scene.occlusion = finder.find(view->occlusion.get().id, Kind::occlusion);
  scene.transparency = finder.find(view->transparency.get().id, Kind::transparency);
  if (Instance* other = finder.find(substitute, Kind::occlusion)) scene.occlusion = other;
  if (Instance* other = finder.find(substitute, Kind::transparency)) scene.transparency = other;
  scene.compositors = finder.find_all(view->compositors, Kind::compositor);
  scene.interactors = finder.find_all(view->interactors, Kind::interactor);
  for (Instance* interactor : scene.interactors)
    if (!interactor->plugin()->writes().empty()) scene.overlays.push_back(interactor);

  for (Instance* renderer : finder.find_all(view->renderers, Kind::renderer)) {
    const lumen::Bounds bounds = renderer->as<lumen::Renderer>(Kind::renderer)->bounds();
    if (bounds.empty()) continue;
    SceneSurface surface = finder.surface(*renderer, substitute);
    scene.bounds.include(bounds);
    const Instance* opacity = style_of(session, *renderer).terms[3];
    const bool transparent = opacity != nullptr;
    if (transparent && scene.transparency == nullptr)
      finder.problem(lumen::Severity::warning, renderer->id(),
                     "has an opacity, but view '" + id + "' has no transparency: drawn opaque; give the view one, say transparency.weighted");
    const std::shared_ptr<const lumen::Mesh> mesh = transparent && reads_curvature(*opacity) ? renderer->as<lumen::Renderer>(Kind::renderer)->traced().mesh : nullptr;
    if (mesh != nullptr && !has_curvature(*mesh))
      finder.problem(lumen::Severity::note, renderer->id(),
                     "its mesh has no curvature, which '" + opacity->id() + "' reads: it makes do with the normals; link the mesh through filter.curvature");
    (transparent && scene.transparency != nullptr ? scene.transparent : scene.opaque).push_back(std::move(surface));
  }
  return scene;
}

lumen::Bounds bounds_cut_by(const Session& session, const Instance& splitter) {
  lumen::Bounds bounds;
  for (const std::unique_ptr<Instance>& instance : session.plugins()) {
    const auto* renderer = instance->as<lumen::Renderer>(Kind::renderer);
    const int slot = renderer == nullptr || !instance->enabled() ? -1 : instance->slot_of("splitter");
    const auto* splitters = slot < 0 ? nullptr : std::get_if<lumen::References>(&instance->read(slot));
    if (splitters != nullptr && std::find(splitters->ids.begin(), splitters->ids.end(), splitter.id()) != splitters->ids.end()) bounds.include(renderer->bounds());
  }
  return bounds;
}

}  // namespace lumenshop
