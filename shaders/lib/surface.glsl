// What terms see: a surface and a light.

struct Surface {
  vec3 position;       // view space, world units
  vec3 normal;         // view space, unit; the host turns it toward the eye
  vec3 to_eye;         // unit; set by the host
  vec3 ambient_color;  // material; set by the host before surface() is read, so a renderer may replace them
  vec3 diffuse_color;
  vec3 specular_color;
  float shininess;
  int instance;        // 1.. in session order; set by the host
  int style;           // row of what it is made of; set by the host
  int part;            // of the splitters; set by the host
  int primitive;       // of the data, from 0
  bool front;          // seen from outside; set by the host
  vec3 place;          // world, where it was before splitters moved it; set for splitters alone
  mat3 curvature;      // view space, 1 / world units: along a unit tangent w the outside bends by w^T C w, positive where it bends away
                       // from the outward normal, whichever side is seen. Zero: the mesh has none (filter.curvature gives it one), or
                       // the surface is opaque, whose light knows no more than the layers
};

struct Light {
  int index;           // 0 front, 1 back, ...
  vec3 direction;      // from the surface toward the light, view space, unit
  vec3 radiance;       // color * intensity / falloff
};

struct Lighting {
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
};

// A lit fragment of a transparent surface.
struct Fragment {
  vec3 color;          // radiance, not multiplied by alpha
  float alpha;
  float depth;         // eye space
  int instance, part, primitive;
};
