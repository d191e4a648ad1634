/// Which plugin reads or writes a file, by its extension.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <lumen/importer.h>

#include "model/session.h"

namespace lumenshop {

class Registry;

/// Asks one new instance of each importer and exporter for its formats; instances live as long as the catalog. Make one
/// when it is needed: it is quick, and a reload may have changed what there is. Thread: main.
class FormatCatalog {
 public:
  explicit FormatCatalog(Registry& registry);

  /// The type of the first importer that names the longest fitting extension. Throws lumen::Error listing what can be read.
  std::string importer_of(const std::filesystem::path& file) const;
  /// An exporter for data of this kind, in no session. Throws lumen::Error listing what can be written.
  Instance& exporter_of(const std::filesystem::path& file, lumen::DataKind kind) const;
  /// Sorted extensions that some importer reads.
  std::vector<std::string> readable() const;

 private:
  struct Entry {
    Instance* instance;
    lumen::FileFormat format;
  };
  Session scratch_;
  std::vector<Entry> importers_, exporters_;
};

}  // namespace lumenshop
