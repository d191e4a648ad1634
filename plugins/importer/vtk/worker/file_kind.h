/// What a file is, by its contents before its name.
#pragma once

#include <string>

enum class FileKind { xml_polygons, xml_unstructured, legacy, stl, obj, ply };

/// "VTK XML polygons" ...
std::string name_of(FileKind kind);

/// Throws lumen::Error, naming the file: missing, no regular file, empty, of no known kind, cut off.
FileKind kind_of(const std::string& path);

/// True if a file of that kind has the extension that `path` has.
bool extension_fits(const std::string& path, FileKind kind);

/// The last part of the path, for messages.
std::string short_name(const std::string& path);
