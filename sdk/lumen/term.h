/// Terms: one part of the lighting each, a GLSL function in shaders/<kind>/<name>.glsl.
///
///   vec3  ambient (Properties p, Surface s)            radiance without occlusion
///   vec3  diffuse (Properties p, Surface s, Light l)   radiance, material and light included
///   vec3  specular(Properties p, Surface s, Light l)   the same; the host leaves it out where N.L <= 0
///   float opacity (Properties p, Surface s)            0..1
/// lib/surface.glsl describes Surface and Light.
#pragma once

#include <lumen/plugin.h>

namespace lumen {

class Term : public Plugin {
 public:
  using Plugin::Plugin;
};
class Ambient : public Term {
 public:
  using Term::Term;
  Kind kind() const override { return Kind::ambient; }
};
class Diffuse : public Term {
 public:
  using Term::Term;
  Kind kind() const override { return Kind::diffuse; }
};
class Specular : public Term {
 public:
  using Term::Term;
  Kind kind() const override { return Kind::specular; }
};
class Opacity : public Term {
 public:
  using Term::Term;
  Kind kind() const override { return Kind::opacity; }
};

}  // namespace lumen
