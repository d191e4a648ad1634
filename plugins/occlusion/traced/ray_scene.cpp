#include "ray_scene.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <map>

#include <embree3/rtcore.h>
#include <glm/gtc/type_ptr.hpp>
#include <lumen/error.h>
#include <lumen/mesh.h>

namespace {

/// What the filter of a clipped part needs; outlives the scene that points to it.
struct Cut {
  glm::mat4 to_unmoved;            ///< world of the moved part to world before the move
  std::vector<glm::vec4> planes;
};

/// Refuses hits on what the part's planes removed.
void keep_inside(const RTCFilterFunctionNArguments* arguments) {
  const Cut& cut = *static_cast<const Cut*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const glm::vec3 origin(RTCRayN_org_x(arguments->ray, arguments->N, i), RTCRayN_org_y(arguments->ray, arguments->N, i), RTCRayN_org_z(arguments->ray, arguments->N, i));
    const glm::vec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, i), RTCRayN_dir_y(arguments->ray, arguments->N, i), RTCRayN_dir_z(arguments->ray, arguments->N, i));
    const glm::vec4 hit = cut.to_unmoved * glm::vec4(origin + RTCRayN_tfar(arguments->ray, arguments->N, i) * direction, 1);
    if (std::any_of(cut.planes.begin(), cut.planes.end(), [&](const glm::vec4& plane) { return glm::dot(plane, hit) < 0; })) arguments->valid[i] = 0;
  }
}

bool same(const lumen::TracedSurface& a, const lumen::TracedSurface& b) {
  return a.mesh == b.mesh && a.object_to_world == b.object_to_world && a.split == b.split;
}

}  // namespace

struct RayScene::Embree {
  // One thread: the host's are the only ones, and they are many only while a frame is traced.
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene world = nullptr;
  std::vector<std::unique_ptr<Cut>> cuts;
  std::atomic<std::ptrdiff_t> bytes = 0;

  Embree() {
    if (device == nullptr) fail("starting");
    const auto count = [](void* bytes, ssize_t change, bool) {
      *static_cast<std::atomic<std::ptrdiff_t>*>(bytes) += change;
      return true;
    };
    rtcSetDeviceMemoryMonitorFunction(device, count, &bytes);
    world = rtcNewScene(device);
  }
  ~Embree() {
    if (world != nullptr) rtcReleaseScene(world);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  [[noreturn]] void fail(const char* what) const {
    const RTCError error = rtcGetDeviceError(device);
    throw lumen::Error(std::string("embree, ") + what, error == RTC_ERROR_OUT_OF_MEMORY ? "not enough memory" : "error " + std::to_string(int(error)));
  }
  void check(const char* what) const {
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail(what);
  }

  /// Triangles moved by `to_world`, cut by planes where they were before the part's move; with `groups`, those of the part's.
  void add(const lumen::Mesh& mesh, const glm::mat4& to_world, const lumen::Part& part, const std::vector<glm::vec4>& planes, const std::vector<std::uint32_t>* groups) {
    const auto within = [&](std::size_t triangle) { return groups == nullptr || part.group < 0 || (*groups)[triangle] == std::uint32_t(part.group); };
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) count += within(i);
    if (count == 0) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
    auto* triangles = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), count));
    if (positions == nullptr || triangles == nullptr) {
      rtcReleaseGeometry(geometry);
      fail("holding a mesh");
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) positions[i] = glm::vec3(to_world * glm::vec4(mesh.positions[i], 1));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (within(i)) *triangles++ = mesh.triangles[i];
    if (!planes.empty()) {
      cuts.push_back(std::make_unique<Cut>(Cut{glm::inverse(part.transform), planes}));
      rtcSetGeometryUserData(geometry, cuts.back().get());
      rtcSetGeometryOccludedFilterFunction(geometry, keep_inside);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(world, geometry);
    rtcReleaseGeometry(geometry);
    check("holding a mesh");
  }
};

RayScene::RayScene(std::vector<lumen::TracedSurface> surfaces) : embree_(std::make_unique<Embree>()), surfaces_(std::move(surfaces)) {
  for (const lumen::TracedSurface& surface : surfaces_)
    add_split(surface);
  rtcCommitScene(embree_->world);
  embree_->check("building the hierarchy");
}

void RayScene::add_split(const lumen::TracedSurface& surface) {
  for (const lumen::Part& part : surface.split.parts)
    embree_->add(*surface.mesh, part.transform * surface.object_to_world, part, part.planes, surface.split.groups.get());
  for (const lumen::Cap& cap : surface.split.caps) {
    const lumen::Part& part = surface.split.parts[std::size_t(cap.part)];
    std::vector<glm::vec4> others = part.planes;
    others.erase(others.begin() + cap.plane);
    embree_->add(*cap.shape, part.transform, part, others, nullptr);
  }
}

RayScene::~RayScene() = default;

std::size_t RayScene::bytes() const { return std::size_t(std::max<std::ptrdiff_t>(embree_->bytes, 0)); }

bool RayScene::shows(std::span<const lumen::TracedSurface> surfaces) const {
  return std::equal(surfaces.begin(), surfaces.end(), surfaces_.begin(), surfaces_.end(), same);
}

bool RayScene::occluded(glm::vec3 origin, glm::vec3 direction, float reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tfar = reach;
  ray.mask = ~0u;
  rtcOccluded1(embree_->world, &context, &ray);
  return ray.tfar < 0;  // Embree marks a hit by -inf
}
