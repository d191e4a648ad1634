/// The sender's side of a transfer: data into sealed shared memory.
#include <lumen/transfer.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <type_traits>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <transfer/layout.h>
#include <lumen/error.h>
#include <lumen/image.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/volume.h>

namespace lumen {

namespace {

using namespace detail;

std::uint64_t aligned(std::uint64_t offset) { return (offset + transfer_alignment - 1) / transfer_alignment * transfer_alignment; }

/// Collects what is to be written, then writes it at once.
class Packer {
 public:
  explicit Packer(const Data& data) : kind_(data.kind()), origin_(data.origin) {
    switch (kind_) {
      case DataKind::mesh: add(static_cast<const Mesh&>(data)); break;
      case DataKind::lines: add(static_cast<const Lines&>(data)); break;
      case DataKind::volume: add(static_cast<const Volume&>(data)); break;
      case DataKind::image: add(static_cast<const Image&>(data)); break;
    }
    lay_out();
  }

  std::uint64_t size() const { return size_; }

  /// Hands out the bytes in order: each piece with its offset. What lies between them is padding.
  template <class Write> void write(const Write& to) const {
    const TransferHeader header{transfer_magic, transfer_version, static_cast<std::uint32_t>(kind_), size_, pieces_.size(), origin_offset_, origin_.size()};
    std::string head(reinterpret_cast<const char*>(&header), sizeof header);
    for (const Piece& piece : pieces_) head.append(reinterpret_cast<const char*>(&piece.entry), sizeof piece.entry);
    head += origin_;
    for (const Piece& piece : pieces_) head += piece.name;
    to(0, head.data(), head.size());
    for (const Piece& piece : pieces_) to(piece.entry.offset, piece.data, piece.bytes);
  }

 private:
  struct Piece {
    TransferArray entry;
    std::string_view name;
    const void* data;
    std::uint64_t bytes;
  };

  template <class T> void array(Role role, std::span<const T> values) {
    if (!values.empty()) pieces_.push_back({{role, ElementOf<T>::value, 0, values.size(), 0, 0, 0, 0}, {}, values.data(), values.size_bytes()});
  }

  void add(const std::vector<Attribute>& attributes) {
    for (const Attribute& attribute : attributes) {
      const std::span<const float> values = attribute.values.view();
      pieces_.push_back({{Role::attribute, Element::real, 0, values.size(), 0, 0, static_cast<std::uint32_t>(attribute.on), static_cast<std::uint32_t>(attribute.components)},
                         attribute.name, values.data(), values.size_bytes()});
    }
  }

  void add(const Mesh& mesh) {
    array(Role::positions, mesh.positions.view());
    array(Role::normals, mesh.normals.view());
    array(Role::texture_coordinates, mesh.texture_coordinates.view());
    array(Role::triangles, mesh.triangles.view());
    array(Role::triangle_cells, mesh.triangle_cells.view());
    add(mesh.attributes);
  }

  void add(const Lines& lines) {
    array(Role::positions, lines.positions.view());
    array(Role::offsets, lines.offsets.view());
    add(lines.attributes);
  }

  void add(const Volume& volume) {
    for (int axis = 0; axis < 3; ++axis) whole_.push_back(static_cast<std::uint32_t>(volume.dimensions[axis]));
    whole_.push_back(static_cast<std::uint32_t>(volume.components));
    real_ = {volume.scale_offset.x, volume.scale_offset.y};
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) real_.push_back(volume.to_object[column][row]);
    array(Role::whole, std::span<const std::uint32_t>(whole_));
    array(Role::real, std::span<const float>(real_));
    std::visit([this](const auto& voxels) { array(Role::voxels, voxels.view()); }, volume.voxels);
  }

  void add(const Image& image) {
    whole_ = {static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height)};
    array(Role::whole, std::span<const std::uint32_t>(whole_));
    array(Role::pixels, image.pixels.view());
    for (const std::string& channel : image.channels) pieces_.push_back({{Role::channel, Element::byte, 0, 0, 0, 0, 0, 0}, channel, nullptr, 0});
  }

  void lay_out() {
    const auto fail = [&](const std::string& what) { throw Error(std::string(origin_.substr(0, 256)), what); };
    if (pieces_.size() > most_arrays) fail(grouped(pieces_.size()) + " arrays; at most " + grouped(most_arrays) + " can be handed over");
    if (origin_.size() > longest_text) fail("the name of its origin is too long");
    for (const Piece& piece : pieces_)
      if (piece.name.size() > longest_text) fail("the name of an array is too long");
    origin_offset_ = sizeof(TransferHeader) + pieces_.size() * sizeof(TransferArray);
    std::uint64_t end = origin_offset_ + origin_.size();
    for (Piece& piece : pieces_) {
      piece.entry.name_offset = end;
      piece.entry.name_size = piece.name.size();
      end += piece.name.size();
    }
    for (Piece& piece : pieces_) {
      piece.entry.offset = aligned(end);
      end = piece.entry.offset + piece.bytes;
    }
    size_ = end;
  }

  DataKind kind_;
  std::string_view origin_;
  std::vector<std::uint32_t> whole_;
  std::vector<float> real_;
  std::vector<Piece> pieces_;
  std::uint64_t origin_offset_ = 0, size_ = 0;
};

}  // namespace

std::size_t packed_size(const Data& data) { return Packer(data).size(); }

Descriptor pack(const Data& data) {
  const Packer packer(data);
  const auto fail = [&](const char* what) { throw Error(data.origin.empty() ? "transfer" : data.origin, std::string(what) + ": " + std::strerror(errno)); };

  Descriptor memory(::memfd_create("lumen-data", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!memory) fail("no shared memory");
  if (::ftruncate(memory.get(), static_cast<off_t>(packer.size())) != 0) fail("shared memory cannot grow");
  // Written, not mapped: that takes no page faults, and a full memory is an error here and not a signal.
  packer.write([&](std::uint64_t offset, const void* data, std::uint64_t bytes) {
    const auto* from = static_cast<const std::byte*>(data);
    while (bytes != 0) {
      const ssize_t written = ::pwrite(memory.get(), from, bytes, static_cast<off_t>(offset));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail(("no " + grouped(packer.size()) + " bytes of shared memory").c_str());
      from += written;
      offset += static_cast<std::uint64_t>(written);
      bytes -= static_cast<std::uint64_t>(written);
    }
  });
  if (::fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) != 0) fail("shared memory cannot be sealed");
  return memory;
}

}  // namespace lumen
