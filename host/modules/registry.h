/// The plugins' libraries that the program knows, in generations, and the types that they have.
///
/// A library comes in only whole: complete file -> copied to a name of its own -> probed in the helper process -> loaded
/// -> handshake. Old generations stay mapped: unloading C++ is unsafe (unique symbols, thread-local objects, stray pointers).
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <lumen/editor.h>

#include "model/plugin_factory.h"

namespace lumenshop {

class GenerationFolder;
class Helper;

/// One loaded generation of a library.
struct Module {
  std::filesystem::path file;       ///< the file that is watched
  std::filesystem::path loaded;     ///< the private copy
  int generation = 1;
  const lumen::PluginTable* table = nullptr;
};

/// What describe and the outline know of a type.
struct TypeInfo {
  std::string id, doc, source;
  lumen::Kind kind;
  std::filesystem::path library;
  int generation = 1;
};

/// A later folder's type overrides an earlier one's, with a note. Within a folder the first library (by name) keeps it.
class Registry final : public PluginFactory {
 public:
  /// The first folder is the installation's. `helper` probes new generations and what comes from the other folders; null: no
  /// probe (the first start trusts the installation).
  Registry(std::vector<std::filesystem::path> folders, Helper* helper);
  ~Registry() override;

  /// Loads every *.so of the folders. What fails becomes a problem; the rest loads.
  void load_all();
  std::vector<TypeInfo> types() const;          ///< sorted by id
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  std::vector<lumen::Problem> problems() const;

  /// Loads the file's current contents as a candidate, without letting create() use it. Throws lumen::Error: truncated,
  /// crashed in its probe, wrong handshake ...
  std::unique_ptr<Module> load_candidate(const std::filesystem::path& file);
  /// The types that the module gives the program: all of its own that no library of more weight has. Sorted as in its table.
  std::vector<std::string> types_of(const Module& module) const;
  /// A factory that makes the candidate's types from it and all others as before.
  std::unique_ptr<PluginFactory> with(const Module& candidate);
  void adopt(std::unique_ptr<Module> candidate);

  // PluginFactory
  std::shared_ptr<lumen::Plugin> create(const std::string& type, lumen::Binding& binding) override;
  bool has(const std::string& type) const override;
  int generation(const std::string& type) const override;

 private:
  std::unique_ptr<Module> load(const std::filesystem::path& file, bool probe);
  void install(std::unique_ptr<Module> module);
  bool takes(const Module& module, const std::string& type) const;
  std::size_t weight(const std::filesystem::path& file) const;
  const Module* newest(const std::filesystem::path& file) const;
  void report(lumen::Severity severity, const std::filesystem::path& file, const std::string& message);

  std::vector<std::filesystem::path> folders_;
  Helper* helper_;
  std::unique_ptr<GenerationFolder> copies_;
  std::vector<std::unique_ptr<Module>> modules_;             ///< all generations, oldest first; never unmapped
  std::map<std::string, const Module*, std::less<>> current_;  ///< type id -> module
  std::map<std::filesystem::path, std::vector<lumen::Problem>> problems_;  ///< by library, until a generation of it is well
};

}  // namespace lumenshop
