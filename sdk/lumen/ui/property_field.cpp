#include <lumen/ui/property_field.h>

#include <cmath>

#include <lumen/ui/color.h>
#include <lumen/ui/look.h>
#include <lumen/ui/reference_field.h>
#include <lumen/ui/simple_fields.h>
#include <lumen/ui/space_fields.h>
#include <lumen/ui/transfer_function_field.h>

namespace lumen::ui {
namespace {

/// One overload per alternative of Value: a new type does not compile until it has its control.
struct Control {
  Workbench& workbench;
  const PropertyState& state;
  const FieldStyle& style;
  NumberRange range;
  float width;

  Edit operator()(bool& value) const { return check_field("field", value, style); }
  Edit operator()(int& value) const { return number_field("field", value, range, width, style); }
  Edit operator()(float& value) const { return number_field("field", value, range, width, style); }
  Edit operator()(glm::vec2& value) const { return vector_field("field", {&value.x, 2}, range, width, "xyzw", style); }
  Edit operator()(glm::vec3& value) const { return vector_field("field", {&value.x, 3}, range, width, "xyzw", style); }
  Edit operator()(glm::vec4& value) const { return vector_field("field", {&value.x, 4}, range, width, "xyzw", style); }
  Edit operator()(Color& value) const { return color_field("field", value.rgb, range_of_color(state.spec), width, style); }
  Edit operator()(glm::quat& value) const { return rotation_field("field", value, width, style); }
  Edit operator()(glm::mat4& value) const { return matrix_field("field", value, width, style); }
  Edit operator()(std::string& value) const { return string_field("##field", value, width, style.failed); }
  Edit operator()(Path& value) const { return path_field("##field", value.file, width, style.failed); }
  Edit operator()(Choice& value) const { return choice_field("field", value.name, state.spec.options.choices, width, style); }
  Edit operator()(TransferFunction& value) const { return transfer_function_field("field", value, width, style); }
  Edit operator()(std::vector<int>& value) const { return list_field("field", value, range, width); }
  Edit operator()(std::vector<float>& value) const { return list_field("field", value, range, width); }
  Edit operator()(std::vector<std::string>& value) const { return list_field("field", value, width); }
  Edit operator()(Reference& value) const { return reference_field(workbench, "field", value.id, state.spec.options.accepts, width, style); }
  Edit operator()(References& value) const { return references_field(workbench, "field", value.ids, state.spec.options.accepts, width, style); }
  Edit operator()(DataPointer&) const {
    data_chip(state, width);
    return {};
  }
};

}  // namespace

NumberRange range_of_color(const PropertySpec& spec) {
  NumberRange range = NumberRange::of(spec);
  if (!std::isfinite(spec.options.min)) range.min = 0;
  if (!std::isfinite(spec.options.max)) range.max = 1;
  return range;
}

Edit property_field(Workbench& workbench, const PropertyState& state, Value& value, float width) {
  FieldStyle style;
  style.unit = state.spec.options.unit;
  style.source = state.expression.empty() ? state.link : state.expression;
  style.dimmed = !state.no_effect.empty();
  style.failed = !state.error.empty();
  // An expression has no inverse: its row edits the formula instead.
  style.locked = state.spec.output || !state.expression.empty();
  return std::visit(Control{workbench, state, style, NumberRange::of(state.spec), width}, value);
}

}  // namespace lumen::ui
