// Ambient light, the same from everywhere. Inputs: material. Output: radiance without occlusion.
#include "lib/surface.glsl"

vec3 ambient(Properties p, Surface s) { return s.ambient_color * p.intensity; }
