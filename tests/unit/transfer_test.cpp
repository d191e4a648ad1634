/// Data through sealed shared memory: it arrives as it was, and nothing that a sender does brings the receiver down.
#include <cstring>
#include <random>

#include <fcntl.h>
#include <sys/mman.h>

#include <gtest/gtest.h>

#include <lumen/error.h>
#include <lumen/image.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/transfer.h>
#include <lumen/volume.h>

namespace {

using lumen::Attribute;
using lumen::DataPointer;
using lumen::Descriptor;

std::shared_ptr<lumen::Mesh> make_mesh() {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->origin = "tetrahedron.ply";
  mesh->positions = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  mesh->normals = std::vector<glm::vec3>{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh->texture_coordinates = std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  mesh->triangle_cells = std::vector<std::uint32_t>{0, 0, 1, 1};
  mesh->attributes.push_back({"pressure", Attribute::On::points, 1, std::vector<float>{1, 2, 3, 4}});
  mesh->attributes.push_back({"flow", Attribute::On::cells, 2, std::vector<float>{1, 2, 3, 4}});
  mesh->finish();
  return mesh;
}

std::shared_ptr<lumen::Lines> make_lines() {
  auto lines = std::make_shared<lumen::Lines>();
  lines->positions = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {4, 4, 4}};
  lines->offsets = std::vector<std::uint32_t>{0, 2, 5};
  lines->attributes.push_back({"time", Attribute::On::points, 1, std::vector<float>{0, 1, 2, 3, 4}});
  lines->finish();
  return lines;
}

std::shared_ptr<lumen::Volume> make_volume() {
  auto volume = std::make_shared<lumen::Volume>();
  volume->origin = "scan";
  volume->dimensions = {2, 3, 2};
  volume->voxels = lumen::Array<std::int16_t>(std::vector<std::int16_t>{-5, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 900});
  volume->scale_offset = {2, -1};
  volume->to_object[3] = {10, 20, 30, 1};
  volume->finish();
  return volume;
}

std::shared_ptr<lumen::Image> make_image() {
  auto image = std::make_shared<lumen::Image>();
  image->width = 2;
  image->height = 1;
  image->channels = {"R", "depth.Z"};
  image->pixels = std::vector<float>{0.25f, 1, 0.5f, 2};
  image->finish();
  return image;
}

template <class T> std::shared_ptr<const T> through(const std::shared_ptr<T>& data) {
  return std::dynamic_pointer_cast<const T>(lumen::unpack(lumen::pack(*data).get()));
}

template <class T> std::vector<T> list(const lumen::Array<T>& array) { return {array.begin(), array.end()}; }

std::vector<std::byte> bytes_of(const Descriptor& memory) {
  const off_t size = ::lseek(memory.get(), 0, SEEK_END);
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  EXPECT_EQ(::pread(memory.get(), bytes.data(), bytes.size(), 0), size);
  return bytes;
}

Descriptor memory_of(const std::vector<std::byte>& bytes, int seals) {
  Descriptor memory(::memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  EXPECT_EQ(::write(memory.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  EXPECT_EQ(::fcntl(memory.get(), F_ADD_SEALS, seals), 0);
  return memory;
}

constexpr int all_seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE;

std::string refusal(const Descriptor& memory) {
  try {
    lumen::unpack(memory.get());
  } catch (const lumen::Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Transfer, CarriesEveryArrayOfAMesh) {
  const auto mesh = make_mesh();
  const auto copy = through(mesh);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->origin, "tetrahedron.ply");
  EXPECT_EQ(list(copy->positions), list(mesh->positions));
  EXPECT_EQ(list(copy->normals), list(mesh->normals));
  EXPECT_EQ(list(copy->texture_coordinates), list(mesh->texture_coordinates));
  EXPECT_EQ(list(copy->triangles), list(mesh->triangles));
  EXPECT_EQ(list(copy->triangle_cells), list(mesh->triangle_cells));
  ASSERT_EQ(copy->attributes.size(), 2u);
  EXPECT_EQ(copy->attributes[1].name, "flow");
  EXPECT_EQ(copy->attributes[1].on, Attribute::On::cells);
  EXPECT_EQ(copy->attributes[1].components, 2);
  EXPECT_EQ(list(copy->attributes[0].values), (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(copy->bounds().max, glm::vec3(1, 2, 3));
}

TEST(Transfer, CarriesLinesVolumesAndImages) {
  const auto lines = through(make_lines());
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->count(), 2u);
  EXPECT_EQ(lines->line(1)[2], glm::vec3(4, 4, 4));
  EXPECT_EQ(lines->attributes.at(0).name, "time");

  const auto volume = through(make_volume());
  ASSERT_TRUE(volume);
  EXPECT_EQ(volume->dimensions, glm::ivec3(2, 3, 2));
  EXPECT_EQ(std::get<lumen::Array<std::int16_t>>(volume->voxels)[11], 900);
  EXPECT_EQ(volume->scale_offset, glm::vec2(2, -1));
  EXPECT_EQ(volume->to_object[3], glm::vec4(10, 20, 30, 1));
  EXPECT_EQ(volume->value_range, glm::vec2(-5, 900));

  const auto image = through(make_image());
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 2);
  EXPECT_EQ(image->channels, (std::vector<std::string>{"R", "depth.Z"}));
  EXPECT_EQ(list(image->pixels), (std::vector<float>{0.25f, 1, 0.5f, 2}));
}

TEST(Transfer, KeepsTheMappingWhileAnArrayOfItLives) {
  lumen::Array<glm::vec3> positions;
  {
    const auto copy = through(make_mesh());
    positions = copy->positions;
  }
  EXPECT_EQ(positions[3], glm::vec3(0, 0, 3));
}

TEST(Transfer, AlignsArraysForTheGraphicsCard) {
  const auto copy = through(make_mesh());
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy->positions.data()) % 64, 0u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy->triangles.data()) % 64, 0u);
}

TEST(Transfer, SaysBeforehandHowMuchItTakes) {
  const auto mesh = make_mesh();
  EXPECT_EQ(bytes_of(lumen::pack(*mesh)).size(), lumen::packed_size(*mesh));
}

TEST(Transfer, RefusesMemoryThatCanStillChange) {
  const std::vector<std::byte> bytes = bytes_of(lumen::pack(*make_mesh()));
  EXPECT_EQ(refusal(memory_of(bytes, all_seals)), "accepted");
  for (const int missing : {F_SEAL_SHRINK, F_SEAL_GROW, F_SEAL_WRITE})
    EXPECT_NE(refusal(memory_of(bytes, all_seals & ~missing)).find("not sealed"), std::string::npos);
}

TEST(Transfer, RefusesMemoryWithHoles) {
  Descriptor memory(::memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ASSERT_EQ(::ftruncate(memory.get(), off_t{1} << 40), 0);
  ASSERT_EQ(::fcntl(memory.get(), F_ADD_SEALS, all_seals), 0);
  EXPECT_NE(refusal(memory).find("holes"), std::string::npos);
}

TEST(Transfer, RefusesEveryShorterPiece) {
  const std::vector<std::byte> bytes = bytes_of(lumen::pack(*make_mesh()));
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_NE(refusal(memory_of({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}, all_seals)), "accepted") << size;
}

TEST(Transfer, NamesAnIndexThatPointsNowhere) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->positions = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 1, 7}};
  EXPECT_NE(refusal(lumen::pack(*mesh)).find("7"), std::string::npos);
}

/// Whatever is accepted can be read to its end; address sanitizer builds see more than a crash.
void read_all(const lumen::Data& data) {
  volatile float sum = 0;
  const auto read = [&](const auto& array) {
    for (const auto& value : array) sum = sum + static_cast<float>(reinterpret_cast<const unsigned char&>(value));
  };
  if (const auto* const mesh = dynamic_cast<const lumen::Mesh*>(&data)) {
    for (const glm::uvec3& triangle : mesh->triangles) sum = sum + mesh->positions[triangle.x].x + mesh->positions[triangle.z].y;
    for (const Attribute& attribute : mesh->attributes) read(attribute.values);
    read(mesh->normals);
  } else if (const auto* const lines = dynamic_cast<const lumen::Lines*>(&data)) {
    for (std::size_t index = 0; index < lines->count(); ++index) read(lines->line(index));
  } else if (const auto* const volume = dynamic_cast<const lumen::Volume*>(&data)) {
    std::visit(read, volume->voxels);
  } else if (const auto* const image = dynamic_cast<const lumen::Image*>(&data)) {
    read(image->pixels);
  }
}

TEST(Transfer, SurvivesTenThousandCorruptions) {
  std::mt19937 random(7);
  int refused = 0, accepted = 0;
  for (const DataPointer& data : std::vector<DataPointer>{make_mesh(), make_lines(), make_volume(), make_image()}) {
    const std::vector<std::byte> good = bytes_of(lumen::pack(*data));
    for (int run = 0; run < 2500; ++run) {
      std::vector<std::byte> bytes = good;
      // Mostly the header and the tables: the arrays' own numbers are the smaller danger.
      const std::size_t area = run % 4 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 512);
      for (int flips = 1 + run % 3; flips > 0; --flips) bytes[random() % area] = std::byte(run % 5 == 0 ? 0xff : random() & 0xff);
      const Descriptor memory = memory_of(bytes, all_seals);
      try {
        read_all(*lumen::unpack(memory.get()));
        ++accepted;
      } catch (const lumen::Error&) {
        ++refused;
      }
    }
  }
  EXPECT_EQ(refused + accepted, 10000);
  EXPECT_GT(refused, 3000);
}

}  // namespace
