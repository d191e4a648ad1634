#include "modules/elf_file.h"

#include <cerrno>
#include <cstring>

#include <elf.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <lumen/descriptor.h>
#include <lumen/error.h>

namespace lumenshop {

namespace {

constexpr off_t largest_library = off_t{1} << 30;

#if defined(__x86_64__)
constexpr Elf64_Half machine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half machine = EM_AARCH64;
#else
#error "name the ELF machine of this platform"
#endif

bool same_file(const struct stat& first, const struct stat& second) {
  return first.st_ino == second.st_ino && first.st_size == second.st_size && first.st_mtim.tv_sec == second.st_mtim.tv_sec &&
         first.st_mtim.tv_nsec == second.st_mtim.tv_nsec;
}

}  // namespace

ElfFile::ElfFile(const std::filesystem::path& file) : file_(file) {
  // Non-blocking, so that a pipe of that name does not hold us up.
  const lumen::Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat before {};
  if (!descriptor || ::fstat(descriptor.get(), &before) != 0) fail(std::string("cannot be read: ") + std::strerror(errno));
  if (!S_ISREG(before.st_mode)) fail("is no regular file");
  if (before.st_size > largest_library) fail("is larger than 1 GiB");
  bytes_.resize(static_cast<std::size_t>(before.st_size));
  for (std::size_t done = 0; done < bytes_.size();) {
    const ssize_t got = ::read(descriptor.get(), bytes_.data() + done, bytes_.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) fail_incomplete();
    done += static_cast<std::size_t>(got);
  }
  struct stat after {};
  if (::fstat(descriptor.get(), &after) != 0 || !same_file(before, after)) fail("changed while it was read", "it is tried again when it changes");
  check();
}

void ElfFile::fail(const std::string& what, const std::string& advice) const { throw lumen::Error(file_.filename().string(), what, advice); }

void ElfFile::fail_incomplete() const { fail("is incomplete", "it is tried again when it changes"); }

bool ElfFile::holds(std::uint64_t offset, std::uint64_t size) const { return offset <= bytes_.size() && size <= bytes_.size() - offset; }

template <class T> T ElfFile::read(std::uint64_t offset) const {
  if (!holds(offset, sizeof(T))) fail_incomplete();
  T value;
  std::memcpy(&value, bytes_.data() + offset, sizeof value);
  return value;
}

template <class T> std::vector<T> ElfFile::table(std::uint64_t offset, std::uint64_t count) const {
  if (offset > bytes_.size() || count > (bytes_.size() - offset) / sizeof(T)) fail_incomplete();
  std::vector<T> values(count);
  if (count != 0) std::memcpy(values.data(), bytes_.data() + offset, count * sizeof(T));
  return values;
}

void ElfFile::check() const {
  const auto header = read<Elf64_Ehdr>(0);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) fail("is no shared library");
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_ident[EI_DATA] != ELFDATA2LSB || header.e_machine != machine) fail("is built for another machine");
  if (header.e_type != ET_DYN) fail("is no shared library");
  if (header.e_phentsize != sizeof(Elf64_Phdr) || header.e_shentsize != sizeof(Elf64_Shdr) || header.e_phnum == 0 || header.e_shnum == 0)
    fail_incomplete();

  const auto segments = table<Elf64_Phdr>(header.e_phoff, header.e_phnum);
  for (const Elf64_Phdr& segment : segments)
    if (segment.p_type != PT_NULL && !holds(segment.p_offset, segment.p_filesz)) fail_incomplete();
  // The linker writes the section table last in place: if it and all that it names is there, the file is whole.
  const auto sections = table<Elf64_Shdr>(header.e_shoff, header.e_shnum);
  bool loads = false;
  for (const Elf64_Phdr& segment : segments) loads = loads || segment.p_type == PT_DYNAMIC;
  for (const Elf64_Shdr& section : sections)
    if (section.sh_type != SHT_NULL && section.sh_type != SHT_NOBITS && !holds(section.sh_offset, section.sh_size))
      fail_incomplete();
  // A file of full length may still have zeros for an end: the names of the sections tell.
  if (header.e_shstrndx >= sections.size()) fail_incomplete();
  const Elf64_Shdr& names = sections[header.e_shstrndx];
  if (names.sh_type != SHT_STRTAB || names.sh_size < 2 || bytes_[names.sh_offset + 1] == std::byte(0)) fail_incomplete();
  if (!loads) fail("is no shared library");
}

std::vector<std::string> ElfFile::exports() const {
  const auto header = read<Elf64_Ehdr>(0);
  const auto sections = table<Elf64_Shdr>(header.e_shoff, header.e_shnum);
  std::vector<std::string> names;
  for (const Elf64_Shdr& section : sections) {
    if (section.sh_type != SHT_DYNSYM) continue;
    if (section.sh_link >= sections.size()) fail("has no names for its symbols");
    const Elf64_Shdr& strings = sections[section.sh_link];
    if (!holds(strings.sh_offset, strings.sh_size) || strings.sh_size == 0) fail("has no names for its symbols");
    const std::string text(reinterpret_cast<const char*>(bytes_.data()) + strings.sh_offset, strings.sh_size);
    for (const Elf64_Sym& symbol : table<Elf64_Sym>(section.sh_offset, section.sh_size / sizeof(Elf64_Sym))) {
      const int binding = ELF64_ST_BIND(symbol.st_info), visibility = ELF64_ST_VISIBILITY(symbol.st_other);
      const bool visible = visibility == STV_DEFAULT || visibility == STV_PROTECTED;
      if (symbol.st_shndx == SHN_UNDEF || symbol.st_shndx == SHN_ABS || binding == STB_LOCAL || !visible) continue;
      if (symbol.st_name < text.size()) names.emplace_back(text.c_str() + symbol.st_name);
    }
  }
  return names;
}

bool ElfFile::relocates_text() const {
  const auto header = read<Elf64_Ehdr>(0);
  for (const Elf64_Phdr& segment : table<Elf64_Phdr>(header.e_phoff, header.e_phnum)) {
    if (segment.p_type != PT_DYNAMIC) continue;
    for (const Elf64_Dyn& entry : table<Elf64_Dyn>(segment.p_offset, segment.p_filesz / sizeof(Elf64_Dyn)))
      if (entry.d_tag == DT_TEXTREL || (entry.d_tag == DT_FLAGS && (entry.d_un.d_val & DF_TEXTREL) != 0)) return true;
  }
  return false;
}

}  // namespace lumenshop
