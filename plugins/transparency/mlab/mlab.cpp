/// Transparency by a few nodes per pixel, which merge where there are more layers.
/// Salvi, Vaidyanathan, Multi-Layer Alpha Blending, I3D 2014.

#include "../fragment_lists.h"

namespace {

/// The paper inserts fragments into the nodes as they are drawn, which needs ordered access to a pixel. Without it, the
/// fragments wait in a list, and stream through the nodes when the picture is put together.
struct Mlab : ListedTransparency {
  explicit Mlab(lumen::Binding& binding) : ListedTransparency(binding, "transparency/mlab.glsl") {}

  lumen::Property<int> nodes{this, "nodes", 4, {.min = 1, .max = 8, .doc = "how many layers of a pixel are kept apart; exact up to as many", .constant = true}};
  lumen::Property<lumen::Choice> merge{this, "merge", {"sum"}, {.doc = "what becomes of layers beyond the nodes: sum blends them by weighted sums behind the nodes, in whatever order they come; over merges them into the last node as the paper does, which depends on the order of drawing", .choices = {"sum", "over"}, .constant = true}};
  lumen::Property<float> decay{this, "decay", 4.0f, {.min = 0, .max = 20, .doc = "how strongly near fragments outweigh far ones behind the nodes: exp(-decay z), z = 0 at the nearest, 1 at the farthest surface", .when = "merge = sum"}};
};

}  // namespace

LUMEN_PLUGIN(Mlab, "transparency.mlab", "A few nodes per pixel: exact up to as many layers, what is beyond them is merged. Fragments wait in lists and stream through the nodes in the end, since the GL gives no ordered access to a pixel. Salvi, Vaidyanathan, Multi-Layer Alpha Blending, I3D 2014.")
