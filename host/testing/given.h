/// importer.given: data that a test hands over, and the factory that adds the type to a session.
#pragma once

#include <lumen/importer.h>
#include <lumen/image.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/volume.h>

#include "model/plugin_factory.h"

namespace lumenshop {

class Given : public lumen::Importer {
 public:
  using Importer::Importer;
  static constexpr const char* type = "importer.given";

  /// Null clears it. Thread: main, no job of this instance running.
  void give(lumen::DataPointer data);
  void compute(lumen::Job& job) const override;

  lumen::Output<lumen::Mesh> mesh{this, "mesh"};
  lumen::Output<lumen::Lines> lines{this, "lines"};
  lumen::Output<lumen::Volume> volume{this, "volume"};
  lumen::Output<lumen::Image> image{this, "image"};

 private:
  lumen::Property<int> version_{this, "version", 0, {.doc = "how often data was given"}};
  lumen::DataPointer data_;
};

/// All types of `others`, and importer.given.
class GivenFactory final : public PluginFactory {
 public:
  explicit GivenFactory(PluginFactory& others) : others_(others) {}
  std::shared_ptr<lumen::Plugin> create(const std::string& type, lumen::Binding& binding) override;
  bool has(const std::string& type) const override;
  int generation(const std::string& type) const override;

 private:
  PluginFactory& others_;
};

}  // namespace lumenshop
