/// The values of all instances as shaders see them: one buffer with a row of vec4 per instance, transfer functions in a
/// texture. A new value or instance rewrites the buffer and recompiles nothing, except properties declared constant.
///
/// A program that draws for known instances has their rows bound as uniform blocks, so that it reads them at constant
/// offsets: software GL broadcasts those, but gathers what is indexed, which made a full-screen pass 20 times slower.
#pragma once

#include <map>
#include <string>

#include <lumen/gl/buffer.h>
#include <lumen/gl/texture.h>

#include "frame/program.h"
#include "model/session.h"

namespace lumenshop {

class ValueTable {
 public:
  /// Rewrites what changed since the last call.
  void update(const Session& session);
  /// Where the instance's values begin; views have none.
  int row_of(const Instance& instance) const;
  /// Makes buffer and texture current for the program.
  void bind(Program& program) const;
  /// Makes the instance's row the uniform block `binding`.
  void bind_row(int binding, const Instance& instance) const;

 private:
  std::uint64_t revision_ = 0;
  std::map<const Instance*, int> rows_;
  lumen::gl::Buffer values_;
  lumen::gl::Texture transfer_functions_;
  std::vector<lumen::TransferFunction> uploaded_;
};

/// Uniform block bindings of rows. Terms of a program's styles take `term_count` from `terms` on.
namespace row_binding {
constexpr int own = 2, transparency = 3, terms = 4, term_count = 8, style = 12, any = -1;
}

/// GLSL of `struct <prefix>Properties` and `<prefix>Properties <prefix>load(int row)` for an instance. Equal for
/// instances of one type, unless they have properties of their own or different constants. With a `binding` the values
/// are those of the bound row; with row_binding::any those of the row that is asked for.
/// Differs where properties_text differs.
std::uint64_t properties_signature(const Instance& instance);
std::string properties_text(const Instance& instance, const std::string& prefix, int binding);

}  // namespace lumenshop
