/// Filters: data becomes data.
#pragma once

#include <lumen/importer.h>

namespace lumen {

class Filter : public Source {
 public:
  using Source::Source;
  Kind kind() const override { return Kind::filter; }
};

}  // namespace lumen
