#include "graph.h"

#include <algorithm>
#include <cmath>

namespace {

/// Where a box ends along a way, and where it begins.
float front(const lumen::Bounds& box, Way way) { return way.sign() > 0 ? box.max[way.axis()] : -box.min[way.axis()]; }
float back(const lumen::Bounds& box, Way way) { return way.sign() > 0 ? box.min[way.axis()] : -box.max[way.axis()]; }

/// Deeper than `tolerance`; a negative one is a distance.
bool overlap(const lumen::Bounds& a, const lumen::Bounds& b, float tolerance) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::min(a.max[axis] - b.min[axis], b.max[axis] - a.min[axis]) <= tolerance) return false;
  return true;
}

/// By the first of the numbers that differs by more than the tolerance.
bool less(const std::array<float, 3>& a, const std::array<float, 3>& b, float tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > tolerance) return a[i] < b[i];
  return false;
}

lumen::Bounds swept(lumen::Bounds box, Way way, float distance) {
  const lumen::Bounds rest = box;
  box.min += distance * way.vector();
  box.max += distance * way.vector();
  box.include(rest);
  return box;
}

}  // namespace

ExplosionGraph::ExplosionGraph(const Blocking& blocking, Asked asked)
    : asked_(std::move(asked)), axes_(blocking.axes()), tolerance_(blocking.tolerance()), parts_(blocking.count()) {
  find_bodies(blocking);
  find_order();
  find_distances();
  find_levels();
}

Ways ExplosionGraph::blocked(const Blocking& blocking, const Body& body, const Body& other) const {
  Ways ways;
  for (const int a : body.parts)
    for (const int b : other.parts) ways |= blocking.ways(a, b);
  return ways;
}

bool ExplosionGraph::intersect(const Blocking& blocking, const Body& body, const Body& other) const {
  return std::any_of(body.parts.begin(), body.parts.end(), [&](int a) {
    return std::any_of(other.parts.begin(), other.parts.end(), [&](int b) { return blocking.intersect(a, b); });
  });
}

/// What is blocked on all ways by the same body never comes free of it: they are one.
bool ExplosionGraph::join_interlocked(const Blocking& blocking) {
  for (std::size_t a = 0; a < bodies_.size(); ++a)
    for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
      if (!blocked(blocking, bodies_[a], bodies_[b]).all()) continue;
      Body& body = bodies_[a];
      body.parts.insert(body.parts.end(), bodies_[b].parts.begin(), bodies_[b].parts.end());
      body.bounds.include(bodies_[b].bounds);
      body.fixed = body.fixed || bodies_[b].fixed;
      bodies_.erase(bodies_.begin() + std::ptrdiff_t(b));
      return true;
    }
  return false;
}

void ExplosionGraph::find_bodies(const Blocking& blocking) {
  for (int part = 0; part < parts_; ++part) {
    const bool fixed = std::find(asked_.fixed.begin(), asked_.fixed.end(), part) != asked_.fixed.end();
    bodies_.push_back({.parts = {part}, .bounds = blocking.bounds(part), .fixed = fixed});
  }
  while (join_interlocked(blocking)) ++enclosed_;
  const std::size_t count = bodies_.size();
  ways_.resize(count * count);
  near_.resize(count * count);
  meet_.resize(count * count);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < count; ++b) {
      if (a == b) continue;
      ways_[a * count + b] = blocked(blocking, bodies_[a], bodies_[b]);
      meet_[a * count + b] = intersect(blocking, bodies_[a], bodies_[b]);
      near_[a * count + b] = overlap(bodies_[a].bounds, bodies_[b].bounds, -100 * tolerance_);
    }
}

/// How far the body must go to leave the boxes of those that it is in contact with.
float ExplosionGraph::escape(int body, Way way, const std::vector<bool>& active) const {
  float distance = 0;
  for (std::size_t other = 0; other < bodies_.size(); ++other)
    if (active[other] && near(body, int(other))) distance = std::max(distance, front(bodies_[other].bounds, way) - back(bodies_[std::size_t(body)].bounds, way));
  return distance;
}

/// Again and again, of all bodies that are free along some way, the one that has the shortest way out leaves (section 3.1 of the paper); of
/// several, the smallest, and of these the one that is farthest out. Of two in contact each has as far to go as the other.
void ExplosionGraph::find_order() {
  const std::size_t count = bodies_.size();
  lumen::Bounds all;
  for (const Body& body : bodies_) all.include(body.bounds);
  std::vector<bool> active(count, true);
  std::vector<std::array<int, Way::count>> blockers(count, std::array<int, Way::count>{});
  std::vector<std::array<float, Way::count>> escapes(count);
  const auto find_escapes = [&](std::size_t body) {
    for (int i = 0; i < Way::count; ++i) escapes[body][std::size_t(i)] = escape(int(body), Way{i}, active);
  };
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b)
      for (std::size_t i = 0; i < Way::count; ++i) blockers[a][i] += a != b && ways(int(a), int(b))[i];
    find_escapes(a);
  }
  std::size_t left = count;
  while (left > 1) {
    int best = -1;
    std::array<float, 3> least{};
    for (std::size_t body = 0; body < count; ++body) {
      if (!active[body] || bodies_[body].fixed) continue;
      for (int i = 0; i < Way::count; ++i) {
        if (blockers[body][std::size_t(i)] > 0) continue;
        const Way way{i};
        const lumen::Bounds& box = bodies_[body].bounds;
        const std::array<float, 3> cost{escapes[body][std::size_t(i)], box.radius(), -glm::dot(box.center() - all.center(), way.vector())};
        if (best >= 0 && !less(cost, least, 1e-4f * all.radius())) continue;
        best = int(body);
        bodies_[body].way = way;
        least = cost;
      }
    }
    if (best < 0) break;
    active[std::size_t(best)] = false;
    order_.push_back(best);
    --left;
    for (std::size_t other = 0; other < count; ++other) {
      if (!active[other]) continue;
      for (std::size_t i = 0; i < Way::count; ++i) blockers[other][i] -= ways(int(other), best)[i];
      if (near(int(other), best)) find_escapes(other);
    }
  }
  leaving_ = order_.size();
  for (std::size_t body = 0; body < count; ++body) {
    if (!active[body]) continue;
    order_.push_back(int(body));
    stuck_ += !bodies_[body].fixed;
  }
  // One may stay: the others leave it.
  const bool some_fixed = std::any_of(bodies_.begin(), bodies_.end(), [](const Body& body) { return body.fixed; });
  if (!some_fixed && stuck_ > 0) --stuck_;
}

/// From the last that leaves to the first. A body passes all that it touches, moved as far as they move; it is out of the way of what
/// leaves across its own way later, and does not stay behind what leaves after it on the same.
void ExplosionGraph::find_distances() {
  for (std::size_t place = leaving_; place-- > 0;) {
    const int number = order_[place];
    Body& body = bodies_[std::size_t(number)];
    const float begin = back(body.bounds, body.way);
    body.distance = asked_.gap;
    for (std::size_t later = place + 1; later < order_.size(); ++later) {
      const int other = order_[later];
      const Body& still = bodies_[std::size_t(other)];
      const bool along = still.distance > 0 && still.way == body.way;
      if (near(number, other)) body.distance = std::max(body.distance, front(still.bounds, body.way) - begin + asked_.gap + (along ? still.distance : 0));
      if (along && ways(other, number)[std::size_t(body.way.index)]) {
        body.distance = std::max(body.distance, still.distance);
        body.before.push_back(other);
      }
    }
    std::vector<bool> crossed(order_.size(), false);
    for (bool changed = true; changed;) {
      changed = false;
      const lumen::Bounds own = swept(body.bounds, body.way, body.distance);
      for (std::size_t later = place + 1; later < leaving_; ++later) {
        const int other = order_[later];
        const Body& still = bodies_[std::size_t(other)];
        if (crossed[later] || still.way.axis() == body.way.axis() || meet(number, other)) continue;
        const lumen::Bounds path = swept(still.bounds, still.way, still.distance);
        if (!overlap(own, path, 0)) continue;
        crossed[later] = true;
        body.before.push_back(other);
        const float needed = front(path, body.way) - begin + asked_.gap;
        if (needed <= body.distance) continue;
        body.distance = needed;
        changed = true;
        break;
      }
    }
  }
  // So far `before` names what depends on the body; turn it around.
  std::vector<std::vector<int>> before(bodies_.size());
  for (const int number : order_)
    for (const int other : bodies_[std::size_t(number)].before) before[std::size_t(other)].push_back(number);
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].before = std::move(before[i]);
}

/// What crosses another's way goes when that is out; what goes the same way goes at the same time.
void ExplosionGraph::find_levels() {
  for (std::size_t place = 0; place < leaving_; ++place) {
    Body& body = bodies_[std::size_t(order_[place])];
    for (const int number : body.before) {
      const Body& first = bodies_[std::size_t(number)];
      body.level = std::max(body.level, first.level + (first.way.axis() == body.way.axis() ? 0 : 1));
    }
    levels_ = std::max(levels_, body.level + 1);
  }
}

std::vector<glm::vec3> ExplosionGraph::moves(std::span<const float> degrees) const {
  std::vector<float> wanted(bodies_.size(), 0);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    for (const int part : bodies_[i].parts) wanted[i] = std::max(wanted[i], degrees[std::size_t(part)]);
  for (std::size_t place = leaving_; place-- > 0;) {
    const auto number = std::size_t(order_[place]);
    for (const int first : bodies_[number].before) wanted[std::size_t(first)] = std::max(wanted[std::size_t(first)], wanted[number]);
  }
  std::vector<glm::vec3> moves(std::size_t(parts_), glm::vec3(0));
  for (std::size_t place = 0; place < leaving_; ++place) {
    const auto number = std::size_t(order_[place]);
    const Body& body = bodies_[number];
    const float along = std::clamp(wanted[number] * float(levels_) - float(body.level), 0.0f, 1.0f);
    const glm::vec3 move = along * body.distance * (axes_ * body.way.vector());
    for (const int part : body.parts) moves[std::size_t(part)] = move;
  }
  return moves;
}
