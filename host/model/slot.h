/// One declared property and what it holds.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include <lumen/property.h>

#include "model/json_value.h"
#include "model/link.h"

namespace lumenshop {

class Instance;

struct Slot {
  lumen::PropertySpec spec;
  lumen::Value own;                 ///< set value, or the default
  bool set = false;
  bool retracted = false;           ///< a run-time property whose object is gone
  bool relative = false;            ///< a path that was given relative to the session's folder
  std::unique_ptr<Link> link;       ///< null = a value of its own
  Json unresolved;                  ///< JSON that was given but does not fit; saved again as it is; null = none
  std::string error;                ///< why a value or link does not hold; shown at the property
  std::string data_state = "pending";  ///< outputs: "pending", "ready", or why it failed

  lumen::Value effective;           ///< what read() gives; of a linked slot: as of `checked_at`
  std::uint64_t revision = 1;       ///< of `effective`
  std::uint64_t notified = 0;       ///< the revision that the object last heard of

  Instance* owner = nullptr;

  /// What LinkGraph remembers between two reads. `source` is valid only while the graph's structure is `resolved_at`.
  struct Followed {
    Slot* source = nullptr;
    std::uint64_t source_revision = 0, resolved_at = 0, checked_at = 0;
    bool walking = false;
  } followed;
};

}  // namespace lumenshop
