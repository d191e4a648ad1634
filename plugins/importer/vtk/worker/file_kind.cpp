/// Looks at the first kilobytes of a file.
#include "file_kind.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <regex>

#include <lumen/data.h>
#include <lumen/error.h>

namespace {

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return extension;
}

/// A binary STL has 80 bytes of anything, a count, and 50 bytes per triangle.
constexpr std::size_t stl_header = 84, stl_triangle = 50;
std::size_t stl_triangles(const std::string& head) {
  std::uint32_t count;
  std::memcpy(&count, head.data() + 80, sizeof count);
  return count;
}

bool is_text(const std::string& head) {
  return std::none_of(head.begin(), head.end(), [](unsigned char byte) { return byte < 9 || (byte > 13 && byte < 32 && byte != 27); });
}

}  // namespace

std::string short_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string name_of(FileKind kind) {
  switch (kind) {
    case FileKind::xml_polygons: return "VTK XML polygons";
    case FileKind::xml_unstructured: return "a VTK XML unstructured grid";
    case FileKind::legacy: return "VTK legacy data";
    case FileKind::stl: return "STL";
    case FileKind::obj: return "OBJ";
    case FileKind::ply: return "PLY";
  }
  return {};
}

bool extension_fits(const std::string& path, FileKind kind) {
  const std::string extension = extension_of(path);
  switch (kind) {
    case FileKind::xml_polygons: return extension == ".vtp";
    case FileKind::xml_unstructured: return extension == ".vtu";
    case FileKind::legacy: return extension == ".vtk";
    case FileKind::stl: return extension == ".stl";
    case FileKind::obj: return extension == ".obj";
    case FileKind::ply: return extension == ".ply";
  }
  return false;
}

FileKind kind_of(const std::string& path) {
  const std::string file = short_name(path);
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw lumen::Error(file, "there is no such file", "check the path " + path);
  if (!std::filesystem::is_regular_file(status)) throw lumen::Error(file, "is no regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw lumen::Error(file, error.message());
  if (size == 0) throw lumen::Error(file, "is empty");

  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw lumen::Error(file, "cannot be opened", "check its permissions");
  std::string head(4096, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));

  std::size_t begin = head.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  begin = std::min(head.find_first_not_of(" \t\r\n", begin), head.size());
  const std::string start = head.substr(begin);
  if (start.starts_with("# vtk DataFile")) return FileKind::legacy;
  if (start.starts_with("ply") && start.size() > 3 && std::isspace(static_cast<unsigned char>(start[3]))) return FileKind::ply;
  if (start.starts_with("<")) {
    std::smatch found;
    static const std::regex type(R"re(<VTKFile[^>]*\btype\s*=\s*["']([A-Za-z]+)["'])re");
    if (!std::regex_search(start, found, type)) throw lumen::Error(file + ":1", "not a VTK XML file", "expected <VTKFile type=...>");
    if (found[1] == "PolyData") return FileKind::xml_polygons;
    if (found[1] == "UnstructuredGrid") return FileKind::xml_unstructured;
    throw lumen::Error(file, "holds VTK data of type " + found[1].str(), "PolyData and UnstructuredGrid can be read");
  }

  const std::string extension = extension_of(path);
  const bool stl_size = head.size() >= stl_header && stl_header + stl_triangle * stl_triangles(head) == size;
  if (stl_size) return FileKind::stl;
  if (extension == ".stl") {
    if (start.starts_with("solid") || (is_text(head) && start.find("facet") != std::string::npos)) return FileKind::stl;
    if (head.size() < stl_header) throw lumen::Error(file, "not an STL file: neither 'solid' nor a binary header of 84 bytes");
    if (stl_header + stl_triangle * stl_triangles(head) > size)
      throw lumen::Error(file, "is cut off, or no STL file: its header names " + lumen::grouped(stl_triangles(head)) + " triangles");
    return FileKind::stl;
  }
  if (start.starts_with("solid") && start.find("facet") != std::string::npos) return FileKind::stl;
  if (extension == ".obj") {
    if (!is_text(head)) throw lumen::Error(file, "not an OBJ file: it holds binary data");
    return FileKind::obj;
  }
  if (extension == ".ply") throw lumen::Error(file + ":1", "not a PLY file", "expected 'ply'");
  if (extension == ".vtk") throw lumen::Error(file + ":1", "not a VTK legacy file", "expected '# vtk DataFile Version ...'");
  if (extension == ".vtp" || extension == ".vtu") throw lumen::Error(file + ":1", "not a VTK XML file", "expected <VTKFile>");
  throw lumen::Error(file, "of no kind that can be read", ".vtp .vtu .vtk .stl .obj .ply can be");
}
