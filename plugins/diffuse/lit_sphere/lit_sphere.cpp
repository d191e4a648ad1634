/// Shading from pictures of spheres: the ambient, diffuse and specular part. Sloan, Martin, Gooch, Gooch, The Lit Sphere,
/// Graphics Interface 2001; in light space Todo, Anjyo, Yokoyama, Lit-Sphere Extension, The Visual Computer 2013.

#include <algorithm>
#include <limits>

#include <lumen/image.h>
#include <lumen/term.h>

namespace {

using lumen::Choice;
using lumen::Color;
using lumen::Property;

/// The least luminous color of the sphere in the picture, the disc that fills it; black if there is none.
Color darkest(const lumen::Image& picture) {
  const std::size_t channels = picture.channels.size();
  const float radius_x = 0.5f * float(picture.width), radius_y = 0.5f * float(picture.height);
  float least = std::numeric_limits<float>::infinity();
  Color color;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float across = (float(x) + 0.5f) / radius_x - 1, up = (float(y) + 0.5f) / radius_y - 1;
      if (across * across + up * up > 1) continue;
      const float* texel = picture.pixels.data() + (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * channels;
      const float alpha = channels == 2 || channels == 4 ? texel[channels - 1] : 1.0f;
      if (alpha < 0.5f) continue;
      const glm::vec3 rgb = glm::max((channels < 3 ? glm::vec3(texel[0]) : glm::vec3(texel[0], texel[1], texel[2])) / alpha, glm::vec3(0));
      const float luminance = glm::dot(rgb, glm::vec3(0.2126f, 0.7152f, 0.0722f));
      if (!(luminance < least)) continue;
      least = luminance;
      color = Color(rgb);
    }
  return color;
}

Property<Choice> mapping_of(lumen::Plugin* owner, const char* id, const char* picture) {
  return {owner, id, {"orthographic"}, {.doc = "how the picture shows its sphere: as a rendered one, or by the angle from its center, half a turn across", .when = picture,
                                        .choices = {"orthographic", "equidistant"}, .advanced = true}};
}

Property<Color> dark_of(lumen::Plugin* owner, const char* id, const char* picture) {
  return {owner, id, {}, {.min = 0, .max = 1000, .doc = "where the light does not reach (view space: behind the silhouette); follows the picture's darkest color unless set",
                          .when = picture, .advanced = true}};
}

/// What all three parts share.
struct Lookup {
  explicit Lookup(lumen::Plugin* owner)
      : space{owner, "space", {"light"}, {.doc = "the picture's middle faces the light, or the eye", .choices = {"light", "view"}}},
        use_material{owner, "use_material", false, {.doc = "multiply by the material's color, which the picture else stands for"}},
        use_light{owner, "use_light", false, {.doc = "multiply by the light's color, intensity and falloff, which the picture else stands for"}} {}
  Property<Choice> space;
  Property<bool> use_material, use_light;
};

Property<Choice> frame_of(lumen::Plugin* owner) {
  return {owner, "frame", {"camera"}, {.doc = "which way is up around the light: the camera's axes turned onto it, or the surface's tangent, which twists at the poles",
                                       .when = "space = light", .choices = {"camera", "tangent"}, .advanced = true}};
}

struct AmbientLitSphere : lumen::Ambient {
  using Ambient::Ambient;

  lumen::Input<lumen::Image> front{this, "front", {.doc = "a picture of a sphere under the front light; none here and in `back`: the material's ambient color everywhere"}};
  lumen::Input<lumen::Image> back{this, "back", {.doc = "a picture of a sphere under the other lights; none: they add nothing"}};
  Lookup lookup{this};
  Property<Color> front_dark = dark_of(this, "front_dark", "front"), back_dark = dark_of(this, "back_dark", "back");

  void changed(std::string_view property) override {
    if (property == "front") front_dark.set_default(front.get() ? darkest(*front.get()) : Color());
    if (property == "back") back_dark.set_default(back.get() ? darkest(*back.get()) : Color());
  }
};

struct DiffuseLitSphere : lumen::Diffuse {
  using Diffuse::Diffuse;

  lumen::Input<lumen::Image> front{this, "front", {.doc = "a picture of a sphere under the front light; none: the material's color, fading with the angle"}};
  lumen::Input<lumen::Image> back{this, "back", {.doc = "a picture of a sphere under the other lights; none: they add nothing"}};
  Lookup lookup{this};
  Property<bool> fill_dark{this, "fill_dark", true, {.doc = "show the dark colors where a light does not reach; off: black, for ambient.lit_sphere shows them, with occlusion"}};
  Property<Choice> frame = frame_of(this), front_mapping = mapping_of(this, "front_mapping", "front"), back_mapping = mapping_of(this, "back_mapping", "back");
  Property<Color> front_dark = dark_of(this, "front_dark", "front"), back_dark = dark_of(this, "back_dark", "back");

  void changed(std::string_view property) override {
    if (property == "front") front_dark.set_default(front.get() ? darkest(*front.get()) : Color());
    if (property == "back") back_dark.set_default(back.get() ? darkest(*back.get()) : Color());
  }
};

struct SpecularLitSphere : lumen::Specular {
  using Specular::Specular;

  lumen::Input<lumen::Image> highlight{this, "highlight", {.doc = "a picture of a sphere's highlight on black; none: a round one of the material's color and shininess"}};
  Property<Choice> light{this, "light", {"front"}, {.doc = "which light drives the highlight", .choices = {"front", "back"}}};
  Lookup lookup{this};
  Property<Choice> frame = frame_of(this), highlight_mapping = mapping_of(this, "highlight_mapping", "highlight");
};

}  // namespace

LUMEN_PLUGIN(AmbientLitSphere, "ambient.lit_sphere", "The darkest colors of pictures of spheres, where their lights do not reach. Ostendorf 2021, section 4; Todo et al., Lit-Sphere Extension, TVC 2013.")
LUMEN_PLUGIN(DiffuseLitSphere, "diffuse.lit_sphere", "Light from pictures of spheres. Sloan et al., The Lit Sphere, Graphics Interface 2001; Todo et al., Lit-Sphere Extension, TVC 2013.")
LUMEN_PLUGIN(SpecularLitSphere, "specular.lit_sphere", "A highlight from the picture of a sphere. Sloan et al., The Lit Sphere, Graphics Interface 2001; Todo et al., Lit-Sphere Extension, TVC 2013.")
