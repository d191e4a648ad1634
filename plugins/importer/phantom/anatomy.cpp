/// The numbers are those of a textbook's adult; the course bends in all three planes as a real one does.
#include "anatomy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// From the root over the arch down to the bifurcation: position and radius.
constexpr std::array<std::array<float, 4>, 14> course = {{
    {2, 30, 22, 15.5f}, {-8, 55, 28, 16.5f}, {-14, 85, 27, 16}, {-8, 112, 18, 15}, {8, 126, 2, 14}, {24, 120, -16, 13.3f}, {31, 98, -28, 13},
    {30, 60, -33, 12.5f}, {24, 20, -32, 12}, {17, -20, -26, 11.3f}, {10, -60, -17, 10.5f}, {4, -100, -9, 9.6f}, {1, -135, -5, 9}, {0, -160, -6, 8.6f}}};
constexpr float arch_top = 4;  ///< index of its control point

/// A vessel that leaves the aorta near a control point, first one way, then another. Lengths and radii in millimeters.
struct BranchCourse {
  float control;
  glm::vec3 exit, then;
  float length, radius;
};
const std::array<BranchCourse, 10> branch_courses = {{
    {3.4f, {-0.25f, 1, 0.1f}, {-0.55f, 1, 0.1f}, 48, 6.2f},     // brachiocephalic
    {4.0f, {0.0f, 1, 0.0f}, {-0.1f, 1, 0.15f}, 58, 3.8f},       // left common carotid
    {4.6f, {0.25f, 1, -0.1f}, {0.9f, 0.75f, 0.0f}, 55, 4.6f},   // left subclavian
    {9.6f, {0.1f, 0.1f, 1}, {-0.3f, -0.2f, 1}, 26, 3.8f},       // celiac
    {10.0f, {0.0f, 0.0f, 1}, {0.05f, -1, 0.35f}, 62, 3.9f},     // superior mesenteric
    {10.5f, {-1, -0.1f, -0.1f}, {-1, -0.35f, -0.35f}, 42, 3.1f},// right renal
    {10.6f, {1, -0.1f, -0.1f}, {1, -0.3f, -0.4f}, 40, 3.1f},    // left renal
    {11.9f, {0.2f, -0.2f, 1}, {0.35f, -1, 0.4f}, 38, 2.0f},     // inferior mesenteric
    {13.0f, {-0.6f, -1, 0}, {-0.5f, -1, 0.15f}, 62, 6.0f},      // right iliac
    {13.0f, {0.6f, -1, 0}, {0.5f, -1, 0.15f}, 62, 6.0f},        // left iliac
}};

std::vector<glm::vec4> bent(float bend) {
  std::vector<glm::vec4> controls;
  float length = 0;
  std::array<float, course.size()> distance{};
  const auto point = [](std::size_t index) { return glm::vec3(course[index][0], course[index][1], course[index][2]); };
  for (std::size_t index = 1; index < course.size(); ++index) distance[index] = length += glm::distance(point(index), point(index - 1));
  for (std::size_t index = 0; index < course.size(); ++index) {
    const glm::vec3 straight(0, length / 2 - distance[index], 0);
    controls.emplace_back(glm::mix(straight, point(index), bend), course[index][3]);
  }
  return controls;
}

float smooth_step(float a, float b, float x) {
  const float t = std::clamp((x - a) / (b - a), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// Low harmonics around, slow waves along.
class Irregularity {
 public:
  Irregularity(int seed, float amplitude) {
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    // Distributions differ between standard libraries; the engine does not.
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    for (Wave& wave : waves_) {
      wave.amplitude = amplitude * (0.3f + 0.7f * uniform());
      wave.frequency = 2 * pi / (25 + 70 * uniform());
      wave.phase = 2 * pi * uniform();
      wave.turn = 0.04f * (uniform() - 0.5f);
    }
  }
  /// Radii times 1 + the waves.
  void apply(float distance, std::span<const glm::vec2> directions, std::span<float> radii) const {
    std::array<glm::vec2, 3> factor;
    float along = 1;
    for (std::size_t harmonic = 0; harmonic < waves_.size(); ++harmonic) {
      const Wave& wave = waves_[harmonic];
      const float height = wave.amplitude * std::sin(wave.frequency * distance + wave.phase);
      if (harmonic == 0) along += height;
      else factor[harmonic - 1] = height * glm::vec2(std::cos(wave.turn * distance + wave.phase), std::sin(wave.turn * distance + wave.phase));
    }
    for (std::size_t index = 0; index < radii.size(); ++index) {
      const glm::vec2 one = directions[index], two(one.x * one.x - one.y * one.y, 2 * one.x * one.y);
      const glm::vec2 three(two.x * one.x - two.y * one.y, two.x * one.y + two.y * one.x);
      radii[index] *= along + glm::dot(factor[0], one) + glm::dot(factor[1], two) + glm::dot(factor[2], three);
    }
  }

 private:
  struct Wave { float amplitude, frequency, phase, turn; };
  std::array<Wave, 4> waves_;
};

class AortaWall : public CrossSection {
 public:
  AortaWall(const Dissection& dissection, const AnatomyOptions& options) : dissection_(dissection), irregularity_(options.seed, options.irregularity) {}
  float mean_radius(const CurveFrame& frame, float) const override { return frame.radius; }
  glm::vec2 evaluate(const CurveFrame& frame, float distance, std::span<const glm::vec2> directions, std::span<float> radii) const override {
    const float bulge = 0.28f * dissection_.opening(distance);
    const glm::vec2 toward = dissection_.direction(distance);
    for (std::size_t index = 0; index < radii.size(); ++index) {
      const float side = 0.5f + 0.5f * glm::dot(directions[index], toward);
      radii[index] = frame.radius * (1 + bulge * side * side);
    }
    irregularity_.apply(distance, directions, radii);
    return glm::vec2(0);
  }

 private:
  const Dissection& dissection_;
  Irregularity irregularity_;
};

/// The inside of the wall, cut by the membrane: a circle where the vessel is healthy, a rounded D where it is split.
class TrueLumen : public CrossSection {
 public:
  explicit TrueLumen(const Dissection& dissection) : dissection_(dissection) {}
  float mean_radius(const CurveFrame& frame, float distance) const override {
    return dissection_.inner_radius(frame) * (1 - 0.4f * dissection_.opening(distance));
  }
  glm::vec2 evaluate(const CurveFrame& frame, float distance, std::span<const glm::vec2> directions, std::span<float> radii) const override {
    const float circle = 0.97f * dissection_.inner_radius(frame), opening = dissection_.opening(distance);
    const glm::vec2 toward = dissection_.direction(distance);
    // Seen from a center within it the section stays star-shaped, however far the membrane goes.
    const float membrane = dissection_.membrane(distance) * circle - 0.05f * frame.radius * opening;
    const float shift = opening * (0.5f * (circle - membrane));
    const float height = membrane + shift;
    for (std::size_t index = 0; index < radii.size(); ++index) {
      const float cosine = glm::dot(directions[index], toward);
      const float to_circle = shift * cosine + std::sqrt(std::max(0.0f, circle * circle - shift * shift * (1 - cosine * cosine)));
      // 1 / r^6 = 1 / circle^6 + 1 / line^6: the smaller of the two, with a rounded corner.
      const float to_line = opening > 0 ? to_circle * std::max(cosine, 0.0f) / height : 0;
      const float square = to_line * to_line;
      radii[index] = to_circle / std::cbrt(std::sqrt(1 + opening * square * square * square));
    }
    return -shift * toward;
  }

 private:
  const Dissection& dissection_;
};

/// Round, wider where it leaves the aorta.
class BranchWall : public CrossSection {
 public:
  BranchWall(float ostium, int seed, float irregularity) : ostium_(ostium), irregularity_(seed, irregularity) {}
  float mean_radius(const CurveFrame& frame, float distance) const override {
    const float away = (distance - ostium_) / frame.radius;
    return frame.radius * (1 + 0.45f * std::exp(-away * away / 1.5f));
  }
  glm::vec2 evaluate(const CurveFrame& frame, float distance, std::span<const glm::vec2> directions, std::span<float> radii) const override {
    std::fill(radii.begin(), radii.end(), mean_radius(frame, distance));
    irregularity_.apply(distance, directions, radii);
    return glm::vec2(0);
  }

 private:
  float ostium_;
  Irregularity irregularity_;
};

}  // namespace

Dissection::Dissection(const Centerline& line, const AnatomyOptions& options)
    : begin_(line.distance_at(arch_top + 1.1f)), end_(line.distance_at(12.2f)), twist_(options.twist), closed_share_(1 - options.false_lumen) {
  phase_ = 0.4f + 0.7f * static_cast<float>(options.seed % 9);
}

float Dissection::opening(float distance) const {
  const float length = end_ - begin_;
  return smooth_step(begin_, begin_ + 0.16f * length, distance) * (1 - smooth_step(end_ - 0.2f * length, end_, distance));
}

glm::vec2 Dissection::direction(float distance) const {
  const float angle = phase_ + 2 * pi * twist_ * (distance - begin_) / (end_ - begin_);
  return {std::cos(angle), std::sin(angle)};
}

float Dissection::membrane(float distance) const {
  // Half the section is closed by a membrane through the axis.
  const float split = 2 * closed_share_ - 1;
  return 1 + (split - 1) * opening(distance);
}

Anatomy::Anatomy(const AnatomyOptions& options) {
  aorta_ = std::make_unique<Centerline>(bent(options.bend));
  dissection_ = std::make_unique<Dissection>(*aorta_, options);
  sections_.push_back(std::make_unique<AortaWall>(*dissection_, options));
  wall_.push_back({aorta_.get(), sections_.back().get(), 0, aorta_->length(), 0.12f, options.branches ? 0.9f : 0.12f, 122, 104});
  sections_.push_back(std::make_unique<TrueLumen>(*dissection_));
  const float inset = 3;
  lumen_ = {aorta_.get(), sections_.back().get(), inset, aorta_->length() - inset, 0.15f, options.branches ? 0.9f : 0.15f, 120, 96};
  if (!options.branches) return;

  int seed = options.seed * 31;
  for (const BranchCourse& branch : branch_courses) {
    const float distance = aorta_->distance_at(branch.control);
    const CurveFrame frame = aorta_->at(distance);
    const bool at_the_end = branch.control >= static_cast<float>(course.size() - 1);
    glm::vec3 exit = glm::normalize(branch.exit);
    // It leaves across the aorta, not along it, whatever way that runs after bending.
    if (!at_the_end) {
      exit -= 0.85f * glm::dot(exit, frame.forward) * frame.forward;
      exit = glm::length(exit) > 0.1f ? glm::normalize(exit) : frame.right;
    } else {
      exit = glm::normalize(frame.forward + 0.55f * (branch.exit.x < 0 ? -1.0f : 1.0f) * glm::normalize(glm::vec3(1, 0, 0) - frame.forward.x * frame.forward));
    }
    const glm::vec3 then = glm::normalize(branch.then);
    const glm::vec3 start = at_the_end ? -0.8f * frame.radius * frame.forward : 0.45f * frame.radius * exit;
    const float surface = at_the_end ? 0.4f * frame.radius : frame.radius;
    std::vector<glm::vec4> controls;
    controls.emplace_back(frame.position + start, 0.9f * branch.radius);
    controls.emplace_back(frame.position + surface * exit, branch.radius);
    glm::vec3 position = frame.position + (surface + 0.3f * branch.length) * exit;
    controls.emplace_back(position, 0.96f * branch.radius);
    for (int step = 1; step <= 3; ++step) {
      position += 0.24f * branch.length * glm::normalize(glm::mix(exit, then, static_cast<float>(step) / 3));
      controls.emplace_back(position, (0.96f - 0.06f * static_cast<float>(step)) * branch.radius);
    }
    branch_lines_.push_back(std::make_unique<Centerline>(controls));
    const Centerline& line = *branch_lines_.back();
    sections_.push_back(std::make_unique<BranchWall>(line.distance_at(1), ++seed, 0.6f * options.irregularity));
    const float pressure = 122 - 18 * distance / aorta_->length();
    wall_.push_back({&line, sections_.back().get(), 0, line.length(), 0.1f, 0.2f, pressure, pressure - 9});
  }
}

Anatomy::~Anatomy() = default;
