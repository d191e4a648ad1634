/// The bar at the bottom: what the mouse does, what is at work, how long the picture took.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "jobs/scheduler.h"
#include "window/layout.h"

namespace lumenshop {

struct Status {
  bool blender_keys = false;
  bool building = false;
  std::vector<JobStatus> jobs;
  double milliseconds = 0;       ///< of the last drawing of the view
  glm::ivec2 size{0};
  std::function<void(const std::string& instance)> cancel;
};

void draw_status_bar(const Rectangle& place, const Status& status);

}  // namespace lumenshop
