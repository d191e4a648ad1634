/// JSON text that may come from anyone: read with bounds and places of mistakes, written so that a diff reads well.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/json_value.h"

namespace lumenshop {

/// `name` is the file's, for messages. Throws lumen::Error "name:line:column: what": a syntax error, deeper than 64
/// levels (checked before parsing: no recursion), a list or object of more than 65536 entries, a number beyond double.
/// Of a key that appears twice the later counts; `duplicates` gets its name.
Json parse_json(std::string_view text, const std::string& name, std::vector<std::string>* duplicates = nullptr);

/// Two spaces of indentation; arrays of scalars and objects of one entry or a link on one line where they are short.
std::string json_text(const Json& json);

/// Adds at the end without looking for the key: objects of thousands of entries stay linear. The key must be new.
void append(Json& object, std::string key, Json value);

}  // namespace lumenshop
