/// Portable float maps (.pfm), which the OpenImageIO of Debian 12 does not know.
#pragma once

#include <string>

#include <lumen/image.h>

/// One channel, or the first three. Throws lumen::Error; `name` stands for the file in messages.
void write_float_map(const lumen::Image& image, const std::string& path, const std::string& name);

/// At most 2^28 numbers, which the file must hold. Throws lumen::Error.
std::shared_ptr<lumen::Image> read_float_map(const std::string& path);
