#include "helper/probe_binding.h"

#include <algorithm>
#include <cmath>

namespace lumenshop {

namespace {

/// The numbers that a range bounds.
std::vector<double> numbers_of(const lumen::Value& value) {
  std::vector<double> numbers;
  const auto add = [&](const float* first, int count) { numbers.assign(first, first + count); };
  switch (lumen::type_of(value)) {
    case lumen::ValueType::integer: numbers = {static_cast<double>(std::get<int>(value))}; break;
    case lumen::ValueType::real: numbers = {std::get<float>(value)}; break;
    case lumen::ValueType::vec2: add(&std::get<glm::vec2>(value).x, 2); break;
    case lumen::ValueType::vec3: add(&std::get<glm::vec3>(value).x, 3); break;
    case lumen::ValueType::vec4: add(&std::get<glm::vec4>(value).x, 4); break;
    case lumen::ValueType::color: add(&std::get<lumen::Color>(value).rgb.x, 3); break;
    case lumen::ValueType::integers: numbers.assign(std::get<std::vector<int>>(value).begin(), std::get<std::vector<int>>(value).end()); break;
    case lumen::ValueType::reals: numbers.assign(std::get<std::vector<float>>(value).begin(), std::get<std::vector<float>>(value).end()); break;
    default: break;
  }
  return numbers;
}

bool well_formed(const std::string& id) {
  return !id.empty() && id != "type" && id[0] >= 'a' && id[0] <= 'z' && std::all_of(id.begin(), id.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
  });
}

std::string complaint_about(const lumen::PropertySpec& spec) {
  const lumen::PropertyOptions& options = spec.options;
  if (options.doc.empty()) return "it has no doc";
  if (!(options.min <= options.max)) return "its range is empty";
  if (options.logarithmic && !(options.min > 0)) return "it is logarithmic, but its range reaches 0";
  for (const double number : numbers_of(spec.default_value)) {
    if (!std::isfinite(number)) return "its default is not finite";
    // Ranges are double, values float: the nearest float of a bound is inside.
    if (number < std::min(options.min, double(float(options.min))) || number > std::max(options.max, double(float(options.max))))
      return "its default " + std::to_string(number) + " is outside its range";
  }
  if (spec.type == lumen::ValueType::choice) {
    const std::string& name = std::get<lumen::Choice>(spec.default_value).name;
    if (std::find(options.choices.begin(), options.choices.end(), name) == options.choices.end()) return "its default '" + name + "' is no choice";
  }
  return {};
}

}  // namespace

int ProbeBinding::declare(lumen::PropertySpec spec) {
  const std::string where = id_ + "." + spec.id;
  if (!well_formed(spec.id)) throw lumen::Error(where, "no property id", "it must be [a-z][a-z0-9_]* and not 'type'");
  if (lumen::type_of(spec.default_value) != spec.type) throw lumen::Error(where, "its default has another type");
  for (const Entry& entry : entries_)
    if (!entry.retracted && entry.spec.id == spec.id) throw lumen::Error(where, "declared twice");
  lumen::Value value = spec.default_value;
  entries_.push_back({std::move(spec), std::move(value)});
  return static_cast<int>(entries_.size()) - 1;
}

void ProbeBinding::retract(int slot) { at(slot).retracted = true; }

void ProbeBinding::write(int slot, lumen::Value value) {
  Entry& entry = at(slot);
  entry.value = std::move(value);
  entry.set = true;
  ++entry.revision;
}

void ProbeBinding::write_default(int slot, lumen::Value value) {
  Entry& entry = at(slot);
  entry.spec.default_value = value;
  if (!entry.set) entry.value = std::move(value);
  ++entry.revision;
}

std::vector<std::string> ProbeBinding::complaints() const {
  std::vector<std::string> complaints;
  for (const Entry& entry : entries_) {
    const lumen::PropertySpec& spec = entry.spec;
    if (const std::string complaint = complaint_about(spec); !complaint.empty()) complaints.push_back(spec.id + ": " + complaint);
    const std::string watched = spec.options.when.substr(0, spec.options.when.find_first_of(" !="));
    const bool known = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& other) { return other.spec.id == watched; });
    if (!watched.empty() && !known) complaints.push_back(spec.id + ": its condition names '" + watched + "', which is not there");
  }
  return complaints;
}

}  // namespace lumenshop
