/// An open session: instances, views, links, problems, undo.
///
/// Thread: main. Input is bounded: file 64 MiB, depth 64, 4096 instances, 65536 entries per list.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <lumen/editor.h>

#include "model/history.h"
#include "model/instance.h"
#include "model/plugin_factory.h"

namespace lumenshop {

class Session {
 public:
  explicit Session(PluginFactory& factory);
  ~Session();

  /// Replaces everything. Throws lumen::Error (file:line: what) if it is no regular file, no JSON or no session; then the
  /// old contents stay. What merely does not fit (unknown plugins, properties, wrong types, cycles) loads as far as it
  /// can, is kept verbatim and becomes a problem.
  void load(const std::filesystem::path& file);
  void load(const Json& json, const std::filesystem::path& folder);
  /// Atomically: a temporary file beside it, synced, renamed.
  void save(const std::filesystem::path& file);
  Json to_json() const;
  /// A session for data files alone, with the ids data, surface, camera, front, back, main (data2, surface2 ... for more).
  void load_data(const std::vector<std::filesystem::path>& files, const std::function<std::string(const std::filesystem::path&)>& importer_of);

  const std::filesystem::path& file() const { return file_; }    ///< empty = never saved
  const std::filesystem::path& folder() const { return folder_; }  ///< relative paths start here
  const std::string& title() const { return title_; }
  bool modified() const;                                           ///< since load or save
  const Json& layout() const { return layout_; }

  const std::vector<std::unique_ptr<Instance>>& plugins() const { return plugins_; }  ///< session order
  const std::vector<std::unique_ptr<Instance>>& views() const { return views_; }
  Instance* find(std::string_view id) const;                       ///< plugins and views; null if there is none
  /// The instance and slot of "instance.property". Throws lumen::Error naming what is missing, with the nearest name.
  std::pair<Instance*, int> resolve(std::string_view path) const;

  // Edits: each is an undo step unless inside begin_edit .. end_edit, which make one.
  Instance& add(const std::string& type, std::string id = {});     ///< an id from the type's name if empty; throws lumen::Error
  void remove(const std::string& id);
  void rename(const std::string& id, const std::string& to);       ///< links and references follow
  void set(const std::string& path, const Json& json);             ///< a value or {"link": ...}; throws lumen::Error
  void set(const std::string& path, lumen::Value value);           ///< through an identity link: sets the source
  void reset(const std::string& path);
  void link(const std::string& path, const std::string& source, const std::string& expression = {});  ///< throws lumen::Error
  void unlink(const std::string& path);
  std::vector<std::string> linkable(const std::string& path) const;
  History& history() { return history_; }
  void begin_edit();
  void end_edit();
  void cancel_edit();

  /// --set on the command line: `json_or_text` relative to the working directory; is not undone, is not saved as relative.
  void override_value(const std::string& path, const std::string& json_or_text);

  /// Once per frame, before drawing: brings links up to date and calls changed() and released(), coalesced.
  void update();
  std::uint64_t revision() const { return revision_; }             ///< grows with every change of anything
  std::vector<lumen::Problem> problems() const;
  void report(lumen::Problem problem);                             ///< of the session itself

  /// What a panel sees of a property.
  lumen::PropertyState state(const Instance& instance, int slot) const;

 private:
  friend class Instance;
  friend class Rebuild;
  friend class History;
  PluginFactory& factory_;
  std::filesystem::path file_, folder_;
  std::string title_;
  Json layout_, extra_;                                            ///< extra_: top-level keys that we do not know
  std::vector<std::unique_ptr<Instance>> plugins_, views_;
  std::vector<lumen::Problem> problems_;
  History history_;
  std::uint64_t revision_ = 1, saved_revision_ = 1;
};

/// New objects for some instances, from the same values: built aside, swapped in, taken back if the first frame fails.
class Rebuild {
 public:
  /// Builds new objects (from `factory`) of the instances whose type is in `types`. Throws lumen::Error if a constructor did;
  /// then nothing has changed.
  Rebuild(Session& session, PluginFactory& factory, const std::vector<std::string>& types);
  ~Rebuild();          ///< reverts if neither was called
  void swap();         ///< the new ones are in the session now
  void keep();         ///< the old objects go; reports converted values
  void revert();       ///< the old ones are back, with their values

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumenshop
