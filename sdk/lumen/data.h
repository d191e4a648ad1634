/// Immutable data that flows between instances: the base, and arrays that may live in memory shared with a helper process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <lumen/value.h>

namespace lumen {

enum class DataKind { mesh, lines, volume, image };
std::string_view name_of(DataKind kind);

/// Axis-aligned box; empty when min > max.
struct Bounds {
  glm::vec3 min{std::numeric_limits<float>::infinity()};
  glm::vec3 max{-std::numeric_limits<float>::infinity()};
  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  glm::vec3 center() const { return 0.5f * (min + max); }
  float radius() const { return empty() ? 0.0f : 0.5f * glm::length(max - min); }  ///< of the sphere around the box
  void include(glm::vec3 point);
  void include(const Bounds& other);
  Bounds transformed(const glm::mat4& matrix) const;  ///< the box around the moved box
};

/// A read-only array that keeps its memory alive: a vector of its own, or a part of a shared mapping.
template <class T>
class Array {
 public:
  Array() = default;
  Array(std::vector<T> values) {
    auto owned = std::make_shared<const std::vector<T>>(std::move(values));
    view_ = *owned;
    owner_ = std::move(owned);
  }
  Array(std::span<const T> view, std::shared_ptr<const void> owner) : view_(view), owner_(std::move(owner)) {}

  const T* data() const { return view_.data(); }
  std::size_t size() const { return view_.size(); }
  bool empty() const { return view_.empty(); }
  const T& operator[](std::size_t index) const { return view_[index]; }
  auto begin() const { return view_.begin(); }
  auto end() const { return view_.end(); }
  std::span<const T> view() const { return view_; }
  operator std::span<const T>() const { return view_; }

 private:
  std::span<const T> view_;
  std::shared_ptr<const void> owner_;
};

/// A named array of numbers on points or cells.
struct Attribute {
  enum class On { points, cells };
  std::string name;
  On on = On::points;
  int components = 1;      ///< per tuple, 1..16
  Array<float> values;     ///< tuples * components
};

/// Base of all data. `origin` says where it came from (a file name, a generator), for chips and messages.
struct Data {
  virtual ~Data();
  virtual DataKind kind() const = 0;
  virtual std::size_t bytes() const = 0;      ///< main memory held
  virtual Bounds bounds() const = 0;          ///< object space
  virtual std::string summary() const = 0;    ///< "169,680 triangles, 84,761 points"
  std::string origin;
};

/// Grouped by thousands: 1234567 -> "1,234,567".
std::string grouped(std::size_t number);

}  // namespace lumen
