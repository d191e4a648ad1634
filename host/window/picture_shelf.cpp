#include "window/picture_shelf.h"

#include <nlohmann/json.hpp>

namespace lumenshop {

PictureShelf::PictureShelf(PluginFactory& types, Helper* helper, std::function<void()> wake) : session_(types), scheduler_(session_, helper, std::move(wake)) {}

std::shared_ptr<const lumen::Image> PictureShelf::take(const std::string& type, const std::string& properties) {
  const std::string key = type + properties;
  const auto known = makers_.find(key);
  if (known == makers_.end()) {
    const Json values = Json::parse(properties, nullptr, false);
    if (!values.is_object()) throw lumen::Error(type, "its values are no JSON object");
    const std::string id = session_.add(type).id();
    makers_[key] = id;
    try {
      for (const auto& [property, value] : values.items()) session_.set(id + "." + property, value);
      session_.resolve(id + ".image");
    } catch (...) {
      forget(key);
      throw;
    }
    update();
    return nullptr;
  }
  const auto [instance, slot] = session_.resolve(known->second + ".image");
  const std::string state = instance->slots()[std::size_t(slot)]->data_state;
  if (state == "pending") return nullptr;
  auto picture = std::dynamic_pointer_cast<const lumen::Image>(std::get<lumen::DataPointer>(instance->read(slot)));
  forget(key);
  if (!picture) throw lumen::Error(state == "ready" ? type + ": there is no picture" : state);
  return picture;
}

void PictureShelf::forget(const std::string& key) {
  session_.remove(makers_.at(key));
  session_.history().clear();
  makers_.erase(key);
}

bool PictureShelf::update() {
  session_.update();
  return scheduler_.update();
}

}  // namespace lumenshop
