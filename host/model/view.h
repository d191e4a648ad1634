/// A view: what one picture is made of. All of it is properties, so views link, too.
#pragma once

#include <lumen/plugin.h>

namespace lumenshop {

struct View : lumen::Plugin {
  using Plugin::Plugin;
  lumen::Kind kind() const override { return lumen::Kind::view; }

  lumen::Property<lumen::Reference> camera{this, "camera", {}, {.doc = "the interactor that is the camera", .accepts = "camera"}};
  lumen::Property<lumen::References> lights{this, "lights", {}, {.doc = "front light first, back light second", .accepts = "light"}};
  lumen::Property<lumen::References> renderers{this, "renderers", {}, {.doc = "what is drawn", .accepts = "renderer"}};
  lumen::Property<lumen::Reference> occlusion{this, "occlusion", {}, {.doc = "ambient occlusion, or none", .accepts = "occlusion"}};
  lumen::Property<int> occluded_layers{this, "occluded_layers", 1, {.min = 0, .max = 4, .doc = "how many transparent layers from the front get an occlusion of their own; deeper ones share the last", .when = "occlusion"}};
  lumen::Property<lumen::Reference> transparency{this, "transparency", {}, {.doc = "how transparent surfaces are composed", .accepts = "transparency"}};
  lumen::Property<lumen::References> compositors{this, "compositors", {}, {.doc = "what happens to the picture, in order", .accepts = "compositor"}};
  lumen::Property<lumen::References> interactors{this, "interactors", {}, {.doc = "what input goes to, in order; the camera last", .accepts = "interactor"}};
  lumen::Property<int> antialiasing{this, "antialiasing", 4, {.min = 1, .max = 16, .doc = "samples per pixel of the finished picture: 1, 4 or 16"}};
  lumen::Property<float> time{this, "time", 0.0f, {.unit = "seconds", .doc = "the moment that animated plugins show"}};
  lumen::Property<bool> encode_srgb{this, "encode_srgb", true, {.doc = "encode 8-bit output and the window as sRGB; off shows linear values as they are"}};
};

}  // namespace lumenshop
