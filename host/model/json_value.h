/// Values as the JSON of sessions and of --set, both ways.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <lumen/property.h>

namespace lumenshop {

using Json = nlohmann::ordered_json;

/// Vectors and colors are arrays, rotations [x, y, z, w], mat4 16 numbers row by row, choices and references strings.
Json to_json(const lumen::Value& value);

/// The value for a property; ranges are clamped. Throws lumen::Error: the wrong JSON type, a number that is not finite,
/// an unknown choice, a list beyond 65536 entries.
lumen::Value from_json(const Json& json, const lumen::PropertySpec& spec);

/// What a link makes of a value: bool -> int -> float, vec3 <-> color, scalar -> vector, equal types; nothing else.
bool convertible(lumen::ValueType from, lumen::ValueType to);
lumen::Value convert(const lumen::Value& value, const lumen::PropertySpec& target);

/// Into the property's range, component by component; rotations become unit; choices outside the list become the default.
lumen::Value clamped(lumen::Value value, const lumen::PropertySpec& spec);

}  // namespace lumenshop
