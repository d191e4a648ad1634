/// Ready color maps; those that read well under every color vision come first.
#pragma once

#include <span>
#include <string_view>

#include <lumen/value.h>

namespace lumen::ui {

/// viridis, cividis, gray, cool to warm, heat.
std::span<const std::string_view> color_map_names();

/// `function` with the map's colors over its range and its own opacity; unchanged if the name is unknown.
TransferFunction with_colors(const TransferFunction& function, std::string_view map);

}  // namespace lumen::ui
