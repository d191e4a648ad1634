/// The parts of a surface that a splitter leaves alone, as a group of triangles of their own.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <lumen/components.h>
#include <lumen/splitter.h>

#include "torn_groups.h"

/// Groupings by mesh, kept while the mesh lives: a splitter may serve several surfaces.
class KeptParts {
 public:
  using Groups = std::shared_ptr<const std::vector<std::uint32_t>>;

  /// Groups 0, of what is asked, and 1, of the parts with these numbers; null if there are none or the mesh is null.
  Groups groups(const std::shared_ptr<const lumen::Mesh>& mesh, const std::vector<int>& numbers) {
    std::erase_if(known_, [&](const Known& known) { return known.mesh.expired() || known.numbers != numbers; });
    if (mesh == nullptr || numbers.empty()) return nullptr;
    const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& known) { return known.mesh.lock() == mesh; });
    if (found != known_.end()) return found->groups;
    std::vector<std::uint32_t> group = lumen::parts_of(*mesh).of_triangle;
    for (std::uint32_t& number : group) number = std::find(numbers.begin(), numbers.end(), int(number)) != numbers.end() ? 1 : 0;
    const bool torn = torn_groups(*mesh, group, 2)[0];
    known_.push_back({mesh, numbers, std::make_shared<const std::vector<std::uint32_t>>(std::move(group)), torn});
    return known_.back().groups;
  }

  /// Whether what is kept hangs together with the rest: where the rest leaves it, both are open. Of what groups() has given.
  bool torn(const Groups& groups) const {
    return std::any_of(known_.begin(), known_.end(), [&](const Known& known) { return known.groups == groups && known.torn; });
  }

  /// The surface of which fragments are removed but for these parts; with `rest` false, these parts are not drawn.
  lumen::Split split(const lumen::SplitSurface& surface, const std::vector<int>& numbers, bool rest = true) {
    lumen::Split split{.groups = groups(surface.mesh, numbers)};
    if (split.groups == nullptr) return split;
    split.parts = {{.group = 0}};
    if (rest) split.parts.push_back(kept(split.groups));
    return split;
  }

  /// The parts that stay.
  lumen::Part kept(const Groups& groups) const {
    lumen::Part part{.group = 1, .removable = false};
    if (!torn(groups)) part.openings.emplace();
    return part;
  }

 private:
  struct Known {
    std::weak_ptr<const lumen::Mesh> mesh;
    std::vector<int> numbers;
    Groups groups;
    bool torn;
  };
  std::vector<Known> known_;
};
