/// How data lies in shared memory: a header, a table of arrays, texts, then the arrays.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lumen::detail {

constexpr std::uint64_t transfer_magic = 0x31415441444d554cu;  // "LUMDATA1", little endian
constexpr std::uint32_t transfer_version = 1;
constexpr std::uint64_t transfer_alignment = 64;               // of every array, in bytes
constexpr std::uint64_t longest_text = 4096;                   // bytes, of origin and of each name
constexpr std::uint64_t most_arrays = 4096;

enum class Element : std::uint32_t { byte, int16, uint16, uint32, real, vec2, vec3, uvec3 };

template <class T> struct ElementOf;
template <> struct ElementOf<std::uint8_t> { static constexpr Element value = Element::byte; };
template <> struct ElementOf<std::int16_t> { static constexpr Element value = Element::int16; };
template <> struct ElementOf<std::uint16_t> { static constexpr Element value = Element::uint16; };
template <> struct ElementOf<std::uint32_t> { static constexpr Element value = Element::uint32; };
template <> struct ElementOf<float> { static constexpr Element value = Element::real; };
template <> struct ElementOf<glm::vec2> { static constexpr Element value = Element::vec2; };
template <> struct ElementOf<glm::vec3> { static constexpr Element value = Element::vec3; };
template <> struct ElementOf<glm::uvec3> { static constexpr Element value = Element::uvec3; };

/// What an array is to the data; each at most once, but attributes and channels.
enum class Role : std::uint32_t {
  positions, normals, texture_coordinates, triangles, triangle_cells, offsets, voxels, pixels,
  attribute,   ///< named
  channel,     ///< a name alone
  whole,       ///< uint32: dimensions and components of a volume, width and height of an image
  real         ///< float: scale_offset and to_object of a volume, column by column
};

struct TransferHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t kind;          ///< DataKind
  std::uint64_t size;          ///< of the whole memory, bytes
  std::uint64_t array_count;   ///< entries that follow
  std::uint64_t origin_offset;
  std::uint64_t origin_size;
};

struct TransferArray {
  Role role;
  Element element;
  std::uint64_t offset;        ///< from the start, a multiple of transfer_alignment
  std::uint64_t count;         ///< elements
  std::uint64_t name_offset;
  std::uint64_t name_size;
  std::uint32_t on;            ///< attributes: Attribute::On
  std::uint32_t components;    ///< attributes
};

}  // namespace lumen::detail
