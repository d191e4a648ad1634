/// An open session: instances, views, links, problems, undo.
///
/// Thread: main. Input is bounded: file 64 MiB, depth 64, 4096 instances, 65536 entries per list.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <lumen/editor.h>

#include "model/history.h"
#include "model/instance.h"
#include "model/link_graph.h"
#include "model/plugin_factory.h"

namespace lumenshop {

class Session {
 public:
  explicit Session(PluginFactory& factory);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

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

  const std::filesystem::path& file() const { return contents_.file; }    ///< empty = never saved
  const std::filesystem::path& folder() const { return contents_.folder; }  ///< relative paths start here
  const std::string& title() const { return contents_.title; }
  bool modified() const { return document_revision_ != saved_revision_; }  ///< since load or save
  const Json& layout() const { return contents_.layout; }

  const std::vector<std::unique_ptr<Instance>>& plugins() const { return contents_.plugins; }  ///< session order
  const std::vector<std::unique_ptr<Instance>>& views() const { return contents_.views; }
  Instance* find(std::string_view id) const;                       ///< plugins and views; null if there is none
  /// The instance and slot of "instance.property". Throws lumen::Error naming what is missing, with the nearest name.
  std::pair<Instance*, int> resolve(std::string_view path) const;

  // Edits: each is an undo step unless inside begin_edit .. end_edit, which make one.
  Instance& add(const std::string& type, std::string id = {});     ///< an id from the type's name if empty; throws lumen::Error
  void remove(const std::string& id);
  void rename(const std::string& id, const std::string& to);       ///< links and references follow
  void set(const std::string& path, const Json& json);             ///< a value or {"link": ...}; throws lumen::Error
  void set(const std::string& path, lumen::Value value);           ///< through an identity link: sets the source
  /// The same of a plain value: 0.5f, glm::vec3 ...
  template <class T> requires requires { lumen::detail::Traits<T>::type; }
  void set(const std::string& path, T value) { set(path, lumen::Value(std::move(value))); }
  void reset(const std::string& path);                             ///< un-sets it, its link too; of an orphan: forgets it
  void link(const std::string& path, const std::string& source, const std::string& expression = {});  ///< throws lumen::Error
  void unlink(const std::string& path);
  std::vector<std::string> linkable(const std::string& path) const;
  History& history() { return history_; }
  void begin_edit() { history_.begin(); }
  void end_edit() { history_.end(); }
  void cancel_edit() { history_.cancel(); }

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
  friend class PropertyTable;
  friend class Rebuild;
  friend class History;

  /// All that a file brings: replaced as a whole, or not at all.
  struct Contents {
    std::filesystem::path file, folder;
    std::string title;
    Json layout, extra = Json::object();         ///< extra: top-level keys that we do not know
    Json kept_plugins = Json::object(), kept_views = Json::object();  ///< entries that make no instance
    std::vector<std::unique_ptr<Instance>> plugins, views;
    std::map<std::string, Instance*, std::less<>> by_id;
    std::vector<lumen::Problem> problems;
  };

  PluginFactory& factory_;
  LinkGraph graph_{*this};
  History history_{*this};
  Contents contents_;
  std::uint64_t revision_ = 1, document_revision_ = 1, saved_revision_ = 1;
  std::uint64_t updated_ = 0;                    ///< the graph's values at the last update
  int quiet_ = 0;                                ///< > 0: changes are no undo steps
  std::string restless_;                         ///< which properties keep changing; empty = none

  // What tables and instances tell.
  void something_changed() { ++revision_; }
  void value_changed() { ++revision_, graph_.value_changed(); }
  void structure_changed() { ++revision_, graph_.structure_changed(); }
  std::uint64_t revision_of(std::string_view path) const;          ///< 0 = not there

  // Edits of slots; `by_object`: an object wrote, not a person.
  void write(Slot& slot, lumen::Value value, bool by_object);
  void link(Slot& slot, const std::string& source, const std::string& expression, bool by_object);
  void unlink(Slot& slot, bool by_object);
  void edit(Slot& slot, bool by_object, const std::function<void(PropertyTable&)>& change);
  Slot& slot_at(std::string_view path) const;

  // Structure without undo; `replay` takes a recorded change forward or back.
  Instance& insert(const std::string& id, const Json& json, int position, const std::filesystem::path& folder);
  Instance& place(const std::string& id, const std::string& type, int position);
  void erase(Instance& instance);
  void give_id(Instance& instance, const std::string& to);
  void replay(const Change& change, bool forward);
  void record(Change change);
  int position_of(const Instance& instance) const;
  void renumber();
  void check_free(const std::string& id) const;
  Json json_of(const Instance& instance) const;                    ///< with its "type"

  // Files.
  Json to_json(const std::filesystem::path& folder) const;
  void replace(Json json, std::filesystem::path file, std::filesystem::path folder, const std::string& name);
  void fill(const Json& json);
  void fill_entries(const Json& entries, bool views, Json& kept, std::vector<std::pair<Instance*, const Json*>>& placed);

  // State.
  std::string error_of(const Slot& slot) const;
  std::string reference_error(const Slot& slot) const;
  std::string no_effect(const Instance& instance, const Slot& slot) const;
  struct Notice;
  std::vector<Notice> pending_notices();
  void deliver(const Notice& notice);
};

/// New objects for some instances, from the same values: built aside, swapped in, taken back if the first frame fails.
class Rebuild {
 public:
  /// Builds new objects (from `factory`) of the instances whose type is in `types`. Throws lumen::Error if a constructor did;
  /// then nothing has changed.
  Rebuild(Session& session, PluginFactory& factory, const std::vector<std::string>& types);
  ~Rebuild();          ///< reverts if neither was called
  Rebuild(const Rebuild&) = delete;
  Rebuild& operator=(const Rebuild&) = delete;
  void swap();         ///< the new ones are in the session now
  void keep();         ///< the old objects go; reports converted values
  void revert();       ///< the old ones are back, with their values

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumenshop
