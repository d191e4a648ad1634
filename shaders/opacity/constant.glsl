// The same opacity everywhere.
#include "lib/surface.glsl"

float opacity(Properties p, Surface s) { return p.alpha; }
