#include <rays/ray_triangles.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include <embree3/rtcore.h>
#include <lumen/error.h>

namespace lumen {

namespace {

using Removed = std::function<bool(const glm::vec3&)>;

/// Refuses hits on what is removed.
void keep_rest(const RTCFilterFunctionNArguments* arguments) {
  const Removed& removed = *static_cast<const Removed*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const glm::vec3 origin(RTCRayN_org_x(arguments->ray, arguments->N, i), RTCRayN_org_y(arguments->ray, arguments->N, i), RTCRayN_org_z(arguments->ray, arguments->N, i));
    const glm::vec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, i), RTCRayN_dir_y(arguments->ray, arguments->N, i), RTCRayN_dir_z(arguments->ray, arguments->N, i));
    if (removed(origin + RTCRayN_tfar(arguments->ray, arguments->N, i) * direction)) arguments->valid[i] = 0;
  }
}

RTCRay ray(glm::vec3 origin, glm::vec3 direction, float from, float reach) {
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = from;
  ray.tfar = reach;
  ray.mask = ~0u;
  return ray;
}

}  // namespace

struct RayTriangles::Embree {
  // One thread: those of the host are the only ones.
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = nullptr;
  std::vector<std::unique_ptr<Removed>> removed;
  std::vector<RTCGeometry> added;  ///< filled, not yet built; the scene keeps them
  std::atomic<std::ptrdiff_t> bytes = 0;

  Embree() {
    if (device == nullptr) fail("starting");
    const auto count = [](void* bytes, ssize_t change, bool) {
      *static_cast<std::atomic<std::ptrdiff_t>*>(bytes) += change;
      return true;
    };
    rtcSetDeviceMemoryMonitorFunction(device, count, &bytes);
    scene = rtcNewScene(device);
  }
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  [[noreturn]] void fail(const char* what) const {
    const RTCError error = rtcGetDeviceError(device);
    throw Error(std::string("embree, ") + what, error == RTC_ERROR_OUT_OF_MEMORY ? "not enough memory" : "error " + std::to_string(int(error)));
  }
  void check(const char* what) const {
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail(what);
  }
};

RayTriangles::RayTriangles() : embree_(std::make_unique<Embree>()) {}
RayTriangles::~RayTriangles() = default;

RayTriangles::Room RayTriangles::add(std::size_t positions, std::size_t triangles, std::function<bool(const glm::vec3&)> removed) {
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), positions));
  auto* corners = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles));
  if (points == nullptr || corners == nullptr) {
    rtcReleaseGeometry(geometry);
    embree_->fail("holding a mesh");
  }
  if (removed) {
    embree_->removed.push_back(std::make_unique<Removed>(std::move(removed)));
    rtcSetGeometryUserData(geometry, embree_->removed.back().get());
    rtcSetGeometryOccludedFilterFunction(geometry, keep_rest);
    rtcSetGeometryIntersectFilterFunction(geometry, keep_rest);
  }
  rtcAttachGeometry(embree_->scene, geometry);
  rtcReleaseGeometry(geometry);
  embree_->added.push_back(geometry);
  return {{points, positions}, {corners, triangles}};
}

void RayTriangles::build() {
  for (RTCGeometry geometry : embree_->added) rtcCommitGeometry(geometry);
  embree_->added.clear();
  rtcCommitScene(embree_->scene);
  embree_->check("building the hierarchy");
}

std::size_t RayTriangles::bytes() const { return std::size_t(std::max<std::ptrdiff_t>(embree_->bytes, 0)); }

bool RayTriangles::occluded(glm::vec3 origin, glm::vec3 direction, float reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay asked = ray(origin, direction, 0, reach);
  rtcOccluded1(embree_->scene, &context, &asked);
  return asked.tfar < 0;  // Embree marks a hit by -inf
}

std::optional<RayTriangles::Hit> RayTriangles::first(glm::vec3 origin, glm::vec3 direction, float from, float reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit asked{.ray = ray(origin, direction, from, reach), .hit = {}};
  asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &asked);
  if (asked.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{asked.ray.tfar, asked.hit.primID, {asked.hit.Ng_x, asked.hit.Ng_y, asked.hit.Ng_z}};
}

}  // namespace lumen
