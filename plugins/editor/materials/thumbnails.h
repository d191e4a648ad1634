/// Small pictures of materials: each as a sphere, whatever its mapping.
#pragma once

#include <map>
#include <string>

#include <lumen/editor.h>
#include <lumen/gl/texture.h>
#include <lumen/image.h>

#include "material.h"

class Thumbnails {
 public:
  struct Entry {
    lumen::gl::Texture texture;  ///< none until the picture is there
    std::string failure;         ///< why there is none, or empty
  };
  /// The GL context must be current. A few are made at a time.
  const Entry& of(lumen::Workbench& workbench, const Material& material);
  void begin_frame() { asked_ = 0; }

 private:
  std::map<std::string, Entry> entries_;
  int asked_ = 0;
};
