/// Adds an instance: a search over the types that there are.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "modules/registry.h"

namespace lumenshop {

class AddPopup {
 public:
  void open(std::vector<TypeInfo> types);
  /// `add` gets the type id of what was chosen.
  void draw(const std::function<void(const std::string& type)>& add);

 private:
  std::vector<TypeInfo> types_;
  std::string filter_;
  bool open_ = false, appears_ = false;
};

}  // namespace lumenshop
