/// Two halves of a surface, cut by a plane and moved apart along its normal. Fragments are cut by clip distances, in untouched
/// space. Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/gtc/matrix_transform.hpp>
#include <lumen/splitter.h>

#include "../kept_parts.h"
#include "plane_cut.h"

namespace {

struct Plane : lumen::Splitter {
  using Splitter::Splitter;

  lumen::Property<glm::vec3> translation{this, "translation", glm::vec3(0), {.unit = "world", .doc = "a point of the plane; unless set, the middle of what it cuts"}};
  lumen::Property<glm::vec3> axis{this, "axis", glm::vec3(0, 1, 0), {.min = -1, .max = 1, .doc = "what the normal, +z, is turned about"}};
  lumen::Property<float> angle{this, "angle", 0.0f, {.min = -180, .max = 180, .unit = "degrees", .doc = "how far the normal is turned"}};
  lumen::Property<float> offset{this, "offset", 0.0f, {.min = 0, .unit = "world", .doc = "how far each half moves along the normal"}};
  lumen::Property<std::vector<int>> whole{this, "whole", {}, {.min = 0, .doc = "numbers of parts that stay whole and in place"}};
  lumen::Property<bool> open_when_hidden{this, "open_when_hidden", false, {.doc = "the halves open by themselves while they would hide most of what stays whole", .group = "Opening", .when = "whole"}};
  lumen::Property<float> hidden_share{this, "hidden_share", 0.5f, {.min = 0.01, .max = 1, .doc = "how much of it must be hidden for that", .group = "Opening", .when = "open_when_hidden"}};
  lumen::Property<float> opening{this, "opening", 1.0f, {.min = 0, .max = 1, .doc = "share of the offset that is taken; moves by itself unless set", .group = "Opening"}};
  lumen::Property<int> many_triangles{this, "many_triangles", 500000, {.min = 1, .unit = "triangles", .doc = "a resting cut of a mesh with at least so many is proposed to be made once, by filter.split", .group = "Proposal", .logarithmic = true, .advanced = true, .affects = lumen::Affects::nothing}};
  lumen::Interior interior{this};

  void surfaces_changed(const lumen::Bounds& bounds) override { translation.set_default(bounds.center()); }

  lumen::Split split(const lumen::SplitSurface& surface) override {
    const glm::vec3 normal = this->normal(), move = offset.get() * opening.get() * normal;
    const glm::vec4 plane(normal, -glm::dot(normal, translation.get()));
    lumen::Split split{.parts = {{.transform = glm::translate(glm::mat4(1), move), .planes = {plane}}, {.transform = glm::translate(glm::mat4(1), -move), .planes = {-plane}}}};
    if (surface.mesh == nullptr) return split;
    const PlaneCut& cut = cut_of(surface, plane);
    for (int half = 0; half < 2; ++half) {
      lumen::Part& part = split.parts[std::size_t(half)];
      if (cut.cap != nullptr) split.caps.push_back({.part = half, .plane = 0, .shape = cut.cap});
      if (cut.closed && !kept_.torn(cut.asked.groups)) part.openings = interior.caps() ? std::vector<glm::vec4>{} : cut.openings;
      if (cut.asked.groups != nullptr) part.group = 0;
    }
    if (cut.asked.groups != nullptr) split.parts.push_back(kept_.kept(cut.asked.groups));
    split.groups = cut.asked.groups;
    if (interior.caps() && !cut.closed) report(lumen::Severity::note, "'" + surface.mesh->origin + "' has a border at the plane: the cut stays open, its inside lit as its face");
    if (cut.frames >= frames_of_rest && surface.mesh->triangles.size() >= std::size_t(many_triangles.get())) propose(*surface.mesh);
    return split;
  }

  /// Opens while what stays whole would be hidden from the leading view, and closes after, some way with each frame.
  void prepare(lumen::Frame& frame) override {
    if (!frame.leads()) return;
    if (!open_when_hidden || whole->empty()) return opening.set_default(1);
    const float wanted = hides(frame) ? 1.0f : 0.0f, now = opening, next = now + std::clamp(wanted - now, -stride, stride);
    if (next == now) return;
    opening.set_default(next);
    frame.unfinished(1 - std::abs(wanted - next));
  }

 private:
  static constexpr float stride = 0.125f;
  static constexpr int frames_of_rest = 30;  ///< each was paid for: the plane is not being looked for any more

  /// Frames are counted, not seconds: a view at rest costs nothing either way.
  void propose(const lumen::Mesh& mesh) const {
    constexpr double microseconds_per_triangle = 1.1;  // of filter.split, on one core
    const std::size_t triangles = mesh.triangles.size();
    // Both halves, apart and in one, with the numbers of their cells.
    const std::size_t bytes = 2 * (mesh.bytes() + (mesh.triangle_cells.empty() ? triangles * sizeof(std::uint32_t) : 0));
    char costs[64];
    std::snprintf(costs, sizeof costs, "about %.1f s and %.0f MB", 1e-6 * microseconds_per_triangle * double(triangles), 1e-6 * double(bytes));
    report(lumen::Severity::note, "the cut of " + lumen::grouped(triangles) + " triangles rests, and every frame pays for it: filter.split would take " + costs +
                                      " once; Window, Split measures both and makes the change");
  }

  glm::vec3 normal() const {
    const glm::vec3 about = axis;
    return glm::length(about) > 0 ? glm::vec3(glm::rotate(glm::mat4(1), glm::radians(angle.get()), glm::normalize(about))[2]) : glm::vec3(0, 0, 1);
  }

  const PlaneCut& cut_of(const lumen::SplitSurface& surface, const glm::vec4& plane) {
    PlaneCut::Asked asked{.mesh = surface.mesh, .object_to_world = surface.object_to_world, .plane = plane, .groups = kept_.groups(surface.mesh, whole), .capped = interior.caps()};
    std::erase_if(cuts_, [](const PlaneCut& cut) { return cut.asked.mesh.expired(); });
    const auto found = std::find_if(cuts_.begin(), cuts_.end(), [&](const PlaneCut& cut) { return cut.asked.mesh.lock() == surface.mesh && cut.asked.object_to_world == surface.object_to_world; });
    if (found == cuts_.end()) return cuts_.emplace_back(std::move(asked));
    if (found->asked.same(asked)) ++found->frames;
    else *found = PlaneCut(std::move(asked));
    return *found;
  }

  /// Whether the closed halves would hide so much of what stays whole.
  bool hides(lumen::Frame& frame) const {
    const glm::ivec2 size = glm::max(frame.size() / 4, 1);
    const auto &kept = frame.scratch("kept", lumen::Format::R32F, size), &all = frame.scratch("all", lumen::Format::R32F, size);
    frame.draw_depth(frame.camera(), kept, {.closed = true, .wanted = [](const std::string&, const lumen::Part& part) { return !part.removable; }});
    frame.draw_depth(frame.camera(), all, {.closed = true});
    const std::vector<float> own = kept.download(), nearest = all.download();
    std::size_t seen = 0, hidden = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (!std::isfinite(own[i])) continue;
      (nearest[i] < own[i] - 1e-5f * frame.scene_radius() ? hidden : seen) += 1;
    }
    return hidden > 0 && float(hidden) >= hidden_share.get() * float(hidden + seen);
  }

  KeptParts kept_;
  std::vector<PlaneCut> cuts_;
};

}  // namespace

LUMEN_PLUGIN(Plane, "splitter.plane", "Two halves of a surface, cut by a plane and moved apart. Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.")
