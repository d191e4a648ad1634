#include "frame/shader_library.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <lumen/error.h>

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
  return found == files_.end() ? 0 : found->second.revision + lib_changes_;
}

std::shared_ptr<Program> ShaderLibrary::program(const std::string& slot, const std::string& vertex, const std::string& fragment,
                                                const std::vector<std::string>& files) {
  Slot& at = slots_[slot];
  const std::string text = vertex + '\0' + fragment;
  std::weak_ptr<Program>& known = programs_[text];
  if (auto program = known.lock()) {
    at.problems.clear();
    return at.good = std::move(program);
  }
  auto program = std::make_shared<Program>(vertex, fragment);
  if (program->ok()) {
    known = program;
    at.problems.clear();
    return at.good = std::move(program);
  }
  programs_.erase(text);
  at.problems.clear();
  for (const CompilerMessage& message : program->messages()) {
    lumen::Problem problem{.severity = lumen::Severity::error, .line = message.line, .column = message.column, .message = message.text};
    if (message.file > 0 && std::size_t(message.file) <= files.size()) {
      const std::string& name = files[std::size_t(message.file) - 1];
      const fs::path path = find(name);
      problem.file = path.empty() ? name : path.string();
    } else {
      problem.message = slot + ": " + message.text;
      problem.line = problem.column = 0;
    }
    if (std::find(at.problems.begin(), at.problems.end(), problem) == at.problems.end()) at.problems.push_back(std::move(problem));
  }
  return at.good;
}

std::shared_ptr<Program> ShaderLibrary::last_good(const std::string& slot, const lumen::Problem& reason) {
  Slot& at = slots_[slot];
  at.problems = {reason};
  return at.good;
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
