#include <lumen/splitter.h>

namespace lumen {

Interior::Interior(Plugin* owner, const char* default_look)
    : look(owner, "interior", Choice{default_look},
           {.doc = "how the inside looks where the cut opens it: as the outside, one color, lit, lit as the face of the cut, or closed by a cap",
            .group = "Interior", .choices = {"none", "flat", "lit", "cut_surface", "cap"}}),
      color(owner, "interior_color", Color(1, 0.1f, 0), {.min = 0, .max = 1, .doc = "material color of ambient and diffuse term inside", .group = "Interior", .when = "interior != none", .affects = Affects::shading}),
      specular_color(owner, "interior_specular_color", Color(0.2f, 0.2f, 0.2f), {.min = 0, .max = 1, .doc = "material color of the specular term inside", .group = "Interior", .when = "interior != none", .affects = Affects::shading}),
      shininess(owner, "interior_shininess", 40.0f, {.min = 0.1, .max = 1000, .doc = "exponent of the specular term inside", .group = "Interior", .when = "interior != none", .logarithmic = true, .affects = Affects::shading}),
      ambient(owner, "interior_ambient", {}, {.doc = "ambient term inside; none: the surface's own", .group = "Interior", .when = "interior != none", .accepts = "ambient", .advanced = true, .affects = Affects::shading}),
      diffuse(owner, "interior_diffuse", {}, {.doc = "diffuse term inside; none: the surface's own", .group = "Interior", .when = "interior != none", .accepts = "diffuse", .advanced = true, .affects = Affects::shading}),
      specular(owner, "interior_specular", {}, {.doc = "specular term inside; none: the surface's own", .group = "Interior", .when = "interior != none", .accepts = "specular", .advanced = true, .affects = Affects::shading}) {}

}  // namespace lumen
