/// Properties: declared once by a plugin, kept by the host.
///
/// From one declaration come the control in the window, the place in the session, the value in the shader, the row of
/// the reference and the range of the validator. A read follows links; a write through an identity link sets the source.
/// Thread: the host's main thread only. Work on other threads reads the frozen copy that its Job holds.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>

#include <lumen/data.h>
#include <lumen/value.h>

namespace lumen {

class Plugin;
struct Mesh;
struct Lines;
struct Volume;
struct Image;

/// What must be drawn again when the value changes.
enum class Affects {
  draw,     ///< what the instance draws or computes, and all that reads it (default)
  shading,  ///< only the lighting: the instance's geometry stays as drawn
  nothing,  ///< no pixel: state of the window, say
};

/// All fields have defaults; use designated initializers.
struct PropertyOptions {
  double min = -std::numeric_limits<double>::infinity();  ///< inclusive, per component
  double max = std::numeric_limits<double>::infinity();   ///< inclusive, per component
  double step = 0;               ///< 0 = from the range
  std::string unit = {};         ///< "degrees", "world", "scene radii", "pixels"; empty = a pure number
  std::string doc = {};          ///< one sentence, lower case, no full stop
  std::string group = {};        ///< heading in the panel; empty = the first, unnamed group
  std::string when = {};         ///< the condition of its effect: "mode", "mode = sorted" or "mode != none", of a property of the same instance
  std::string accepts = {};      ///< reference(s): a kind's name, "camera" or "light"; path: "open" (default), "save" or "folder"
  std::vector<std::string> choices = {};  ///< the names that a Choice can take
  bool logarithmic = false;      ///< dragged in log space; needs min > 0
  bool advanced = false;         ///< folded away under "More"
  bool constant = false;         ///< compiled into the shader: fast to read, slow to change
  Affects affects = Affects::draw;
};

/// What the host knows of a property. Owns its strings: nothing points into a plugin's library.
struct PropertySpec {
  std::string id;                 ///< [a-z][a-z0-9_]*, not "type"
  ValueType type = ValueType::real;
  Value default_value;
  PropertyOptions options;
  DataKind data_kind = DataKind::mesh;  ///< for ValueType::data
  bool output = false;                  ///< data that the plugin makes: never set, never saved
};

/// A property without its type: the plugin's name for a slot of the host.
class PropertyBase {
 public:
  PropertyBase(const PropertyBase&) = delete;
  PropertyBase& operator=(const PropertyBase&) = delete;

  int slot() const { return slot_; }
  std::string_view id() const;
  /// A person, a script or a file gave it a value (even the default's).
  bool is_set() const;
  /// Grows whenever the value read here changes, through links, too.
  std::uint64_t revision() const;
  /// Makes `source` ("instance.property") drive this one. Throws Error: cycle, no such property, not convertible.
  void link(const std::string& source, const std::string& expression = {});
  void unlink();  ///< keeps the current value

 protected:
  PropertyBase(Plugin* owner, PropertySpec spec);
  ~PropertyBase();  ///< a property made at run time goes with its object; its value is kept for its return
  const Value& read() const;
  void write(Value value);
  void write_default(Value value);

 private:
  Plugin* owner_;
  int slot_;
};

namespace detail {
template <class T>
struct Traits;
#define LUMEN_VALUE_TYPE(TYPE, ENUM) \
  template <> struct Traits<TYPE> { static constexpr ValueType type = ValueType::ENUM; };
LUMEN_VALUE_TYPE(bool, boolean)
LUMEN_VALUE_TYPE(int, integer)
LUMEN_VALUE_TYPE(float, real)
LUMEN_VALUE_TYPE(glm::vec2, vec2)
LUMEN_VALUE_TYPE(glm::vec3, vec3)
LUMEN_VALUE_TYPE(glm::vec4, vec4)
LUMEN_VALUE_TYPE(Color, color)
LUMEN_VALUE_TYPE(glm::quat, rotation)
LUMEN_VALUE_TYPE(glm::mat4, mat4)
LUMEN_VALUE_TYPE(std::string, string)
LUMEN_VALUE_TYPE(Path, path)
LUMEN_VALUE_TYPE(Choice, choice)
LUMEN_VALUE_TYPE(TransferFunction, transfer_function)
LUMEN_VALUE_TYPE(std::vector<int>, integers)
LUMEN_VALUE_TYPE(std::vector<float>, reals)
LUMEN_VALUE_TYPE(std::vector<std::string>, strings)
LUMEN_VALUE_TYPE(Reference, reference)
LUMEN_VALUE_TYPE(References, references)
#undef LUMEN_VALUE_TYPE

template <class T> constexpr DataKind data_kind_of() {
  if constexpr (std::is_same_v<T, Mesh>) return DataKind::mesh;
  else if constexpr (std::is_same_v<T, Lines>) return DataKind::lines;
  else if constexpr (std::is_same_v<T, Volume>) return DataKind::volume;
  else { static_assert(std::is_same_v<T, Image>, "data is Mesh, Lines, Volume or Image"); return DataKind::image; }
}
}  // namespace detail

/// A value that can be set, linked and observed.
template <class T>
class Property : public PropertyBase {
 public:
  Property(Plugin* owner, const char* id, T default_value = {}, PropertyOptions options = {})
      : PropertyBase(owner, {id, detail::Traits<T>::type, Value(std::move(default_value)), std::move(options)}) {}

  const T& get() const { return std::get<T>(read()); }
  operator const T&() const { return get(); }
  const T& operator*() const { return get(); }
  const T* operator->() const { return &get(); }
  /// Sets it, as a person would: it is saved and can be undone.
  void set(T value) { write(Value(std::move(value))); }
  /// Moves the default: a value that nobody set follows; nothing is saved.
  void set_default(T value) { write_default(Value(std::move(value))); }
};

/// Data that comes in through a link.
template <class T>
class Input : public PropertyBase {
 public:
  Input(Plugin* owner, const char* id, PropertyOptions options = {})
      : PropertyBase(owner, {id, ValueType::data, DataPointer{}, std::move(options), detail::data_kind_of<T>(), false}) {}
  /// Null until the source has data.
  std::shared_ptr<const T> get() const { return std::dynamic_pointer_cast<const T>(std::get<DataPointer>(read())); }
};

/// Data that this instance makes, in `compute`.
template <class T>
class Output : public PropertyBase {
 public:
  Output(Plugin* owner, const char* id, PropertyOptions options = {})
      : PropertyBase(owner, {id, ValueType::data, DataPointer{}, std::move(options), detail::data_kind_of<T>(), true}) {}
  std::shared_ptr<const T> get() const { return std::dynamic_pointer_cast<const T>(std::get<DataPointer>(read())); }
};

}  // namespace lumen
