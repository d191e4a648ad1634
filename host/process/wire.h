/// The bytes of messages between the program, its helper process and that one's children.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace lumenshop {

class WireWriter {
 public:
  void number(std::uint64_t value);
  void real(float value);
  void text(std::string_view value);
  void texts(const std::map<std::string, std::string>& values);
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what WireWriter wrote. Each function throws lumen::Error if the bytes do not hold it.
class WireReader {
 public:
  explicit WireReader(std::string_view bytes) : rest_(bytes) {}
  std::uint64_t number();
  float real();
  std::string text();
  std::map<std::string, std::string> texts();

 private:
  std::string_view take(std::uint64_t count);
  std::string_view rest_;
};

}  // namespace lumenshop
