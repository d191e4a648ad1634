/// Rusinkiewicz, Estimating Curvatures and Their Derivatives on Triangle Meshes, 3DPVT 2004: the tensor of a triangle is what
/// turns its edges into the differences of its normals; a point has the mean of its triangles'. Weights of the triangles: the
/// areas of Meyer, Desbrun, Schroeder, Barr, Discrete Differential-Geometry Operators for Triangulated 2-Manifolds, 2003.
#include "curvature_tensors.h"

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace {

constexpr std::size_t progress_step = 1 << 14;

/// Below this ratio of height to length, rounding decides what a triangle says about the curvature across it.
constexpr double flattest = 1e-5;

/// The smallest rotation that takes one unit vector to another, which is not its opposite.
glm::dmat3 turn(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 axis = glm::cross(from, to);
  const double cosine = glm::dot(from, to);
  const glm::dmat3 across(0, axis.z, -axis.y, -axis.z, 0, axis.x, axis.y, -axis.x, 0);
  return glm::dmat3(cosine) + across + glm::outerProduct(axis, axis) / (1 + cosine);
}

glm::dmat3 turned(const glm::dmat3& tensor, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dmat3 rotation = turn(from, to);
  return rotation * tensor * glm::transpose(rotation);
}

/// One triangle with the normals of its points.
struct Face {
  glm::dvec3 points[3], normals[3];
  glm::dvec3 normal{0};   ///< unit, on the side of the points' normals
  double area = 0;

  Face(const WeldedSurface& surface, const glm::uvec3& triangle) {
    for (int corner = 0; corner < 3; ++corner) {
      points[corner] = surface.positions[triangle[corner]];
      normals[corner] = surface.normals[triangle[corner]];
    }
    const glm::dvec3 doubled = glm::cross(points[1] - points[0], points[2] - points[0]);
    const double length = glm::length(doubled);
    area = 0.5 * length;
    if (length > 0) normal = doubled / length;
    if (glm::dot(normal, normals[0] + normals[1] + normals[2]) < 0) normal = -normal;
  }

  /// Opposite of a corner.
  glm::dvec3 edge(int corner) const { return points[(corner + 2) % 3] - points[(corner + 1) % 3]; }

  /// Nothing where the triangle has no shape, or normals that face elsewhere.
  std::optional<glm::dmat3> tensor() const {
    for (const glm::dvec3& other : normals)
      if (!(glm::dot(normal, other) > 0)) return std::nullopt;
    const glm::dvec3 u = glm::normalize(edge(0)), v = glm::cross(normal, u);
    double xx = 0, xy = 0, yy = 0;
    glm::dvec3 turns(0);
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 way = edge(corner), difference = normals[(corner + 2) % 3] - normals[(corner + 1) % 3];
      const double x = glm::dot(way, u), y = glm::dot(way, v), a = glm::dot(difference, u), b = glm::dot(difference, v);
      xx += x * x;
      xy += x * y;
      yy += y * y;
      turns += glm::dvec3(x * a, y * a + x * b, y * b);
    }
    if (!(xx * yy - xy * xy > flattest * flattest * (xx + yy) * (xx + yy))) return std::nullopt;
    // Least squares: [e f; f g] times each edge is the difference of the normals along it.
    const glm::dvec3 efg = glm::inverse(glm::dmat3(xx, xy, 0, xy, xx + yy, xy, 0, xy, yy)) * turns;
    return efg.x * glm::outerProduct(u, u) + efg.y * (glm::outerProduct(u, v) + glm::outerProduct(v, u)) + efg.z * glm::outerProduct(v, v);
  }

  /// The part of the area that is nearest to the corner, or a fixed one where a corner is obtuse.
  double area_of(int corner) const {
    const glm::dvec3 edges[] = {edge(0), edge(1), edge(2)};
    double squares[3], dots[3];
    for (int i = 0; i < 3; ++i) {
      squares[i] = glm::dot(edges[i], edges[i]);
      dots[i] = -glm::dot(edges[(i + 1) % 3], edges[(i + 2) % 3]);  // positive if the angle at corner i is acute
    }
    for (int i = 0; i < 3; ++i)
      if (dots[i] <= 0) return i == corner ? area / 2 : area / 4;
    const int next = (corner + 1) % 3, last = (corner + 2) % 3;
    return (squares[next] * dots[next] + squares[last] * dots[last]) / (16 * area);
  }
};

/// Tensors with the weights that they are sums of.
struct Sums {
  std::vector<glm::mat3> tensors;
  std::vector<float> weights;

  explicit Sums(std::size_t count) : tensors(count, glm::mat3(0)), weights(count, 0) {}
  void add(std::size_t point, const glm::dmat3& tensor, double weight) {
    tensors[point] += glm::mat3(weight * tensor);
    weights[point] += float(weight);
  }
  void divide() {
    for (std::size_t point = 0; point < tensors.size(); ++point)
      if (weights[point] > 0) tensors[point] /= weights[point];
  }
};

Sums tensors_of(const WeldedSurface& surface, const std::function<void(float)>& progress) {
  Sums sums(surface.positions.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (i % progress_step == 0) progress(float(i) / float(surface.triangles.size()));
    const glm::uvec3& triangle = surface.triangles[i];
    const Face face(surface, triangle);
    const auto tensor = face.tensor();
    if (!tensor) continue;
    for (int corner = 0; corner < 3; ++corner) sums.add(triangle[corner], turned(*tensor, face.normal, face.normals[corner]), face.area_of(corner));
  }
  sums.divide();
  return sums;
}

/// Half itself, half its neighbors' by the areas of the triangles that it shares with them.
Sums smoothed(const WeldedSurface& surface, const Sums& before, const std::function<void(float)>& progress) {
  Sums sums(before.tensors.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (i % progress_step == 0) progress(float(i) / float(surface.triangles.size()));
    const glm::uvec3& triangle = surface.triangles[i];
    const Face face(surface, triangle);
    if (!(face.area > 0)) continue;
    for (int corner = 0; corner < 3; ++corner)
      for (const int other : {(corner + 1) % 3, (corner + 2) % 3}) {
        if (before.weights[triangle[other]] == 0 || !(glm::dot(face.normals[corner], face.normals[other]) > 0)) continue;
        sums.add(triangle[corner], turned(glm::dmat3(before.tensors[triangle[other]]), face.normals[other], face.normals[corner]), face.area);
      }
  }
  sums.divide();
  for (std::size_t point = 0; point < before.tensors.size(); ++point) {
    if (before.weights[point] == 0) continue;
    sums.tensors[point] = sums.weights[point] > 0 ? 0.5f * (before.tensors[point] + sums.tensors[point]) : before.tensors[point];
    sums.weights[point] = before.weights[point];
  }
  return sums;
}

}  // namespace

CurvatureTensors curvature_of(const WeldedSurface& surface, int smoothing, const std::function<void(float)>& progress) {
  const auto step = [&](int number) { return [&, number](float part) { progress((float(number) + part) / float(smoothing + 1)); }; };
  Sums sums = tensors_of(surface, step(0));
  for (int pass = 1; pass <= smoothing; ++pass) sums = smoothed(surface, sums, step(pass));
  CurvatureTensors result{.tensors = std::move(sums.tensors)};
  for (glm::mat3& tensor : result.tensors) tensor /= float(surface.unit);
  std::vector<bool> used(result.tensors.size());
  for (const glm::uvec3& t : surface.triangles) used[t.x] = used[t.y] = used[t.z] = true;
  for (std::size_t point = 0; point < used.size(); ++point) result.unknown += used[point] && sums.weights[point] == 0;
  return result;
}
