#include "command/frame_name.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace lumenshop {
namespace {

std::string padded(int number, std::size_t digits) {
  std::string text = std::to_string(number);
  if (text.size() < digits) text.insert(0, digits - text.size(), '0');
  return text;
}

}  // namespace

std::filesystem::path frame_name(const std::filesystem::path& pattern, int frame) {
  std::string name = pattern.filename().string();
  if (const std::size_t begin = name.find('#'); begin != std::string::npos) {
    const std::size_t end = std::min(name.find_first_not_of('#', begin), name.size());
    return pattern.parent_path() / name.replace(begin, end - begin, padded(frame, end - begin));
  }
  if (const std::size_t begin = name.find('%'); begin != std::string::npos) {
    std::size_t end = begin + 1, digits = 0;
    for (; end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])); ++end) digits = std::min<std::size_t>(10 * digits + (name[end] - '0'), 20);
    if (end < name.size() && name[end] == 'd') return pattern.parent_path() / name.replace(begin, end + 1 - begin, padded(frame, digits));
  }
  return pattern.parent_path() / (pattern.stem().string() + "_" + padded(frame, 4) + pattern.extension().string());
}

}  // namespace lumenshop
