/// A picture of a sphere that a surface can be given, and where it comes from.
#pragma once

#include <string>
#include <utility>
#include <vector>

/// What the picture stands for.
enum class Role { front, back, highlight };
const char* name_of(Role role);

struct Material {
  std::string name;         ///< as shown
  std::string type;         ///< of the importer that makes its picture
  std::vector<std::pair<std::string, std::string>> values;  ///< what makes it this material: the importer's properties, as JSON
  bool equidistant = false;  ///< how the picture shows the sphere
  bool seen = false;         ///< the picture shows its light where the eye saw it, not in its middle: suits view space
  bool highlight = false;    ///< a highlight on black

  /// `values` and more as one JSON object.
  std::string json(const std::string& more = {}) const;
};

/// The materials that importer.lit_sphere makes.
std::vector<Material> generated_materials();

/// Pictures in a folder, by name; none if there is no such folder.
std::vector<Material> materials_in(const std::string& folder);

/// Copies a picture into the folder, under a name that is free. Throws lumen::Error.
void add_to_folder(const std::string& file, const std::string& folder);
