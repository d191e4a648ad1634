/// A GL 4.5 core context without a window: EGL surfaceless, no X server.
#pragma once

#include <memory>

namespace lumenshop {

class HeadlessContext {
 public:
  /// Makes it current on this thread. Throws lumen::Error with the driver's reason.
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumenshop
