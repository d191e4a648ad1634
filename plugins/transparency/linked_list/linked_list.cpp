/// Exact transparency: all fragments of a pixel in a list, sorted when the picture is put together.
/// Yang, Hensley, Gruen, Thibieroz, Real-Time Concurrent Linked List Construction on the GPU, EGSR 2010.

#include "../fragment_lists.h"

namespace {

struct LinkedList : lumen::Transparency {
  using Transparency::Transparency;

  lumen::Property<float> memory{this, "memory", 128.0f, {.min = 1, .max = FragmentLists::most_megabytes, .unit = "MB", .doc = "what the fragments may take, 20 bytes each; those that find no room are counted and missing", .logarithmic = true}};

  lumen::Writes transparent{this, "transparent", lumen::Format::RGBA32F};

  void render(lumen::TransparencyFrame& frame) override {
    constexpr const char* shader = "transparency/linked_list.glsl";
    lists_.gather(frame, shader, double(memory), *this);
    frame.fullscreen(shader, {.function = "resolve"});
  }
  void released() override { lists_.release(); }
  std::size_t bytes() const override { return lists_.bytes(); }

 private:
  FragmentLists lists_;
};

}  // namespace

LUMEN_PLUGIN(LinkedList, "transparency.linked_list", "Exact transparency by lists of fragments that are sorted per pixel. Yang, Hensley, Gruen, Thibieroz, Real-Time Concurrent Linked List Construction on the GPU, EGSR 2010.")
