#include "model/json_text.h"

#include <array>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include <lumen/error.h>

namespace lumenshop {
namespace {

constexpr int deepest = 64;
constexpr std::size_t most_entries = 65536;
constexpr std::size_t widest_line = 100;

std::string place(std::string_view text, const std::string& name, std::size_t offset) {
  offset = std::min(offset, text.size());
  std::size_t line = 1, start = 0;
  for (std::size_t i = 0; i < offset; ++i)
    if (text[i] == '\n') ++line, start = i + 1;
  return name + ":" + std::to_string(line) + ":" + std::to_string(offset - start + 1);
}

/// Depth and sizes by brackets and commas alone, so that nothing deep or huge ever reaches the parser.
void check_bounds(std::string_view text, const std::string& name) {
  std::array<std::size_t, deepest + 1> entries{};
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      else if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest) throw lumen::Error(place(text, name, i), "nested deeper than " + std::to_string(deepest) + " levels");
      entries[depth] = 1;
    } else if (c == ']' || c == '}') {
      if (--depth < 0) throw lumen::Error(place(text, name, i), std::string("'") + c + "' without its opening bracket");
    } else if (c == ',' && ++entries[depth] > most_entries) {
      throw lumen::Error(place(text, name, i), "a list of more than " + std::to_string(most_entries) + " entries");
    }
  }
}

/// Builds the tree. nlohmann's own builder looks every key up in a list, which is quadratic in ordered objects.
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(std::string_view text, const std::string& name, std::vector<std::string>* duplicates)
      : text_(text), name_(name), duplicates_(duplicates) {}
  Json take() { return std::move(root_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t&) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    levels_.back().key = std::move(value);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) override {
    if (text_.find_first_not_of(" \t\r\n") == std::string_view::npos) throw lumen::Error(name_, "the file is empty");
    std::string what = error.what();
    if (const auto details = what.find(" - "); details != std::string::npos) what = what.substr(details + 3);
    else what = "number out of range '" + token.substr(0, 40) + "'";
    if (const auto token_text = what.find("; last read"); token_text != std::string::npos) what.resize(token_text);
    if (const auto token_text = what.find("; expected"); token_text != std::string::npos) what.replace(token_text, 1, ",");
    throw lumen::Error(place(text_, name_, position == 0 ? 0 : position - 1), "not valid JSON: " + what.substr(0, 200));
  }

 private:
  struct Level {
    Json* json;
    std::string key;
    std::unordered_map<std::string, std::size_t> places;  // of an object's keys
  };

  Json* insert(Json value) {
    if (levels_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Level& level = levels_.back();
    if (level.json->is_array()) {
      level.json->push_back(std::move(value));
      return &level.json->back();
    }
    auto& members = level.json->get_ref<Json::object_t&>();
    const auto [found, fresh] = level.places.emplace(level.key, members.size());
    if (fresh) return &members.emplace_back(level.key, std::move(value)).second;
    if (duplicates_) duplicates_->push_back(level.key);
    Json& place = (members.begin() + static_cast<std::ptrdiff_t>(found->second))->second;
    place = std::move(value);
    return &place;
  }
  bool put(Json value) { return insert(std::move(value)), true; }
  bool open(Json container) {
    Json* json = insert(std::move(container));
    levels_.push_back({json, {}, {}});
    return true;
  }
  bool close() { return levels_.pop_back(), true; }

  std::string_view text_;
  const std::string& name_;
  std::vector<std::string>* duplicates_;
  std::vector<Level> levels_;
  Json root_;
};

std::string scalar_text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// The one-line form, or empty if it should not or cannot be on one line.
std::string line_text(const Json& json) {
  if (json.is_object() ? json.size() > 1 && !json.contains("link") : json.size() > widest_line) return {};
  std::string line(1, json.is_object() ? '{' : '[');
  bool first = true;
  for (const auto& [key, entry] : json.items()) {
    if (entry.is_structured()) return {};
    if (!first) line += ", ";
    first = false;
    if (json.is_object()) line += scalar_text(key) + ": ";
    line += scalar_text(entry);
    if (line.size() > widest_line) return {};
  }
  return line + (json.is_object() ? '}' : ']');
}

void write(const Json& json, int indentation, std::string& out) {
  if (!json.is_structured()) {
    out += scalar_text(json);
    return;
  }
  if (const std::string line = line_text(json); !line.empty()) {
    out += line;
    return;
  }
  const bool object = json.is_object();
  out += object ? '{' : '[';
  bool first = true;
  for (auto entry = json.begin(); entry != json.end(); ++entry) {
    out += first ? "\n" : ",\n";
    first = false;
    out.append(indentation + 2, ' ');
    if (object) out += scalar_text(entry.key()) + ": ";
    write(*entry, indentation + 2, out);
  }
  out += '\n';
  out.append(indentation, ' ');
  out += object ? '}' : ']';
}

}  // namespace

Json parse_json(std::string_view text, const std::string& name, std::vector<std::string>* duplicates) {
  check_bounds(text, name);
  Builder builder(text, name, duplicates);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

std::string json_text(const Json& json) {
  std::string out;
  write(json, 0, out);
  out += '\n';
  return out;
}

void append(Json& object, std::string key, Json value) { object.get_ref<Json::object_t&>().emplace_back(std::move(key), std::move(value)); }

}  // namespace lumenshop
