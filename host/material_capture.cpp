#include "material_capture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <lumen/interactor.h>
#include <lumen/mesh.h>
#include <lumen/renderer.h>

#include "frame/shader_library.h"
#include "frame/shading.h"
#include "frame/view_renderer.h"
#include "frame/view_scene.h"
#include "jobs/scheduler.h"
#include "model/json_value.h"
#include "testing/given.h"

namespace lumenshop {
namespace {

using lumen::Kind;
using lumen::ValueType;

/// The half of a sphere that faces +z, spread over the picture: a disc of radius 1/2 whose normals turn evenly from the
/// middle outward, in a wider one that keeps the rim's normals. Finer than the picture needs, since normals are interpolated.
std::shared_ptr<lumen::Mesh> spread_sphere() {
  constexpr int rings = 128, segments = 256;
  constexpr float beyond = 0.75f;             // past the corners of the picture
  constexpr float rim = 0.9999f;              // of a right angle: a normal there still faces the eye
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  for (int ring = 0; ring <= rings + 1; ++ring) {
    const float part = float(std::min(ring, rings)) / rings, radius = ring > rings ? beyond : 0.5f * part;
    const float angle = part * rim * std::numbers::pi_v<float> / 2;
    for (int segment = 0; segment <= segments; ++segment) {
      const float turn = 2 * std::numbers::pi_v<float> * float(segment) / segments;
      const glm::vec2 outward(std::cos(turn), std::sin(turn));
      positions.emplace_back(radius * outward, 0);
      normals.emplace_back(std::sin(angle) * outward, std::cos(angle));
    }
  }
  const auto index = [&](int ring, int segment) { return std::uint32_t(ring * (segments + 1) + segment); };
  for (int ring = 0; ring <= rings; ++ring)
    for (int segment = 0; segment < segments; ++segment) {
      triangles.emplace_back(index(ring, segment), index(ring + 1, segment), index(ring + 1, segment + 1));
      if (ring > 0) triangles.emplace_back(index(ring, segment), index(ring + 1, segment + 1), index(ring, segment + 1));
    }
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->positions = std::move(positions);
  mesh->normals = std::move(normals);
  mesh->triangles = std::move(triangles);
  mesh->origin = "sphere";
  mesh->finish();
  return mesh;
}

/// A session that holds nothing but the sphere, its look, and the lights in the camera's frame.
class Studio {
 public:
  explicit Studio(PluginFactory& types) : types_(types) {
    give("sphere", spread_sphere());
    surface_ = {{"type", "renderer.surface"}, {"mesh", {{"link", "sphere.mesh"}}}};
    plugins_["eye"] = {{"type", "interactor.orbit"}, {"projection", "orthographic"}, {"height", 1.0}, {"distance", 10.0}, {"pivot", {0, 0, 0}}, {"rotation", {0, 0, 0, 1}}};
  }

  void dress(const Session& session, const Instance& surface) {
    copy(surface, surface_, {"ambient_color", "diffuse_color", "specular_color", "shininess"});
    const SurfaceStyle style = style_of(session, surface);
    for (std::size_t i = 0; i < 3; ++i) {
      if (style.terms[i] == nullptr) continue;
      const std::string name(lumen::name_of(SurfaceStyle::kinds[i]));
      Json term = {{"type", style.terms[i]->type()}};
      copy(*style.terms[i], term, {}, name);
      plugins_[name] = std::move(term);
      surface_[name] = name;
    }
  }

  void light(const lumen::Light& light, glm::vec3 center, const glm::mat3& to_view) {
    const glm::vec3 path = light.point ? light.position - center : light.direction;
    const float distance = std::max(glm::length(path), 1e-6f);
    float falloff = 1;
    if (light.point && light.falloff == lumen::Light::Falloff::linear) falloff = distance;
    if (light.point && light.falloff == lumen::Light::Falloff::quadratic) falloff = distance * distance;
    const glm::vec3 direction = to_view * (path / distance), radiance = light.color / falloff;
    const float intensity = std::max({radiance.r, radiance.g, radiance.b, 0.0f});
    const glm::vec3 color = intensity > 0 ? radiance / intensity : glm::vec3(0);
    const std::string id = "light" + std::to_string(lights_.size());
    plugins_[id] = {{"type", "interactor.light"}, {"direction", {direction.x, direction.y, direction.z}}, {"color", {color.r, color.g, color.b}}, {"intensity", intensity}};
    lights_.push_back(id);
  }

  std::shared_ptr<lumen::Image> shoot(ShaderLibrary& shaders, int size) {
    plugins_["ball"] = surface_;
    for (const auto& [id, data] : given_) plugins_[id] = {{"type", Given::type}};
    const Json view = {{"camera", "eye"}, {"lights", lights_}, {"renderers", Json::array({"ball"})}, {"antialiasing", 1}};
    Session session(types_);
    session.load({{"lumenshop", 1}, {"plugins", plugins_}, {"views", {{"main", view}}}}, std::filesystem::path("/"));
    for (const auto& [id, data] : given_) static_cast<Given*>(session.find(id)->plugin())->give(data);
    session.update();
    Scheduler scheduler(session, nullptr);
    scheduler.wait();
    session.update();
    ViewRenderer renderer(session, shaders, "main");
    renderer.resize({size, size});
    renderer.request({"color"});
    renderer.finish();
    for (const auto& problems : {session.problems(), renderer.problems()})
      for (const lumen::Problem& problem : problems)
        if (problem.severity == lumen::Severity::error) throw lumen::Error(problem.message);
    return renderer.layer("color");
  }

 private:
  void give(const std::string& id, lumen::DataPointer data) { given_.emplace_back(id, std::move(data)); }

  /// What properties are now (`only` these, or all that were set or linked); data under ids of its own.
  void copy(const Instance& from, Json& to, std::initializer_list<std::string_view> only, const std::string& name = {}) {
    const auto& slots = from.slots();
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const Slot& slot = *slots[i];
      const std::string& id = slot.spec.id;
      if (slot.retracted || slot.spec.output || slot.spec.type == ValueType::reference || slot.spec.type == ValueType::references) continue;
      if (only.size() > 0 && std::find(only.begin(), only.end(), id) == only.end()) continue;
      const lumen::Value& value = from.read(int(i));
      if (slot.spec.type != ValueType::data) {
        if (only.size() > 0 || slot.set || slot.link) to[id] = to_json(value);
      } else if (const auto& data = std::get<lumen::DataPointer>(value)) {
        give(name + "_" + id, data);
        to[id] = {{"link", name + "_" + id + "." + std::string(lumen::name_of(data->kind()))}};
      }
    }
  }

  GivenFactory types_;
  Json plugins_ = Json::object(), surface_;
  std::vector<std::string> lights_;
  std::vector<std::pair<std::string, lumen::DataPointer>> given_;
};

}  // namespace

std::shared_ptr<lumen::Image> captured_material(const Session& session, const std::string& surface, const std::string& view, PluginFactory& types,
                                                ShaderLibrary& shaders, int size) {
  const Instance* instance = session.find(surface);
  const auto* renderer = instance == nullptr ? nullptr : instance->as<lumen::Renderer>(Kind::renderer);
  if (renderer == nullptr || instance->slot_of("diffuse") < 0) throw lumen::Error(surface, "is no surface whose look could be captured");
  const ViewScene scene = find_scene(session, view);
  lumen::Camera camera;
  if (scene.camera != nullptr) camera = scene.camera->as<lumen::Interactor>(Kind::interactor)->camera();

  Studio studio(types);
  studio.dress(session, *instance);
  const lumen::Bounds bounds = renderer->bounds();
  for (const Instance* light : scene.lights)
    studio.light(light->as<lumen::Interactor>(Kind::interactor)->light(camera), bounds.empty() ? glm::vec3(0) : bounds.center(), glm::mat3(camera.view));
  const auto shot = studio.shoot(shaders, size);

  auto picture = std::make_shared<lumen::Image>();
  picture->width = shot->width;
  picture->height = shot->height;
  picture->channels = {"R", "G", "B"};
  picture->origin = surface;
  const std::size_t channels = shot->channels.size(), count = shot->pixels.size() / channels;
  std::vector<float> pixels(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c) pixels[3 * i + c] = shot->pixels[i * channels + c];
  picture->pixels = std::move(pixels);
  picture->finish();
  return picture;
}

std::filesystem::path save_material(Scheduler& scheduler, Instance& exporter, std::shared_ptr<lumen::Image> picture, const std::filesystem::path& folder,
                                    const std::string& name) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw lumen::Error(folder.string(), "the gallery's folder cannot be made: " + error.message());
  std::filesystem::path file;
  for (int number = 1; file.empty() || std::filesystem::exists(file, error); ++number)
    file = folder / (name + (number > 1 ? "-" + std::to_string(number) : "") + equidistant_mark + ".exr");
  scheduler.write_file(exporter, std::move(picture), file);
  return file;
}

}  // namespace lumenshop
