#include "frame/shader_library.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <lumen/error.h>

#include "frame/hash.h"
#include "frame/program_text.h"

namespace lumenshop {
namespace fs = std::filesystem;

ShaderLibrary::ShaderLibrary(std::vector<fs::path> folders) : folders_(std::move(folders)) {
  std::reverse(folders_.begin(), folders_.end());
}

fs::path ShaderLibrary::find(const std::string& name) const {
  for (const fs::path& folder : folders_) {
    std::error_code ignored;
    const fs::path path = folder / name;
    if (fs::is_regular_file(path, ignored)) return path;
  }
  return {};
}

bool ShaderLibrary::exists(const std::string& name) { return !find(name).empty(); }

const GlslFile& ShaderLibrary::file(const std::string& name) {
  Entry& entry = files_[name];
  if (entry.file) return *entry.file;
  const fs::path path = find(name);
  if (path.empty()) throw lumen::Error(name, "no such shader file in the shader folders");
  std::error_code error;
  constexpr std::uintmax_t limit = 1 << 20;
  if (fs::file_size(path, error) > limit || error) throw lumen::Error(path.string(), "a shader file has at most 1 MiB");
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw lumen::Error(path.string(), "cannot be read");
  entry.file = std::make_unique<GlslFile>(name, std::move(text).str());
  return *entry.file;
}

std::uint64_t ShaderLibrary::revision(const std::string& name) {
  const auto found = files_.find(name);
  return (found == files_.end() ? 1 : found->second.revision) + lib_changes_;
}

Program* ShaderLibrary::program(const std::string& slot, std::uint64_t signature,
                                const std::function<void(ProgramText&, ProgramText&)>& assemble) {
  Slot& at = slots_[slot];
  const std::uint64_t wanted = Hash().add(signature).add(changes_).value();
  if (at.signature == wanted) return at.good.get();
  at.signature = wanted;
  at.problems.clear();
  FileNumbers numbers;
  try {
    ProgramText vertex(*this, GlslFile::Stage::vertex, numbers), fragment(*this, GlslFile::Stage::fragment, numbers);
    assemble(vertex, fragment);
    const std::string text = vertex.text() + '\0' + fragment.text();
    std::weak_ptr<Program>& known = programs_[text];
    auto program = known.lock();
    if (!program) known = program = std::make_shared<Program>(vertex.text(), fragment.text());
    if (program->ok()) {
      at.good = std::move(program);
    } else {
      for (const CompilerMessage& message : program->messages()) {
        lumen::Problem problem = located(slot, message, numbers);
        if (std::find(at.problems.begin(), at.problems.end(), problem) == at.problems.end()) at.problems.push_back(std::move(problem));
      }
    }
  } catch (const lumen::Error& error) {
    lumen::Problem problem;
    problem.message = error.what();
    at.problems.push_back(std::move(problem));
  }
  std::erase_if(programs_, [](const auto& entry) { return entry.second.expired(); });
  return at.good.get();
}

lumen::Problem ShaderLibrary::located(const std::string& slot, const CompilerMessage& message, const FileNumbers& files) const {
  lumen::Problem problem;
  problem.message = message.text;
  if (message.file > 0 && std::size_t(message.file) <= files.size()) {
    const std::string& name = files[std::size_t(message.file) - 1];
    const fs::path path = find(name);
    problem.file = path.empty() ? name : path.string();
    problem.line = message.line;
    problem.column = message.column;
  } else {
    problem.message = slot + ": " + message.text;
  }
  return problem;
}

void ShaderLibrary::changed(const std::vector<fs::path>& files) {
  bool any = false;
  for (const fs::path& path : files) {
    for (const fs::path& folder : folders_) {
      std::error_code error;
      const std::string name = fs::weakly_canonical(path, error).lexically_relative(fs::weakly_canonical(folder, error)).generic_string();
      if (name.empty() || name.starts_with("..") || !name.ends_with(".glsl")) continue;
      Entry& entry = files_[name];
      entry.file.reset();
      ++entry.revision;
      any = true;
      if (name.starts_with("lib/") || name.starts_with("host/")) ++lib_changes_;
    }
  }
  if (any) ++changes_;
}

std::vector<lumen::Problem> ShaderLibrary::problems() const {
  std::vector<lumen::Problem> all;
  for (const auto& [slot, at] : slots_)
    for (const lumen::Problem& problem : at.problems)
      if (std::find(all.begin(), all.end(), problem) == all.end()) all.push_back(problem);
  return all;
}

}  // namespace lumenshop
