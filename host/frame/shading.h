/// The view's shading: the terms of all styles fused into one function, never a second copy of a term's code.
///
/// Lighting: radiance = ambient * visibility + sum over lights (diffuse + specular); specular only where N.L > 0.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <lumen/gl/buffer.h>
#include <lumen/occlusion.h>

#include "frame/light_block.h"
#include "frame/program_text.h"
#include "frame/value_table.h"
#include "model/session.h"

namespace lumenshop {

/// The terms of one surface; null = none.
struct SurfaceStyle {
  static constexpr std::array kinds = {lumen::Kind::ambient, lumen::Kind::diffuse, lumen::Kind::specular, lumen::Kind::opacity};
  std::array<Instance*, 4> terms{};  ///< in the order of `kinds`
};

/// What a renderer's references say; a reference to what is missing, disabled or of another kind is none.
SurfaceStyle style_of(const Session& session, const Instance& renderer);

/// A surface to be lit.
struct LitSurface {
  Instance* renderer;
  Instance* interior = nullptr;          ///< the splitter that says how its inside looks; null: as its outside
  bool transparent = false;
};

class Shading {
 public:
  /// Collects the styles of these renderers, and gives each combination of terms a number.
  void update(const Session& session, const std::vector<LitSurface>& surfaces, const ValueTable& values);
  /// The style table, and the rows of terms that only one instance has.
  void bind(const ValueTable& values) const;
  /// The one style of a program that draws this renderer alone.
  void bind_style(const Instance& renderer) const;

  /// Changes when the generated text would: styles, constants, files.
  std::uint64_t signature(ShaderLibrary& library) const;
  /// Differs whenever values differ that the styles' terms and materials have: of all surfaces, or of the opaque ones.
  std::uint64_t value_revision() const { return value_revision_; }
  std::uint64_t opaque_revision() const { return opaque_revision_; }
  const SurfaceStyle& style(const Instance& renderer) const;
  /// The row of the style of its inside; 0: it has none of its own.
  int interior_row(const Instance& renderer) const;

  /// Adds shade(s, visibility) for these lights; `with_opacity`: also opacity_of(s). `only`: the one renderer whose
  /// surfaces are met, or null.
  void write(ProgramText& text, lumen::Attenuates attenuates, LightKinds lights, bool with_opacity, const Instance* only) const;
  /// The only renderer that there is, if it has one style; else null.
  const Instance* single() const { return styles_.size() == 1 && interiors_.empty() ? styles_.begin()->first : nullptr; }
  /// How many lights there are goes into lib/lights.glsl's block; this is its size limit.
  static constexpr int light_limit = 16;

 private:
  struct Term {
    const Instance* instance;
    std::string file, properties, prefix;  ///< properties: the text with a neutral prefix, to compare
    bool shared = false;                   ///< several instances: their rows are looked up per pixel
  };
  struct Variant {
    std::array<int, 4> terms;  ///< indices into terms_, -1 = none
    bool operator==(const Variant&) const = default;
  };
  struct Interior {
    int row, variant;
  };
  int term_index(const Instance& instance);
  int variant_index(const SurfaceStyle& style);
  int binding_of(int term) const;
  std::string shade_case(const Variant& variant, LightKinds lights, bool own) const;

  std::vector<Term> terms_;
  std::vector<Variant> variants_;
  std::map<const Instance*, SurfaceStyle> styles_;
  std::map<const Instance*, int> variant_of_;
  std::map<const Instance*, Interior> interiors_;  ///< by renderer
  std::uint64_t value_revision_ = 0, opaque_revision_ = 0;
  lumen::gl::Buffer table_;
};

}  // namespace lumenshop
