/// Whether the session draws cleanly, asked by a reload: with the window's own views.
#pragma once

#include "modules/reloader.h"
#include "workshop.h"

namespace lumenshop {

class LiveFrameCheck final : public FrameCheck {
 public:
  explicit LiveFrameCheck(Workshop& workshop) : workshop_(workshop) {}
  std::string try_frame() override;
  void shaders_changed(const std::vector<std::filesystem::path>& files) override;

 private:
  Workshop& workshop_;
};

}  // namespace lumenshop
