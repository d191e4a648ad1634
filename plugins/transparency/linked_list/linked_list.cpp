/// Exact transparency: all fragments of a pixel in a list, sorted when the picture is put together.
/// Yang, Hensley, Gruen, Thibieroz, Real-Time Concurrent Linked List Construction on the GPU, EGSR 2010.

#include "../fragment_lists.h"

namespace {

struct LinkedList : ListedTransparency {
  explicit LinkedList(lumen::Binding& binding) : ListedTransparency(binding, "transparency/linked_list.glsl") {}
};

}  // namespace

LUMEN_PLUGIN(LinkedList, "transparency.linked_list", "Exact transparency by lists of fragments that are sorted per pixel. Yang, Hensley, Gruen, Thibieroz, Real-Time Concurrent Linked List Construction on the GPU, EGSR 2010.")
