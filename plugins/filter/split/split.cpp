/// A surface cut in two by a plane, once and for all: what the image-space splitter draws in every frame becomes triangles, closed
/// and free to leave the program. The object-space way of Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <lumen/components.h>
#include <lumen/filter.h>
#include <lumen/mesh.h>

#include "pieces.h"

namespace {

/// The plane, and coordinates in it, of the world.
struct Plane {
  glm::dvec3 point, normal, right, up;

  Plane(glm::dvec3 point, glm::dvec3 normal) : point(point), normal(normal) {
    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0) : size.y <= size.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    right = glm::normalize(glm::cross(other, normal));
    up = glm::cross(normal, right);
  }
};

std::string counted(std::size_t number, const char* one, const char* many) { return lumen::grouped(number) + (number == 1 ? one : many); }

/// What a person should know of halves that are not closed, or of what had to be done for that; empty if all is well.
std::string remark(const lumen::Mesh& mesh, const Cut& cut, const Caps& caps) {
  std::string manifold;
  const auto add = [&](std::size_t number, const char* one, const char* many) {
    if (number > 0) manifold += (manifold.empty() ? "is no manifold (" : ", ") + counted(number, one, many);
  };
  add(cut.parted, " point doubled", " points doubled");
  add(cut.turned, " triangle turned", " triangles turned");
  add(cut.doubles, " doubled triangle left out", " doubled triangles left out");
  add(cut.unfit, " triangle set apart", " triangles set apart");
  if (!manifold.empty()) manifold += ")";
  std::string open;
  if (!cut.closed) open = "has a border at the plane: the cut stays open, without caps";
  else if (caps.left_open > 0) open = "crosses itself at the plane: " + counted(caps.left_open, " line of the cut stays", " lines of the cut stay") + " open, without a cap";
  else if (cut.border_edges > 0) open = "has a border of " + counted(cut.border_edges, " edge", " edges") + " away from the plane: its halves are closed at the cut alone";
  if (manifold.empty() && open.empty()) return {};
  return "'" + mesh.origin + "' " + manifold + (manifold.empty() || open.empty() ? "" : " and ") + open;
}

struct Split : lumen::Filter {
  using Filter::Filter;

  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface"}};
  lumen::Output<lumen::Mesh> result{this, "result", {.doc = "both halves and what stays whole; faces of the caps are cells after the mesh's, 1 in the cell array `cap`"}};
  lumen::Output<lumen::Mesh> half_a{this, "half_a", {.doc = "what lies where the normal points to"}};
  lumen::Output<lumen::Mesh> half_b{this, "half_b", {.doc = "the other half"}};

  lumen::Property<glm::mat4> transform{this, "transform", glm::mat4(1), {.doc = "object to world, as the renderer's: the plane and the offset are of the world"}};
  lumen::Property<glm::vec3> translation{this, "translation", glm::vec3(0), {.unit = "world", .doc = "a point of the plane; unless set, the middle of the surface"}};
  lumen::Property<glm::vec3> axis{this, "axis", glm::vec3(0, 1, 0), {.min = -1, .max = 1, .doc = "what the normal, +z, is turned about"}};
  lumen::Property<float> angle{this, "angle", 0.0f, {.min = -180, .max = 180, .unit = "degrees", .doc = "how far the normal is turned"}};
  lumen::Property<float> offset{this, "offset", 0.0f, {.min = 0, .unit = "world", .doc = "how far each half moves along the normal"}};
  lumen::Property<std::vector<int>> whole{this, "whole", {}, {.min = 0, .doc = "numbers of parts that stay whole and in place"}};
  lumen::Property<bool> capped{this, "capped", true, {.doc = "the halves are closed by their true faces"}};
  lumen::Property<bool> doubled{this, "doubled", false, {.doc = "caps have points of their own: normals are exact up to the cut, but halves are closed by place alone, not by number", .when = "capped"}};

  void changed(std::string_view property) override {
    if (property != mesh.id() && property != transform.id()) return;
    if (const auto surface = mesh.get(); surface != nullptr && !surface->bounds().empty()) translation.set_default(surface->bounds().transformed(transform).center());
  }

  void compute(lumen::Job& job) const override {
    const auto input = job[mesh];
    if (!input) throw lumen::Error("split.mesh", "there is no surface", "link a mesh to it");
    // Half-edges are numbered by int.
    constexpr std::size_t most = std::size_t(std::numeric_limits<int>::max()) / 16;
    if (input->triangles.size() > most || input->positions.size() > most) throw lumen::Error("split.mesh", input->summary() + " are too many to split");

    const glm::dmat4 object_to_world(job[transform]);
    const Plane plane(job[translation], normal_of(job));
    const glm::dvec4 local = glm::transpose(object_to_world) * glm::dvec4(plane.normal, -glm::dot(plane.normal, plane.point));
    const Cut halves = cut(*input, local, chosen(*input, job[whole]), [&](float part) { job.progress(0.8f * part); });
    job.progress(0.8f);
    const auto world = [&](std::uint32_t point) {
      const Origin origin = halves.origin(point, input->positions.size());
      return glm::dvec3(object_to_world * glm::dvec4(glm::mix(glm::dvec3(input->positions[origin.from]), glm::dvec3(input->positions[origin.to]), double(origin.share)), 1));
    };
    Caps caps;
    if (job[capped] && halves.closed && !halves.loops.empty()) {
      // Close to the origin, places are rounded least.
      const glm::dvec3 middle = world(halves.loops.front().points.front());
      const auto place = [&](std::uint32_t point) { return glm::vec2(glm::dot(world(point) - middle, plane.right), glm::dot(world(point) - middle, plane.up)); };
      caps = caps_of(halves, place);
    }
    job.progress(0.85f);
    if (job[capped])
      if (const std::string words = remark(*input, halves, caps); !words.empty()) job.report(lumen::Severity::note, words);

    const glm::vec3 move = moved_by(job, object_to_world, plane.normal);
    const Pieces pieces(*input, halves, caps, job[doubled]);
    job.set(half_a, pieces.joined({{Side::above, move}}, input->origin + ", half a"));
    job.progress(0.9f);
    job.set(half_b, pieces.joined({{Side::below, -move}}, input->origin + ", half b"));
    job.progress(0.95f);
    job.set(result, pieces.joined({{Side::above, move}, {Side::below, -move}, {Side::whole, glm::vec3(0)}}, input->origin + ", split"));
  }

 private:
  /// Of each triangle, whether its part is one of these; empty if none are given.
  static std::vector<bool> chosen(const lumen::Mesh& mesh, const std::vector<int>& parts) {
    std::vector<bool> chosen;
    if (parts.empty()) return chosen;
    chosen.reserve(mesh.triangles.size());
    for (const std::uint32_t part : lumen::parts_of(mesh).of_triangle) chosen.push_back(std::find(parts.begin(), parts.end(), int(part)) != parts.end());
    return chosen;
  }

  glm::dvec3 normal_of(const lumen::Job& job) const {
    const glm::vec3 about = job[axis];
    return glm::length(about) > 0 ? glm::normalize(glm::dvec3(glm::rotate(glm::mat4(1), glm::radians(job[angle]), glm::normalize(about))[2])) : glm::dvec3(0, 0, 1);
  }

  /// How far the half that the normal points to moves, in the mesh's space.
  glm::vec3 moved_by(const lumen::Job& job, const glm::dmat4& object_to_world, const glm::dvec3& normal) const {
    if (job[offset] == 0) return glm::vec3(0);
    const glm::vec3 move(glm::inverse(glm::dmat3(object_to_world)) * (double(job[offset]) * normal));
    if (!std::isfinite(move.x + move.y + move.z)) throw lumen::Error("split.transform", "it flattens the surface, so that its halves cannot be moved apart", "set another, or offset 0");
    return move;
  }
};

}  // namespace

LUMEN_PLUGIN(Split, "filter.split", "Two closed halves of a surface, cut by a plane in object space, on OpenMesh's half-edges. Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.")
