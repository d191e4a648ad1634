/// One plugin in the states that its author's file goes through; the build says which.
#ifdef VARIANT_OTHER_ABI
#include <lumen/abi.h>
#undef LUMEN_ABI
#define LUMEN_ABI "another"
#endif
#include <lumen/term.h>

namespace {

struct Subject : lumen::Ambient {
  explicit Subject(lumen::Binding& binding) : Ambient(binding) {
#if defined VARIANT_THROWS
    throw lumen::Error("it does not want to");
#elif defined VARIANT_CRASHES
    *nowhere = 1;
#elif defined VARIANT_MOODY
    // The probe's instance is named after its type.
    if (binding.id() == "linked") throw lumen::Error("not for this one");
#endif
  }
  int* volatile nowhere = nullptr;

#if defined VARIANT_SECOND
  lumen::Property<float> strength{this, "strength", 0.75f, {.min = 0, .max = 1, .doc = "how much"}};
  lumen::Property<float> extra{this, "extra", 2.0f, {.doc = "was not there before"}};
#elif defined VARIANT_RETYPED
  lumen::Property<float> strength{this, "strength", 0.5f, {.min = 0, .max = 0.2, .doc = "how much, but not too much"}};
  lumen::Property<float> steps{this, "steps", 3.0f, {.doc = "a number that needs no longer be whole"}};
#else
  lumen::Property<float> strength{this, "strength", 0.5f, {.min = 0, .max = 1, .doc = "how much"}};
  lumen::Property<int> steps{this, "steps", 3, {.min = 1, .max = 9, .doc = "how often"}};
#endif
#ifdef VARIANT_UNCLEAN
  lumen::Property<bool> unclean{this, "unclean", true, {.doc = "draws what is not a number"}};
#endif
};

struct Second : lumen::Ambient {
  using Ambient::Ambient;
};

}  // namespace

#ifndef VARIANT_WITHOUT
LUMEN_PLUGIN(Subject, "ambient.subject", "What is reloaded.")
#endif
#if defined VARIANT_PAIR || defined VARIANT_WITHOUT
LUMEN_PLUGIN(Second, "ambient.second", "Another type of the same library.")
#endif
