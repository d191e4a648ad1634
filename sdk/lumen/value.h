/// What a property can hold.
///
/// A Value is a plain variant: the host keeps it, sessions write it as JSON, shaders read it from a buffer.
/// Colors are linear RGB. Rotations are unit quaternions.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lumen {

struct Data;

/// Linear RGB, each component 0..1 unless the property's range says otherwise.
struct Color {
  glm::vec3 rgb{0};
  Color() = default;
  Color(float red, float green, float blue) : rgb(red, green, blue) {}
  explicit Color(glm::vec3 linear) : rgb(linear) {}
  bool operator==(const Color&) const = default;
};

/// A file. Relative paths of a session are relative to the session's folder; plugins see absolute ones.
struct Path {
  std::string file;
  bool operator==(const Path&) const = default;
};

/// One of the names that the property's options list. Shaders see the index of the name.
struct Choice {
  std::string name;
  bool operator==(const Choice&) const = default;
  bool operator==(std::string_view other) const { return name == other; }
};

/// Color and opacity over a scalar range; piecewise linear. Any color map is one, too.
struct TransferFunction {
  struct Point {
    float x = 0;           ///< position in `range`, in data units
    glm::vec4 rgba{0, 0, 0, 1};  ///< linear color, opacity
    bool operator==(const Point&) const = default;
  };
  glm::vec2 range{0, 1};      ///< data units, range.x < range.y
  std::vector<Point> points;  ///< sorted by x, at least two
  bool operator==(const TransferFunction&) const = default;
  /// The function at `x`, clamped to the first and last point; opaque white if there are no points.
  glm::vec4 at(float x) const;
};

/// The id of another instance, or nothing.
struct Reference {
  std::string id;
  bool empty() const { return id.empty(); }
  bool operator==(const Reference&) const = default;
};

/// Ids of other instances, in order.
struct References {
  std::vector<std::string> ids;
  bool operator==(const References&) const = default;
};

using DataPointer = std::shared_ptr<const Data>;  ///< immutable; null = none yet

/// The order of the alternatives is the order of ValueType.
using Value = std::variant<bool, int, float, glm::vec2, glm::vec3, glm::vec4, Color, glm::quat, glm::mat4,
                           std::string, Path, Choice, TransferFunction, std::vector<int>, std::vector<float>,
                           std::vector<std::string>, Reference, References, DataPointer>;

enum class ValueType {
  boolean, integer, real, vec2, vec3, vec4, color, rotation, mat4,
  string, path, choice, transfer_function, integers, reals,
  strings, reference, references, data
};

inline ValueType type_of(const Value& value) { return static_cast<ValueType>(value.index()); }

/// The name in `describe` and in docs: "bool", "int", "float", "vec2" ... "transfer function", "data".
std::string_view name_of(ValueType type);

/// How many float components links and expressions see: bool, int and float 1, vec3 and color 3 ... 0 for all else.
int component_count(ValueType type);

}  // namespace lumen
