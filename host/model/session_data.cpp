// The session that the program makes for data files alone.
#include <cmath>

#include <lumen/error.h>

#include "model/session.h"

namespace lumenshop {

namespace {

Json object_of(std::initializer_list<std::pair<const char*, Json>> members) {
  Json object = Json::object();
  for (const auto& [key, value] : members) object[key] = value;
  return object;
}

Json linked(const std::string& source) { return object_of({{"link", source}}); }

Json direction(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  Json result = Json::array();
  for (const double component : {x, y, z}) result.push_back(std::round(component / length * 1e6) / 1e6);  // readable in the file
  return result;
}

}  // namespace

void Session::load_data(const std::vector<std::filesystem::path>& files, const std::function<std::string(const std::filesystem::path&)>& importer_of) {
  Json plugins = Json::object();
  const auto put = [&](const std::string& id, const char* type, Json properties = Json::object()) {
    if (!factory_.has(type)) return false;
    Json entry = object_of({{"type", type}});
    entry.update(properties);
    plugins[id] = std::move(entry);
    return true;
  };
  const auto reference = [](bool there, const char* id) { return there ? Json(id) : Json(nullptr); };

  const bool ambient = put("ambient", "ambient.constant");
  const bool diffuse = put("lambert", "diffuse.lambert");
  const bool specular = put("blinn", "specular.blinn");
  Json renderers = Json::array();
  Session importers(factory_);  // asked for what they make
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string number = i == 0 ? "" : std::to_string(i + 1);
    const std::string importer = importer_of(files[i]);
    if (importer.empty()) throw lumen::Error(files[i].string(), "no importer reads this kind of file");
    put("data" + number, importer.c_str(), object_of({{"path", std::filesystem::absolute(files[i]).lexically_normal().string()}}));
    if (importers.add(importer).slot_of("mesh") < 0) continue;
    Json surface = object_of({{"mesh", linked("data" + number + ".mesh")}});
    const std::pair<const char*, Json> terms[] = {
        {"ambient", reference(ambient, "ambient")}, {"diffuse", reference(diffuse, "lambert")}, {"specular", reference(specular, "blinn")}};
    for (const auto& [term, id] : terms)
      if (!id.is_null()) surface[term] = id;
    if (put("surface" + number, "renderer.surface", surface)) renderers.push_back("surface" + number);
  }
  if (renderers.empty() && factory_.has("renderer.surface") && !files.empty())
    throw lumen::Error(files[0].string(), "holds no surface, and is shown only where a session links to it", "name it in a session");

  Json lights = Json::array(), interactors = Json::array(), compositors = Json::array();
  const bool camera = put("camera", "interactor.orbit");
  if (put("front", "interactor.light", object_of({{"direction", direction(0.35, -1, 0.6)}, {"intensity", 0.8}}))) {
    put("back", "interactor.light", object_of({{"direction", direction(-0.5, 1, 0.2)}, {"intensity", 0.35}}));
    lights = interactors = {"front", "back"};
  }
  if (camera) interactors.push_back("camera");
  if (put("background", "compositor.background")) compositors.push_back("background");

  Json view = Json::object();
  if (camera) view["camera"] = "camera";
  view["lights"] = lights;
  view["renderers"] = renderers;
  if (put("ssao", "occlusion.ssao")) view["occlusion"] = "ssao";
  view["compositors"] = compositors;
  view["interactors"] = interactors;

  Json session = object_of({{"lumenshop", 1}, {"plugins", plugins}});
  session["views"] = object_of({{"main", view}});
  replace(std::move(session), {}, std::filesystem::current_path(), "data");
}

}  // namespace lumenshop
