/// One pass over the text, without a copy of it.
#include "obj_text.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <map>
#include <string_view>

#include <lumen/error.h>

#include "file_kind.h"

namespace {

bool is_space(char letter) { return letter == ' ' || letter == '\t' || letter == '\r'; }

/// The words of one line.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}
  std::string_view next() {
    std::size_t begin = 0;
    while (begin < rest_.size() && is_space(rest_[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest_.size() && !is_space(rest_[end])) ++end;
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }
  std::string_view rest() {
    while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
    while (!rest_.empty() && is_space(rest_.back())) rest_.remove_suffix(1);
    return rest_;
  }

 private:
  std::string_view rest_;
};

/// As many numbers as there are, up to `most`.
int numbers(Words& words, float* target, int most) {
  int count = 0;
  while (count < most) {
    std::string_view word = words.next();
    if (word.starts_with('+')) word.remove_prefix(1);
    // What some compilers' libraries print for NaN: 1.#IND, -1.#QNAN.
    if (word.find(".#") != std::string_view::npos) {
      target[count++] = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), target[count]);
    if (word.empty() || error == std::errc::invalid_argument || end != word.data() + word.size()) break;
    // Out of range: nothing was stored. It is no coordinate that anything could be drawn with.
    if (error == std::errc::result_out_of_range) target[count] = 0;
    ++count;
  }
  return count;
}

/// "7", "7/2", "7//3", "7/2/3", "-1/-1": false if it is none of these.
bool corner(std::string_view word, const ObjText& text, ObjCorner& result) {
  std::int64_t* const targets[] = {&result.position, &result.coordinate, &result.normal};
  const std::size_t counts[] = {text.positions.size(), text.coordinates.size(), text.normals.size()};
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = word.find('/');
    const std::string_view digits = word.substr(0, slash);
    if (!digits.empty()) {
      std::int64_t number = 0;
      const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
      if (error != std::errc() || end != digits.data() + digits.size()) return false;
      *targets[part] = number > 0 ? number - 1 : number < 0 ? static_cast<std::int64_t>(counts[part]) + number : -1;
    } else if (part == 0) {
      return false;
    }
    if (slash == std::string_view::npos) return true;
    word.remove_prefix(slash + 1);
  }
  return false;
}

/// Names as numbers in the order in which they come.
class Numbering {
 public:
  float of(std::string_view name) { return static_cast<float>(numbers_.emplace(name, numbers_.size()).first->second); }

 private:
  std::map<std::string, std::size_t, std::less<>> numbers_;
};

class Parser {
 public:
  explicit Parser(std::string file) : file_(std::move(file)) {}
  ObjText text;

  void statement(std::string_view line, std::size_t number) {
    Words words(line);
    const std::string_view key = words.next();
    if (key == "v") {
      float values[6];
      const int count = numbers(words, values, 6);
      if (count < 3) throw lumen::Error(file_ + ":" + std::to_string(number), "a point needs three numbers");
      text.positions.emplace_back(values[0], values[1], values[2]);
      if (count == 6) text.colors.emplace_back(values[3], values[4], values[5]);
    } else if (key == "vn") {
      glm::vec3 normal(0);
      numbers(words, &normal.x, 3);
      text.normals.push_back(normal);
    } else if (key == "vt") {
      glm::vec2 coordinate(0);
      numbers(words, &coordinate.x, 2);
      text.coordinates.push_back(coordinate);
    } else if (key == "f") {
      cell(words, text.polygons);
    } else if (key == "l") {
      cell(words, text.lines);
    } else if (key == "g" || key == "o") {
      group_ = groups_.of(words.rest());
    } else if (key == "usemtl") {
      material_ = materials_.of(words.rest());
    }
  }

 private:
  void cell(Words& words, ObjText::Cells& cells) {
    const std::size_t before = cells.corners.size();
    for (std::string_view word = words.next(); !word.empty() && word.front() != '#'; word = words.next()) {
      ObjCorner found;
      if (!corner(word, text, found)) {
        cells.corners.resize(before);
        ++text.ill_formed;
        return;
      }
      cells.corners.push_back(found);
    }
    cells.offsets.push_back(static_cast<std::uint32_t>(cells.corners.size()));
    cells.groups.push_back(group_);
    cells.materials.push_back(material_);
  }

  std::string file_;
  Numbering groups_, materials_;
  float group_ = 0, material_ = 0;
};

std::string contents_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  std::string text(static_cast<std::size_t>(std::max(std::streamoff{0}, std::streamoff{stream.tellg()})), '\0');
  stream.seekg(0);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream) throw lumen::Error(short_name(path), "cannot be read");
  return text;
}

}  // namespace

ObjText parse_obj(const std::string& path, lumen::WorkerProgress progress) {
  std::string text = contents_of(path);
  // A backslash joins two lines.
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    std::size_t end = at + 1;
    if (end < text.size() && text[end] == '\r') ++end;
    if (end < text.size() && text[end] == '\n') std::fill(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin() + static_cast<std::ptrdiff_t>(end + 1), ' ');
  }
  Parser parser(short_name(path));
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    parser.statement(std::string_view(text).substr(begin, end - begin), line);
    begin = end + 1;
    if (line % 65536 == 0) progress(0.7f * static_cast<float>(begin) / static_cast<float>(text.size()));
  }
  return std::move(parser.text);
}
