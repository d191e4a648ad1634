/// Fields of the simple types: truth, choice, vectors, texts, files, lists.
#pragma once

#include <span>
#include <string>

#include <lumen/ui/edit.h>
#include <lumen/ui/number_field.h>

namespace lumen::ui {

Edit check_field(const char* id, bool& value, const FieldStyle& style = {});

/// Up to four names as segments if they fit, else a list with a filter.
Edit choice_field(const char* id, std::string& name, std::span<const std::string> names, float width, const FieldStyle& style = {});

/// 1..4 numbers side by side; one below the other where the width is under 200 units.
Edit vector_field(const char* id, std::span<float> values, const NumberRange& range, float width, std::string_view prefixes = "xyzw",
                  const FieldStyle& style = {});

Edit string_field(const char* id, std::string& value, float width, bool failed = false);

/// A file: its text, the end shown; the button asks the look's host for its browser, whose answer comes as a drop.
Edit path_field(const char* id, std::string& file, float width, bool failed = false);

/// Numbers or texts, one per row, with add and remove.
Edit list_field(const char* id, std::vector<int>& values, const NumberRange& range, float width);
Edit list_field(const char* id, std::vector<float>& values, const NumberRange& range, float width);
Edit list_field(const char* id, std::vector<std::string>& values, float width);

}  // namespace lumen::ui
