// Highlights of rough, mirroring facets. Cook, Torrance, A Reflectance Model for Computer Graphics, TOG 1982; facets of
// Trowbridge, Reitz 1975, masking of Smith 1967 (correlated: Heitz, Understanding the Masking-Shadowing Function in
// Microfacet-Based BRDFs, JCGT 2014), Fresnel term of Schlick 1994. Inputs: normal, eye, material, light. Output: radiance.
#include "lib/surface.glsl"

const float pi = 3.14159265359;

// Smith's masking, divided by x = N.X so that it stays finite at grazing angles: 2 / (x + root).
float root(float square, float x) { return sqrt(square + (1.0 - square) * x * x); }

vec3 specular(Properties p, Surface s, Light l) {
  float width = p.squared ? p.sigma * p.sigma : p.sigma;
  float square = width * width;
  vec3 halfway = normalize(l.direction + s.to_eye);
  float toward_light = max(dot(s.normal, l.direction), 0.0);
  float toward_eye = max(dot(s.normal, s.to_eye), 0.0);

  // (N.H)^2 (a^2 - 1) + 1, with the sine taken from the cross product: the difference of squares would drown narrow highlights in noise.
  float cosine = dot(s.normal, halfway);
  vec3 sine = cross(s.normal, halfway);
  float spread = dot(sine, sine) + square * cosine * cosine;
  float facets = square / (pi * spread * spread);

  float facing = (p.n1 - p.n2) / (p.n1 + p.n2);
  facing *= facing;
  float fresnel = facing + (1.0 - facing) * pow(clamp(1.0 - dot(halfway, s.to_eye), 0.0, 1.0), 5.0);

  float light_root = root(square, toward_light), eye_root = root(square, toward_eye);
  float separable = 4.0 / ((toward_light + light_root) * (toward_eye + eye_root));          // G / ((N.L) (N.V))
  float correlated = 2.0 / (toward_light * eye_root + toward_eye * light_root);             // the same
  float reflected = p.as_printed ? separable / pi : (p.masking == 0 ? separable : correlated) * toward_light / 4.0;
  return s.specular_color * l.radiance * (fresnel * facets * reflected);
}
