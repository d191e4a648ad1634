/// Exporters: data or a picture becomes a file.
#pragma once

#include <lumen/importer.h>

namespace lumen {

/// Declares one input per data kind that it writes, named after it (mesh, lines, volume, image).
class Exporter : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::exporter; }
  virtual std::vector<FileFormat> formats() const = 0;
  /// Writes the input to `path`, completely or not at all. Thread: a worker's; touches nothing but the job. Throws Error.
  virtual void write(Job& job) const = 0;

  Property<Path> path{this, "path", {}, {.doc = "the file to write", .accepts = "save"}};
};

}  // namespace lumen
