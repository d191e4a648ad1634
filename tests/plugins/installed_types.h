/// The type ids that the installation has of a kind.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "installation.h"
#include "modules/registry.h"

namespace lumenshop {

inline std::vector<std::string> installed_types(lumen::Kind kind) {
  Registry registry({Installation::find().plugins()}, nullptr);
  registry.load_all();
  std::vector<std::string> ids;
  for (const TypeInfo& info : registry.types())
    if (info.kind == kind) ids.push_back(info.id);
  EXPECT_FALSE(ids.empty()) << lumen::name_of(kind);
  return ids;
}

}  // namespace lumenshop
