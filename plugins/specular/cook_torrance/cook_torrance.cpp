/// Highlights of rough, mirroring facets. Cook, Torrance, A Reflectance Model for Computer Graphics, TOG 1982; facets of Trowbridge and Reitz 1975, Smith's masking, Schlick's Fresnel term.

#include <lumen/term.h>

namespace {

struct CookTorrance : lumen::Specular {
  using Specular::Specular;

  lumen::Property<float> sigma{this, "sigma", 0.2f, {.min = 0.01, .max = 1, .doc = "roughness of the surface: the width of the distribution of its facets' normals"}};
  lumen::Property<bool> squared{this, "squared", false, {.doc = "the width is sigma squared, as later models take their roughness; else sigma itself, as the source prints it"}};
  lumen::Property<float> n1{this, "n1", 1.0f, {.min = 1, .max = 100, .doc = "refractive index around the surface; 1 is air", .logarithmic = true}};
  lumen::Property<float> n2{this, "n2", 2.0f, {.min = 1, .max = 1e6, .doc = "refractive index of the surface; very large values make a mirror, which reflects all light", .logarithmic = true}};
  lumen::Property<lumen::Choice> masking{this, "masking", lumen::Choice{"separable"}, {.doc = "Smith's masking of facets: for light and eye on their own, or correlated by the facets' heights (Heitz, JCGT 2014), a little brighter at grazing angles", .when = "as_printed = false", .choices = {"separable", "correlated"}}};
  lumen::Property<bool> as_printed{this, "as_printed", false, {.doc = "F D G / (pi (N.L) (N.V)), as eq. 3.15 of Ostendorf 2021 prints it, without N.L: bright up to the terminator"}};
};

}  // namespace

LUMEN_PLUGIN(CookTorrance, "specular.cook_torrance", "Highlights of rough, mirroring facets. Cook, Torrance, A Reflectance Model for Computer Graphics, TOG 1982; facets of Trowbridge and Reitz 1975, Smith's masking, Schlick's Fresnel term.")
