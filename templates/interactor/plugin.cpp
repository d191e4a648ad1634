/// A key that counts how often it was pressed.

#include <lumen/interactor.h>

namespace {

struct @Class@ : lumen::Interactor {
  using Interactor::Interactor;

  lumen::Property<std::string> key{this, "key", std::string("K"), {.doc = "which key it listens to", .affects = lumen::Affects::nothing}};
  lumen::Property<int> presses{this, "presses", 0, {.min = 0, .doc = "how often the key was pressed; link it to what it shall drive"}};

  bool input(const lumen::InputEvent& event, lumen::ViewInput&) override {
    if (event.type != lumen::InputEvent::Type::key || event.key != key.get()) return false;
    presses.set(presses + 1);
    return true;
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "interactor.@name@", "A key that counts how often it was pressed.")
