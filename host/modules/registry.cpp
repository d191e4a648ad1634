#include "modules/registry.h"

#include <algorithm>
#include <set>

#include "modules/elf_file.h"
#include "modules/generation_folder.h"
#include "modules/handshake.h"
#include "modules/load_library.h"
#include "process/helper.h"

namespace lumenshop {

namespace {

const lumen::PluginType* find_type(const Module& module, std::string_view id) {
  const auto found = std::find_if(module.table->begin, module.table->end, [&](const lumen::PluginType& type) { return type.id == id; });
  return found == module.table->end ? nullptr : found;
}

std::shared_ptr<lumen::Plugin> create_from(const Module& module, const std::string& id, lumen::Binding& binding) {
  const lumen::PluginType* const type = find_type(module, id);
  if (!type) return nullptr;
  std::shared_ptr<lumen::Plugin> plugin;
  try {
    plugin.reset(type->create(binding));
  } catch (const lumen::Error&) {
    throw;
  } catch (const std::exception& error) {
    throw lumen::Error(id, std::string("its constructor threw: ") + error.what());
  } catch (...) {
    throw lumen::Error(id, "its constructor threw something that is no std::exception");
  }
  // The host goes from the kind to the class without a further check.
  if (!plugin || plugin->kind() != *kind_of(id)) throw lumen::Error(id, "its class is of another kind", "derive it from the kind's contract");
  return plugin;
}

/// The program's types with one library replaced by its candidate.
class Overlay final : public PluginFactory {
 public:
  Overlay(Registry& registry, const Module& candidate) : registry_(registry), candidate_(candidate) {
    for (std::string& type : registry.types_of(candidate)) types_.insert(std::move(type));
  }
  std::shared_ptr<lumen::Plugin> create(const std::string& type, lumen::Binding& binding) override {
    return types_.contains(type) ? create_from(candidate_, type, binding) : registry_.create(type, binding);
  }
  bool has(const std::string& type) const override { return types_.contains(type) || registry_.has(type); }
  int generation(const std::string& type) const override { return types_.contains(type) ? candidate_.generation : registry_.generation(type); }

 private:
  Registry& registry_;
  const Module& candidate_;
  std::set<std::string> types_;
};

std::vector<std::filesystem::path> libraries_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".so") files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Registry::Registry(std::vector<std::filesystem::path> folders, Helper* helper)
    : folders_(std::move(folders)), helper_(helper), copies_(std::make_unique<GenerationFolder>()) {}

Registry::~Registry() = default;

void Registry::load_all() {
  for (std::size_t index = 0; index < folders_.size(); ++index) {
    for (const std::filesystem::path& file : libraries_in(folders_[index])) {
      try {
        install(load(file, index > 0));
      } catch (const std::exception& error) {
        report(lumen::Severity::error, file, error.what());
      }
    }
  }
}

std::unique_ptr<Module> Registry::load(const std::filesystem::path& file, bool probe) {
  const std::string name = file.filename().string();
  const ElfFile elf(file);
  auto module = std::make_unique<Module>();
  module->file = file;
  module->loaded = copies_->write(file, elf.bytes());
  const Module* const before = newest(file);
  module->generation = before ? before->generation + 1 : 1;
  try {
    if (probe && helper_) {
      try {
        helper_->probe(module->loaded, 3);
      } catch (const lumen::Error& error) {
        // It speaks of the copy.
        const std::string text = error.what(), copy = module->loaded.filename().string() + ": ";
        throw lumen::Error(text.starts_with(copy) ? name + ": " + text.substr(copy.size()) : text);
      }
    }
    module->table = static_cast<const lumen::PluginTable*>(find_symbol(load_library(module->loaded, name), "lumen_plugins"));
    check_table(module->table, name);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(module->loaded, ignored);
    throw;
  }
  return module;
}

std::unique_ptr<Module> Registry::load_candidate(const std::filesystem::path& file) { return load(file, true); }

std::vector<std::string> Registry::types_of(const Module& module) const {
  std::vector<std::string> types;
  for (const lumen::PluginType* type = module.table->begin; type != module.table->end; ++type)
    if (takes(module, type->id)) types.emplace_back(type->id);
  return types;
}

std::unique_ptr<PluginFactory> Registry::with(const Module& candidate) { return std::make_unique<Overlay>(*this, candidate); }

void Registry::adopt(std::unique_ptr<Module> candidate) {
  if (const Module* const before = newest(candidate->file)) {
    // Mapped it stays; the file is of no use any more.
    std::error_code ignored;
    std::filesystem::remove(before->loaded, ignored);
  }
  install(std::move(candidate));
}

void Registry::install(std::unique_ptr<Module> module) {
  const std::string name = module->file.filename().string();
  problems_.erase(module->file);
  for (const auto& [type, owner] : current_)
    if (owner->file == module->file && !find_type(*module, type))
      report(lumen::Severity::warning, module->file,
             name + ": the type " + type + " is gone; generation " + std::to_string(owner->generation) + ", which has it, stays in use");
  for (const lumen::PluginType* type = module->table->begin; type != module->table->end; ++type) {
    const auto owner = current_.find(type->id);
    if (owner == current_.end() || owner->second->file == module->file) {
      current_[type->id] = module.get();
    } else if (takes(*module, type->id)) {
      report(lumen::Severity::note, module->file, std::string(type->id) + " is taken from " + module->file.string() + " instead of " + owner->second->file.string());
      owner->second = module.get();
    } else if (weight(owner->second->file) == weight(module->file)) {
      report(lumen::Severity::error, module->file,
             name + ": the type " + type->id + " is in " + owner->second->file.filename().string() + ", too; that one is used");
    }
  }
  modules_.push_back(std::move(module));
}

bool Registry::takes(const Module& module, const std::string& type) const {
  const auto owner = current_.find(type);
  return owner == current_.end() || owner->second->file == module.file || weight(module.file) > weight(owner->second->file);
}

std::size_t Registry::weight(const std::filesystem::path& file) const {
  const auto folder = std::find(folders_.rbegin(), folders_.rend(), file.parent_path());
  return static_cast<std::size_t>(folders_.rend() - folder);
}

const Module* Registry::newest(const std::filesystem::path& file) const {
  const auto found = std::find_if(modules_.rbegin(), modules_.rend(), [&](const std::unique_ptr<Module>& module) { return module->file == file; });
  return found == modules_.rend() ? nullptr : found->get();
}

std::vector<TypeInfo> Registry::types() const {
  std::vector<TypeInfo> types;
  for (const auto& [id, module] : current_) {
    const lumen::PluginType& type = *find_type(*module, id);
    types.push_back({id, type.doc, type.source, *kind_of(id), module->file, module->generation});
  }
  return types;
}

void Registry::report(lumen::Severity severity, const std::filesystem::path& file, const std::string& message) {
  lumen::Problem problem;
  problem.severity = severity;
  problem.file = file.string();
  problem.message = message;
  problems_[file].push_back(std::move(problem));
}

std::vector<lumen::Problem> Registry::problems() const {
  std::vector<lumen::Problem> all;
  for (const auto& [file, problems] : problems_) all.insert(all.end(), problems.begin(), problems.end());
  return all;
}

std::shared_ptr<lumen::Plugin> Registry::create(const std::string& type, lumen::Binding& binding) {
  const auto owner = current_.find(type);
  return owner == current_.end() ? nullptr : create_from(*owner->second, type, binding);
}

bool Registry::has(const std::string& type) const { return current_.contains(type); }

int Registry::generation(const std::string& type) const {
  const auto owner = current_.find(type);
  return owner == current_.end() ? 0 : owner->second->generation;
}

}  // namespace lumenshop
