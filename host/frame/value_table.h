/// The values of all instances as shaders see them: one buffer with a row of vec4 per instance, transfer functions in a
/// texture, pictures in another. A new value or instance rewrites the buffer and recompiles nothing, except properties
/// declared constant.
///
/// A program that draws for known instances has their rows bound as uniform blocks, so that it reads them at constant
/// offsets: software GL broadcasts those, but gathers what is indexed, which made a full-screen pass 20 times slower.
#pragma once

#include <map>
#include <string>

#include <lumen/gl/buffer.h>
#include <lumen/gl/texture.h>

#include "frame/image_atlas.h"
#include "frame/program.h"
#include "frame/property_rows.h"
#include "model/session.h"

namespace lumenshop {

class ValueTable {
 public:
  /// Rewrites what changed since the last call.
  void update(const Session& session);
  /// Where the instance's values begin; views have none.
  int row_of(const Instance& instance) const;
  /// Makes buffer and textures current for the program.
  void bind(Program& program) const;
  /// Makes the instance's row the uniform block `binding`.
  void bind_row(int binding, const Instance& instance) const;
  /// What shaders cannot be given.
  std::vector<lumen::Problem> problems() const;

 private:
  void update_pictures(const Session& session);
  void upload(std::vector<lumen::TransferFunction> functions);

  std::uint64_t revision_ = 0;
  std::map<const Instance*, int> rows_;
  lumen::gl::Buffer values_;
  lumen::gl::Texture transfer_functions_;
  std::vector<lumen::TransferFunction> uploaded_;
  ImageAtlas pictures_;
};

}  // namespace lumenshop
