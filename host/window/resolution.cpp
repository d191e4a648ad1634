#include "window/resolution.h"

namespace lumenshop {

void Resolution::took(double seconds, int divider) {
  // A quarter of the pixels does not take a quarter of the time: going finer needs some room, or it would swing.
  constexpr double pixels_per_step = 4, room = 0.7;
  if (seconds > budget && divider < 4) divider_ = divider * 2;
  else if (divider > 1 && seconds * pixels_per_step < budget * room) divider_ = divider / 2;
  else divider_ = divider;
}

}  // namespace lumenshop
