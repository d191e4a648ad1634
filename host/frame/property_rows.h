/// The properties of an instance as its shader sees them: rows of four floats, and the GLSL that reads them.
#pragma once

#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "model/session.h"

namespace lumenshop {

/// Uniform block bindings of rows. Terms of a program's styles take `term_count` from `terms` on.
namespace row_binding {
constexpr int own = 2, transparency = 3, terms = 4, term_count = 8, style = 12, splitter = 13, any = -1;
}

/// Rows that a property takes: 0 if shaders do not see its type.
int row_count(const lumen::PropertySpec& spec);
/// Appends the rows of a value that holds its numbers itself; those of a transfer function or an image are places in a
/// texture, which the value table knows.
void append_rows(const lumen::PropertySpec& spec, const lumen::Value& value, std::vector<glm::vec4>& rows);

/// GLSL of `struct <prefix>Properties` and `<prefix>Properties <prefix>load(int row)` for an instance. Equal for
/// instances of one type, unless they have properties of their own or different constants. With a `binding` the values
/// are those of the bound row; with row_binding::any those of the row that is asked for.
std::string properties_text(const Instance& instance, const std::string& prefix, int binding);
/// Differs where properties_text differs.
std::uint64_t properties_signature(const Instance& instance);

}  // namespace lumenshop
