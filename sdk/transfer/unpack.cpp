/// The receiver's side of a transfer. Everything that the memory says is checked before it is used.
#include <lumen/transfer.h>

#include <array>
#include <cstring>
#include <limits>
#include <optional>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <transfer/layout.h>
#include <lumen/error.h>
#include <lumen/image.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/volume.h>

namespace lumen {

namespace {

using namespace detail;

[[noreturn]] void refuse(const std::string& what) { throw Error("data from another process", what); }

/// Sealed memory, mapped read-only.
class Mapping {
 public:
  explicit Mapping(int descriptor) {
    constexpr int wanted = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE;
    const int seals = ::fcntl(descriptor, F_GET_SEALS);
    if (seals < 0 || (seals & wanted) != wanted) refuse("the shared memory is not sealed");
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || status.st_size < static_cast<off_t>(sizeof(TransferHeader))) refuse("the shared memory is too small");
    // Holes would be filled at our cost when they are read.
    if (status.st_blocks < status.st_size / 512) refuse("the shared memory has holes");
    size_ = static_cast<std::uint64_t>(status.st_size);
    void* const memory = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, descriptor, 0);
    if (memory == MAP_FAILED) refuse("the shared memory cannot be mapped");
    memory_ = static_cast<const std::byte*>(memory);
  }
  ~Mapping() { ::munmap(const_cast<std::byte*>(memory_), size_); }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::uint64_t size() const { return size_; }
  const std::byte* at(std::uint64_t offset) const { return memory_ + offset; }
  bool holds(std::uint64_t offset, std::uint64_t count, std::uint64_t element_size) const {
    return offset <= size_ && count <= (size_ - offset) / element_size;
  }

 private:
  const std::byte* memory_ = nullptr;
  std::uint64_t size_ = 0;
};

class Unpacker {
 public:
  explicit Unpacker(int descriptor) : mapping_(std::make_shared<const Mapping>(descriptor)) {
    std::memcpy(&header_, mapping_->at(0), sizeof header_);
    if (header_.magic != transfer_magic) refuse("no data");
    if (header_.version != transfer_version) refuse("another version of the transfer");
    if (header_.size != mapping_->size()) refuse("another size than it says");
    if (header_.array_count > most_arrays || !mapping_->holds(sizeof header_, header_.array_count, sizeof(TransferArray))) refuse("too many arrays");
    entries_.resize(header_.array_count);
    if (!entries_.empty()) std::memcpy(entries_.data(), mapping_->at(sizeof header_), entries_.size() * sizeof(TransferArray));
  }

  DataPointer data() const {
    switch (header_.kind) {
      case static_cast<std::uint32_t>(DataKind::mesh): return finished(mesh());
      case static_cast<std::uint32_t>(DataKind::lines): return finished(lines());
      case static_cast<std::uint32_t>(DataKind::volume): return finished(volume());
      case static_cast<std::uint32_t>(DataKind::image): return finished(image());
    }
    refuse("an unknown kind of data");
  }

 private:
  template <class T> DataPointer finished(std::shared_ptr<T> data) const {
    data->origin = text(header_.origin_offset, header_.origin_size);
    data->finish();
    return data;
  }

  std::string text(std::uint64_t offset, std::uint64_t size) const {
    if (size > longest_text || !mapping_->holds(offset, size, 1)) refuse("a text lies outside");
    return {reinterpret_cast<const char*>(mapping_->at(offset)), size};
  }

  /// Null if there is none.
  const TransferArray* find(Role role) const {
    const TransferArray* found = nullptr;
    for (const TransferArray& entry : entries_) {
      if (entry.role != role) continue;
      if (found) refuse("an array comes twice");
      found = &entry;
    }
    return found;
  }

  template <class T> Array<T> view(const TransferArray& entry) const {
    if (entry.element != ElementOf<T>::value) refuse("an array of another type");
    if (entry.offset % transfer_alignment != 0 || !mapping_->holds(entry.offset, entry.count, sizeof(T))) refuse("an array lies outside");
    return {std::span<const T>(reinterpret_cast<const T*>(mapping_->at(entry.offset)), entry.count), mapping_};
  }

  template <class T> Array<T> array(Role role) const {
    const TransferArray* const entry = find(role);
    return entry ? view<T>(*entry) : Array<T>();
  }

  template <class T, std::size_t size> std::array<T, size> numbers(Role role) const {
    const Array<T> values = array<T>(role);
    if (values.size() != size) refuse("numbers are missing");
    std::array<T, size> result;
    std::copy(values.begin(), values.end(), result.begin());
    return result;
  }

  /// A count that becomes an int; what is out of its range is refused by finish().
  static int whole(std::uint32_t number) {
    return number <= std::numeric_limits<int>::max() ? static_cast<int>(number) : -1;
  }

  std::vector<Attribute> attributes() const {
    std::vector<Attribute> result;
    for (const TransferArray& entry : entries_) {
      if (entry.role != Role::attribute) continue;
      if (entry.on > static_cast<std::uint32_t>(Attribute::On::cells)) refuse("an attribute on nothing");
      result.push_back({text(entry.name_offset, entry.name_size), static_cast<Attribute::On>(entry.on), whole(entry.components), view<float>(entry)});
    }
    return result;
  }

  std::shared_ptr<Mesh> mesh() const {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = array<glm::vec3>(Role::positions);
    mesh->normals = array<glm::vec3>(Role::normals);
    mesh->texture_coordinates = array<glm::vec2>(Role::texture_coordinates);
    mesh->triangles = array<glm::uvec3>(Role::triangles);
    mesh->triangle_cells = array<std::uint32_t>(Role::triangle_cells);
    mesh->attributes = attributes();
    return mesh;
  }

  std::shared_ptr<Lines> lines() const {
    auto lines = std::make_shared<Lines>();
    lines->positions = array<glm::vec3>(Role::positions);
    lines->offsets = array<std::uint32_t>(Role::offsets);
    lines->attributes = attributes();
    return lines;
  }

  std::shared_ptr<Volume> volume() const {
    auto volume = std::make_shared<Volume>();
    const auto whole_numbers = numbers<std::uint32_t, 4>(Role::whole);
    for (int axis = 0; axis < 3; ++axis) volume->dimensions[axis] = whole(whole_numbers[static_cast<std::size_t>(axis)]);
    volume->components = whole(whole_numbers[3]);
    const auto real = numbers<float, 18>(Role::real);
    volume->scale_offset = {real[0], real[1]};
    for (int index = 0; index < 16; ++index) volume->to_object[index / 4][index % 4] = real[static_cast<std::size_t>(index) + 2];
    if (const TransferArray* const entry = find(Role::voxels)) {
      switch (entry->element) {
        case Element::byte: volume->voxels = view<std::uint8_t>(*entry); break;
        case Element::int16: volume->voxels = view<std::int16_t>(*entry); break;
        case Element::uint16: volume->voxels = view<std::uint16_t>(*entry); break;
        default: volume->voxels = view<float>(*entry); break;
      }
    }
    return volume;
  }

  std::shared_ptr<Image> image() const {
    auto image = std::make_shared<Image>();
    const auto size = numbers<std::uint32_t, 2>(Role::whole);
    image->width = whole(size[0]);
    image->height = whole(size[1]);
    image->pixels = array<float>(Role::pixels);
    for (const TransferArray& entry : entries_)
      if (entry.role == Role::channel) image->channels.push_back(text(entry.name_offset, entry.name_size));
    return image;
  }

  std::shared_ptr<const Mapping> mapping_;
  TransferHeader header_;
  std::vector<TransferArray> entries_;
};

}  // namespace

DataPointer unpack(int descriptor) { return Unpacker(descriptor).data(); }

}  // namespace lumen
