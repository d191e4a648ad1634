/// Outlines filled by GLU's tessellator.
#include <lumen/section.h>

#include <array>
#include <memory>

#include <GL/glu.h>
#include <lumen/error.h>

namespace lumen {
namespace {

/// What the tessellator's callbacks write. It stops by itself after an error.
struct Tessellation {
  Filling filling;
  std::vector<std::uint32_t> corners;
  GLenum error = 0;

  void* add(const glm::vec3& position) {
    filling.positions.push_back(position);
    return reinterpret_cast<void*>(std::uintptr_t(filling.positions.size() - 1));
  }
};

void on_vertex(void* number, void* tessellation) {
  static_cast<Tessellation*>(tessellation)->corners.push_back(std::uint32_t(reinterpret_cast<std::uintptr_t>(number)));
}
void on_crossing(GLdouble place[3], void*[4], GLfloat[4], void** number, void* tessellation) {
  *number = static_cast<Tessellation*>(tessellation)->add(glm::vec3(place[0], place[1], place[2]));
}
void on_error(GLenum error, void* tessellation) { static_cast<Tessellation*>(tessellation)->error = error; }
/// Its presence makes the tessellator give single triangles.
void on_edge(GLboolean, void*) {}

}  // namespace

Filling fill(const Outlines& outlines, glm::vec3 normal) {
  const std::unique_ptr<GLUtesselator, decltype(&gluDeleteTess)> tessellator(gluNewTess(), &gluDeleteTess);
  if (tessellator == nullptr) throw Error("filling outlines", "not enough memory");
  GLUtesselator* const glu = tessellator.get();
  const auto callback = [&](GLenum which, auto function) { gluTessCallback(glu, which, reinterpret_cast<_GLUfuncptr>(function)); };
  callback(GLU_TESS_VERTEX_DATA, on_vertex);
  callback(GLU_TESS_COMBINE_DATA, on_crossing);
  callback(GLU_TESS_ERROR_DATA, on_error);
  callback(GLU_TESS_EDGE_FLAG_DATA, on_edge);
  gluTessProperty(glu, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
  gluTessNormal(glu, double(normal.x), double(normal.y), double(normal.z));

  Tessellation result;
  gluTessBeginPolygon(glu, &result);
  for (const auto& outline : outlines) {
    gluTessBeginContour(glu);
    for (const glm::vec3& point : outline) {
      std::array<GLdouble, 3> place{double(point.x), double(point.y), double(point.z)};
      gluTessVertex(glu, place.data(), result.add(point));
    }
    gluTessEndContour(glu);
  }
  gluTessEndPolygon(glu);
  if (result.error != 0) throw Error("filling outlines", std::string("the tessellator failed: ") + reinterpret_cast<const char*>(gluErrorString(result.error)));
  for (std::size_t i = 0; i + 2 < result.corners.size(); i += 3)
    result.filling.triangles.emplace_back(result.corners[i], result.corners[i + 1], result.corners[i + 2]);
  return std::move(result.filling);
}

}  // namespace lumen
