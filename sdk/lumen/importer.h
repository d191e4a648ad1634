/// Importers and filters: they make data. Exporters: they write it.
#pragma once

#include <lumen/job.h>
#include <lumen/plugin.h>

namespace lumen {

/// A file format by its extension.
struct FileFormat {
  std::string extension;   ///< ".vtp", lower case
  DataKind data = DataKind::mesh;
  std::string name;        ///< "VTK XML polygons"
};

/// What computes: compute() runs as a job whenever a property with Affects::draw or an input has changed.
class Source : public Plugin {
 public:
  using Plugin::Plugin;
  /// Makes the outputs. Thread: a worker's; touches nothing but the job. Throws Error.
  virtual void compute(Job& job) const = 0;
};

/// A file or a generator becomes data. Ids of files' importers: `path`, and an output per data kind: mesh, lines, volume, image.
class Importer : public Source {
 public:
  using Source::Source;
  Kind kind() const override { return Kind::importer; }
  /// What it can open; empty for generators. A file is offered to the first importer that names its extension.
  virtual std::vector<FileFormat> formats() const { return {}; }
};

}  // namespace lumen
