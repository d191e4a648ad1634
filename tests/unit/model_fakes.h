/// Small plugins of several kinds and a factory for them: what the tests of sessions work with.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <lumen/importer.h>
#include <lumen/interactor.h>
#include <lumen/mesh.h>
#include <lumen/term.h>
#include <lumen/volume.h>

#include "model/plugin_factory.h"
#include "model/session.h"

namespace lumenshop::fakes {

/// What the objects were told, in order: "box changed width".
struct Log {
  std::vector<std::string> lines;
  int count(const std::string& line) const { return static_cast<int>(std::count(lines.begin(), lines.end(), line)); }
};

/// One property of each type.
struct Box : lumen::Diffuse {
  Box(lumen::Binding& binding, Log& log) : Diffuse(binding), log(log) {}
  ~Box() override { log.lines.push_back(id() + " destroyed"); }
  void changed(std::string_view property) override { log.lines.push_back(id() + " changed " + std::string(property)); }
  void released() override { log.lines.push_back(id() + " released"); }
  Log& log;
  lumen::Property<bool> flag{this, "flag", false};
  lumen::Property<int> count{this, "count", 3, {.min = 0, .max = 10}};
  lumen::Property<float> width{this, "width", 1.0f, {.min = 0, .max = 100}};
  lumen::Property<float> height{this, "height", 2.0f};
  lumen::Property<glm::vec2> pair{this, "pair", glm::vec2(0)};
  lumen::Property<glm::vec3> offset{this, "offset", glm::vec3(0)};
  lumen::Property<glm::vec4> four{this, "four", glm::vec4(0)};
  lumen::Property<lumen::Color> tint{this, "tint", lumen::Color(0.5f, 0.5f, 0.5f), {.min = 0, .max = 1, .affects = lumen::Affects::shading}};
  lumen::Property<glm::quat> turn{this, "turn", glm::quat(1, 0, 0, 0)};
  lumen::Property<glm::mat4> matrix{this, "matrix", glm::mat4(1)};
  lumen::Property<std::string> text{this, "text", "", {.affects = lumen::Affects::nothing}};
  lumen::Property<lumen::Path> file{this, "file"};
  lumen::Property<lumen::Choice> mode{this, "mode", {"plain"}, {.choices = {"plain", "sorted", "none"}}};
  lumen::Property<float> bias{this, "bias", 0.0f, {.when = "mode = sorted"}};
  lumen::Property<float> gain{this, "gain", 0.0f, {.when = "opacity != none"}};
  lumen::Property<float> glow{this, "glow", 0.0f, {.when = "flag"}};
  lumen::Property<lumen::TransferFunction> map{this, "map", {{0, 1}, {{0, glm::vec4(0)}, {1, glm::vec4(1)}}}};
  lumen::Property<std::vector<int>> numbers{this, "numbers"};
  lumen::Property<std::vector<float>> weights{this, "weights"};
  lumen::Property<std::vector<std::string>> words{this, "words"};
  lumen::Property<lumen::Reference> opacity{this, "opacity", {}, {.accepts = "opacity"}};
  lumen::Property<lumen::Reference> eye{this, "eye", {}, {.accepts = "camera"}};
  lumen::Property<lumen::References> terms{this, "terms", {}, {.accepts = "diffuse"}};
};

struct Source : lumen::Importer {
  using Importer::Importer;
  lumen::Property<lumen::Path> path{this, "path"};
  lumen::Output<lumen::Mesh> mesh{this, "mesh"};
  void compute(lumen::Job&) const override {}
};

struct Sink : lumen::Diffuse {
  using Diffuse::Diffuse;
  lumen::Input<lumen::Mesh> mesh{this, "mesh"};
  lumen::Input<lumen::Volume> volume{this, "volume"};
};

struct Fade : lumen::Opacity {
  using Opacity::Opacity;
};

struct Orbit : lumen::Interactor {
  using Interactor::Interactor;
  bool is_camera() const override { return true; }
  lumen::Property<float> distance{this, "distance", 5.0f};
  lumen::Property<glm::vec3> pivot{this, "pivot", glm::vec3(0)};
};

struct Lamp : lumen::Interactor {
  using Interactor::Interactor;
  bool is_light() const override { return true; }
  lumen::Property<glm::vec3> direction{this, "direction", glm::vec3(0, 0, 1)};
  lumen::Property<float> intensity{this, "intensity", 1.0f};
};

/// A plugin whose declarations are given as a function: what a reload changes.
struct Scripted : lumen::Diffuse {
  template <class T>
  void add(const char* id, T value, lumen::PropertyOptions options = {}) {
    owned.push_back(std::make_unique<lumen::Property<T>>(this, id, std::move(value), std::move(options)));
  }
  Scripted(lumen::Binding& binding, const std::function<void(Scripted&)>& declare) : Diffuse(binding) { declare(*this); }
  void changed(std::string_view property) override {
    if (on_change) on_change(*this, property);
  }
  std::vector<std::shared_ptr<void>> owned;
  std::function<void(Scripted&, std::string_view)> on_change;
};

/// Makes what it was told to; a test changes it between two generations.
class Factory : public PluginFactory {
 public:
  using Maker = std::function<std::shared_ptr<lumen::Plugin>(lumen::Binding&)>;
  explicit Factory(Log& log) {
    makers["diffuse.box"] = [&log](lumen::Binding& binding) { return std::make_shared<Box>(binding, log); };
    add<Source>("importer.vtk");
    add<Sink>("diffuse.sink");
    add<Fade>("opacity.fade");
    add<Orbit>("interactor.orbit");
    add<Lamp>("interactor.light");
  }
  template <class T>
  void add(const std::string& type) {
    makers[type] = [](lumen::Binding& binding) { return std::make_shared<T>(binding); };
  }
  void script(const std::string& type, std::function<void(Scripted&)> declare) {
    makers[type] = [declare](lumen::Binding& binding) { return std::make_shared<Scripted>(binding, declare); };
  }
  std::shared_ptr<lumen::Plugin> create(const std::string& type, lumen::Binding& binding) override {
    const auto maker = makers.find(type);
    return maker == makers.end() ? nullptr : maker->second(binding);
  }
  bool has(const std::string& type) const override { return makers.contains(type); }
  int generation(const std::string& type) const override { return has(type) ? number : 0; }
  std::map<std::string, Maker> makers;
  int number = 1;
};

/// A session with the boxes a, b and c.
struct Bench {
  Log log;
  Factory factory{log};
  Session session{factory};

  explicit Bench(const std::string& plugins = R"({"a": {"type": "diffuse.box"}, "b": {"type": "diffuse.box"}, "c": {"type": "diffuse.box"}})") {
    open(plugins);
  }
  void open(const std::string& plugins) { session.load(Json::parse(R"({"lumenshop": 1, "plugins": )" + plugins + "}"), "/sessions"); }
  template <class T>
  T read(const std::string& path) {
    const auto [instance, slot] = session.resolve(path);
    return std::get<T>(instance->read(slot));
  }
  float number(const std::string& path) { return read<float>(path); }
  void json(const std::string& path, const std::string& text) { session.set(path, Json::parse(text)); }
  Json saved(const std::string& id) { return session.to_json()["plugins"][id]; }
  lumen::PropertyState state(const std::string& path) {
    const auto [instance, slot] = session.resolve(path);
    return session.state(*instance, slot);
  }
  Box& box(const std::string& id) { return *static_cast<Box*>(session.find(id)->plugin()); }
  bool has_problem(const std::string& words) {
    for (const auto& problem : session.problems())
      if (problem.message.find(words) != std::string::npos) return true;
    return false;
  }
};

/// What a call's lumen::Error says; empty if it did not throw.
template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const lumen::Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace lumenshop::fakes
