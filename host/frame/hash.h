/// A running 64-bit hash of values: what a pass depends on, as one number.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace lumenshop {

class Hash {
 public:
  template <class T>
    requires std::is_trivially_copyable_v<T>
  Hash& add(const T& value) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    for (std::size_t i = 0; i < sizeof(T); ++i) mix(bytes[i]);
    return *this;
  }
  Hash& add(std::string_view text) {
    for (const char c : text) mix(static_cast<unsigned char>(c));
    mix(0xff);
    return *this;
  }
  std::uint64_t value() const { return state_; }

 private:
  void mix(unsigned char byte) { state_ = (state_ ^ byte) * 1099511628211ull; }  // FNV-1a
  std::uint64_t state_ = 14695981039346656037ull;
};

}  // namespace lumenshop
