/// The properties that one plugin object declared, with their values: what the object is bound to.
///
/// Each object has a table of its own, so that two generations of a plugin can be alive side by side during a reload.
/// A closed table answers reads with its last values and ignores all else: an object may outlive its place in the
/// session (a job may hold it), and may then even be destroyed on another thread.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <lumen/editor.h>
#include <lumen/plugin.h>

#include "model/slot.h"

namespace lumenshop {

class Session;

class PropertyTable final : public lumen::Binding {
 public:
  /// `kept`: an object, property -> JSON as in the session, that declared properties take from.
  PropertyTable(Session& session, Instance& owner, Json kept);
  ~PropertyTable() override;

  /// The table of the object that this one's replaces: values of the same property go over, converted where types differ.
  void inherit(PropertyTable& predecessor) { predecessor_ = &predecessor; }
  void constructed();                            ///< the object is complete: from now on its writes count as a person's
  void close() { closed_ = true; }               ///< touches nothing: the instance may be gone already
  void rename(const std::string& id) { id_ = id; }

  const std::vector<std::unique_ptr<Slot>>& slots() const { return slots_; }
  int slot_of(std::string_view property) const;  ///< -1 if not declared now
  const Json& kept() const { return kept_; }     ///< what nothing declares

  // Without following links and without undo.
  void assign(Slot& slot, lumen::Value value, bool relative = false);
  void clear(Slot& slot);                        ///< un-sets it: no value, no link, nothing unresolved
  void connect(Slot& slot, Link link);
  void disconnect(Slot& slot);                   ///< keeps the current value
  void adopt(Slot& slot, lumen::DataPointer data, std::string state);

  /// A property as the session file has it; null = not set. Paths relative to `folder` where they belong there.
  Json json(const Slot& slot, const std::filesystem::path& folder) const;
  /// Takes what a file or an undo step has; null un-sets. What does not fit becomes `unresolved` and an error. Never throws.
  void restore(const std::string& property, const Json& json, const std::filesystem::path& folder);
  /// All that is set, declared or not, in order of declaration.
  void write_json(Json& object, const std::filesystem::path& folder) const;

  /// One watched property of another instance.
  struct Watch {
    int count = 0;
    std::uint64_t seen = 0;                      ///< its revision when the object last heard; 0 = it was not there
  };
  std::map<std::string, Watch>& watches() { return watches_; }
  const std::vector<lumen::Problem>& reports() const { return reports_; }
  void clear_reports() { reports_.clear(); }
  const std::vector<std::string>& conversions() const { return conversions_; }  ///< what inherit() had to change

  // lumen::Binding
  const std::string& id() const override { return id_; }
  int declare(lumen::PropertySpec spec) override;
  void retract(int slot) override;
  const lumen::PropertySpec& spec(int slot) const override { return slots_[slot]->spec; }
  const lumen::Value& read(int slot) const override;
  void write(int slot, lumen::Value value) override;
  void write_default(int slot, lumen::Value value) override;
  bool is_set(int slot) const override;
  std::uint64_t revision(int slot) const override;
  void link(int slot, const std::string& source, const std::string& expression) override;
  void unlink(int slot) override;
  void observe(const std::string& property, int change) override;
  void report(lumen::Severity severity, const std::string& message) override;

 private:
  Session* session_;
  Instance* owner_;
  PropertyTable* predecessor_ = nullptr;
  bool constructing_ = true, closed_ = false;
  std::string id_;                               ///< its own: a closed table outlives the instance
  std::vector<std::unique_ptr<Slot>> slots_;
  std::map<std::string, int, std::less<>> slot_by_id_;
  Json kept_;
  std::map<std::string, Watch> watches_;
  std::vector<lumen::Problem> reports_;
  std::vector<std::string> conversions_;

  void show(Slot& slot, const lumen::Value& value);  ///< makes it effective
  void apply(Slot& slot, const Json& json, const std::filesystem::path& folder);
  void inherit_value(Slot& slot, Slot& old);
  void forget_kept(const std::string& property);
};

}  // namespace lumenshop
