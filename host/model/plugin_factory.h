/// Who makes plugins for a session: the module registry, or a test's own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <lumen/plugin.h>

namespace lumenshop {

class PluginFactory {
 public:
  virtual ~PluginFactory() = default;
  /// Null if no library has the type. Throws lumen::Error if its constructor did.
  virtual std::shared_ptr<lumen::Plugin> create(const std::string& type, lumen::Binding& binding) = 0;
  virtual bool has(const std::string& type) const = 0;
  /// The build that create() makes now: 1, 2, ...; 0 for unknown types.
  virtual int generation(const std::string& type) const = 0;
};

}  // namespace lumenshop
