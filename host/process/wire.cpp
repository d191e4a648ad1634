#include "process/wire.h"

#include <cstring>

#include <lumen/error.h>

namespace lumenshop {

void WireWriter::number(std::uint64_t value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }

void WireWriter::real(float value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }

void WireWriter::text(std::string_view value) {
  number(value.size());
  bytes_.append(value);
}

void WireWriter::texts(const std::map<std::string, std::string>& values) {
  number(values.size());
  for (const auto& [name, value] : values) {
    text(name);
    text(value);
  }
}

std::string_view WireReader::take(std::uint64_t count) {
  if (count > rest_.size()) throw lumen::Error("helper process", "a message is too short");
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::uint64_t WireReader::number() {
  std::uint64_t value;
  std::memcpy(&value, take(sizeof value).data(), sizeof value);
  return value;
}

float WireReader::real() {
  float value;
  std::memcpy(&value, take(sizeof value).data(), sizeof value);
  return value;
}

std::string WireReader::text() { return std::string(take(number())); }

std::map<std::string, std::string> WireReader::texts() {
  std::map<std::string, std::string> values;
  for (std::uint64_t left = number(); left > 0; --left) {
    std::string name = text();
    values[std::move(name)] = text();
  }
  return values;
}

}  // namespace lumenshop
