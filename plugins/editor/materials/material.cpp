#include "material.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <lumen/error.h>

namespace {

namespace files = std::filesystem;

// Captured materials say it in their names; other pictures of spheres show them as they are seen.
constexpr std::string_view equidistant_mark = ".equidistant";

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) result += c;
  }
  return result + "\"";
}

bool is_picture(const files::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  for (const char* known : {".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff", ".hdr", ".pfm", ".ppm", ".tga", ".bmp", ".webp"})
    if (extension == known) return true;
  return false;
}

}  // namespace

const char* name_of(Role role) { return role == Role::front ? "front" : role == Role::back ? "back" : "highlight"; }

std::string Material::json(const std::string& more) const {
  std::string text = more;
  for (const auto& [property, value] : values) text += (text.empty() ? "" : ", ") + quoted(property) + ": " + value;
  return "{" + text + "}";
}

std::vector<Material> generated_materials() {
  std::vector<Material> all;
  for (const char* name : {"clay", "skin", "bone", "artery", "vein", "jade", "porcelain", "gold", "chrome", "toon", "x-ray", "blueprint", "soft highlight", "sharp highlight", "window highlight"})
    all.push_back({.name = name, .type = "importer.lit_sphere", .values = {{"material", quoted(name)}, {"mapping", "\"equidistant\""}}, .equidistant = true,
                   .highlight = std::string_view(name).ends_with("highlight")});
  return all;
}

std::vector<Material> materials_in(const std::string& folder) {
  std::vector<Material> all;
  std::error_code error;
  for (files::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (!is_picture(entry->path()) || !entry->is_regular_file(error)) continue;
    std::string name = entry->path().stem().string();
    const bool equidistant = std::string_view(name).ends_with(equidistant_mark);
    if (equidistant) name.resize(name.size() - equidistant_mark.size());
    all.push_back({.name = std::move(name), .type = "importer.image", .values = {{"path", quoted(entry->path().string())}}, .equidistant = equidistant, .seen = true});
  }
  std::sort(all.begin(), all.end(), [](const Material& a, const Material& b) { return a.name < b.name; });
  return all;
}

void add_to_folder(const std::string& file, const std::string& folder) {
  const files::path from(file);
  if (!is_picture(from)) throw lumen::Error(from.filename().string(), "is no picture that can be read", "choose a PNG, EXR, JPEG, TIFF ...");
  std::error_code error;
  files::create_directories(folder, error);
  files::path to = files::path(folder) / from.filename();
  if (files::equivalent(from, to, error)) return;
  for (int number = 2; files::exists(to, error); ++number) {
    std::string name = from.stem().string();
    const bool marked = std::string_view(name).ends_with(equidistant_mark);
    if (marked) name.resize(name.size() - equidistant_mark.size());
    to = files::path(folder) / (name + "-" + std::to_string(number) + (marked ? std::string(equidistant_mark) : "") + from.extension().string());
  }
  if (!files::copy_file(from, to, error)) throw lumen::Error(file, "could not be copied to " + to.string() + ": " + error.message());
}
