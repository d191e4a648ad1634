/// A picture.
#pragma once

#include <lumen/data.h>

namespace lumen {

/// Linear float pixels, first row at the top.
struct Image : Data {
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< "R" "G" "B" "A", or "diffuse.R", "depth.Z" ...
  Array<float> pixels;                ///< width * height * channels.size(), interleaved

  DataKind kind() const override { return DataKind::image; }
  std::size_t bytes() const override;
  Bounds bounds() const override;     ///< [0, width] x [0, height] x 0
  std::string summary() const override;

  /// Checks sizes. Throws Error naming `origin`.
  void finish();
};

}  // namespace lumen
