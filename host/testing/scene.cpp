/// Scene of lumen/testing.h, over the same session, jobs and view renderer as the program.
#include <lumen/testing.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include <lumen/interactor.h>

#include "frame/headless.h"
#include "frame/shader_library.h"
#include "frame/view_renderer.h"
#include "installation.h"
#include "jobs/scheduler.h"
#include "model/session.h"
#include "modules/registry.h"
#include "testing/given.h"

namespace lumen::testing {
namespace {

using lumenshop::Instance;
using lumenshop::Json;

constexpr const char* empty_scene = R"({
  "lumenshop": 1,
  "plugins": {
    "camera": {"type": "interactor.orbit", "projection": "orthographic", "height": 2.2, "distance": 10, "pivot": [0, 0, 0], "rotation": [0, 0, 0, 1]},
    "front": {"type": "interactor.light", "direction": [0, 0, 1]}
  },
  "views": {"main": {"camera": "camera", "lights": ["front"], "antialiasing": 1}}
})";

/// What scenes of one process share while one of them lives: a driver's context and libraries are slow to come by.
struct Studio {
  lumenshop::HeadlessContext context;
  lumenshop::Registry registry;
  lumenshop::ShaderLibrary shaders;

  Studio() : registry({lumenshop::Installation::find().plugins()}, nullptr), shaders({lumenshop::Installation::find().shaders()}) {
    registry.load_all();
  }
  static std::shared_ptr<Studio> open() {
    static std::weak_ptr<Studio> shared;
    std::shared_ptr<Studio> studio = shared.lock();
    if (!studio) shared = studio = std::make_shared<Studio>();
    return studio;
  }
};

}  // namespace

struct Scene::State {
  std::shared_ptr<Studio> studio = Studio::open();
  lumenshop::GivenFactory factory{studio->registry};
  lumenshop::Session session{factory};
  lumenshop::Scheduler scheduler{session, nullptr};
  std::unique_ptr<lumenshop::ViewRenderer> view;
  std::vector<std::string> requested;

  void append(const char* list, const std::string& id) {
    const auto [main, slot] = session.resolve(std::string("main.") + list);
    auto references = std::get<References>(main->read(slot));
    references.ids.push_back(id);
    session.set(std::string("main.") + list, Value(std::move(references)));
  }
  void replace(const char* property, const std::string& id) { session.set(std::string("main.") + property, Value(Reference{id})); }

  void place(const Plugin& plugin, const std::string& id) {
    switch (plugin.kind()) {
      case Kind::renderer: return append("renderers", id);
      case Kind::compositor: return append("compositors", id);
      case Kind::occlusion: return replace("occlusion", id);
      case Kind::transparency: return replace("transparency", id);
      case Kind::interactor: {
        const auto& interactor = static_cast<const Interactor&>(plugin);
        if (interactor.is_camera()) return replace("camera", id);
        return append(interactor.is_light() ? "lights" : "interactors", id);
      }
      default: return;
    }
  }
  void finish() {
    session.update();
    scheduler.wait();
    session.update();
    view->finish();
  }
};

Scene::Scene(glm::ivec2 size) : state_(std::make_unique<State>()) {
  state_->session.load(Json::parse(empty_scene), lumenshop::Installation::find().root);
  state_->view = std::make_unique<lumenshop::ViewRenderer>(state_->session, state_->studio->shaders, "main");
  state_->view->resize(size);
}

Scene::~Scene() = default;

Plugin& Scene::add(const std::string& type, const std::string& id, std::string_view properties) {
  const Json values = Json::parse(properties, nullptr, false);
  if (!values.is_object()) throw Error(id, "its properties are no JSON object");
  Instance& instance = state_->session.add(type, id);
  if (!instance.plugin()) throw Error(id, "no plugin of type " + type);
  for (const auto& [property, value] : values.items()) state_->session.set(id + "." + property, value);
  state_->place(*instance.plugin(), id);
  return *instance.plugin();
}

void Scene::give(const std::string& id, DataPointer data) {
  state_->scheduler.wait();
  Instance* instance = state_->session.find(id);
  if (!instance) instance = &state_->session.add(lumenshop::Given::type, id);
  if (instance->type() != lumenshop::Given::type) throw Error(id, "is a " + instance->type() + ", which takes no data from a test");
  static_cast<lumenshop::Given*>(instance->plugin())->give(std::move(data));
}

void Scene::surface(const std::string& id, std::shared_ptr<const Mesh> mesh, std::string_view properties) {
  give(id + "_data", std::move(mesh));
  add("renderer.surface", id, properties);
  state_->session.link(id + ".mesh", id + "_data.mesh");
}

void Scene::set(const std::string& path, std::string_view json_or_text) {
  const Json json = Json::parse(json_or_text, nullptr, false);
  state_->session.set(path, json.is_discarded() ? Json(std::string(json_or_text)) : json);
}

void Scene::set_value(const std::string& path, Value value) { state_->session.set(path, std::move(value)); }

Value Scene::value(const std::string& path) const {
  const auto [instance, slot] = state_->session.resolve(path);
  return instance->read(slot);
}

void Scene::resize(glm::ivec2 size) { state_->view->resize(size); }

Pixels Scene::layer(const std::string& name) {
  std::vector<std::string>& requested = state_->requested;
  if (std::find(requested.begin(), requested.end(), name) == requested.end()) {
    requested.push_back(name);
    state_->view->request(requested);
  }
  state_->finish();
  return Pixels(state_->view->layer(name));
}

Pixels Scene::picture() { return layer("color"); }

int Scene::runs(const std::string& pass) const {
  int runs = 0;
  for (const lumenshop::PassStatistics& statistics : state_->view->statistics())
    if (statistics.name == pass) runs += statistics.runs;
  return runs;
}

std::vector<Problem> Scene::problems() const {
  std::vector<Problem> all = state_->session.problems();
  for (const auto& more : {state_->studio->registry.problems(), state_->view->problems()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace lumen::testing
