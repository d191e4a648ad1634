/// One plugin (or view) of a session: its id, its type, its values, and the live object if its library is there.
///
/// The values belong to the instance; the object is replaceable. What nothing declares is kept as orphans.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <lumen/editor.h>
#include <lumen/plugin.h>

#include "model/json_value.h"
#include "model/link.h"

namespace lumenshop {

class Session;

/// One declared property and what it holds.
struct Slot {
  lumen::PropertySpec spec;
  lumen::Value own;                 ///< set value, or the default
  bool set = false;
  bool retracted = false;           ///< a run-time property whose object is gone
  std::unique_ptr<Link> link;       ///< null = a value of its own
  Json unresolved;                  ///< JSON that was given but does not fit; saved again as it is; null = none
  std::string error;                ///< why; shown at the property
  std::string data_state = "pending";  ///< outputs: "pending", "ready", or why it failed

  mutable lumen::Value effective;   ///< what read() gives
  mutable std::uint64_t revision = 1;
};

class Instance final : public lumen::Binding {
 public:
  Instance(Session& session, std::string id, std::string type);
  ~Instance() override;

  const std::string& type() const { return type_; }
  lumen::Kind kind() const;                      ///< from the type id
  lumen::Plugin* plugin() const { return plugin_.get(); }
  std::shared_ptr<lumen::Plugin> share() const { return plugin_; }
  /// The object as one of its kind's contract; null if it is absent or of another kind.
  template <class T> T* as(lumen::Kind kind) const { return plugin_ && plugin_->kind() == kind ? static_cast<T*>(plugin_.get()) : nullptr; }
  bool enabled() const;
  int generation() const { return generation_; }
  int number() const;                            ///< 1.. in session order (layer id); views 0

  const std::vector<std::unique_ptr<Slot>>& slots() const { return slots_; }
  int slot_of(std::string_view property) const;  ///< -1 if not declared
  const Json& orphans() const { return orphans_; }  ///< an object: property -> JSON

  /// Grows when a property that affects drawing (shading) changes its effective value, and when the object is replaced.
  std::uint64_t draw_revision() const;
  std::uint64_t shading_revision() const;

  /// Problems that the object reported, or that its values have.
  std::vector<lumen::Problem> problems() const;
  void clear_reports();

  // lumen::Binding
  const std::string& id() const override { return id_; }
  int declare(lumen::PropertySpec spec) override;
  void retract(int slot) override;
  const lumen::PropertySpec& spec(int slot) const override;
  const lumen::Value& read(int slot) const override;
  void write(int slot, lumen::Value value) override;
  void write_default(int slot, lumen::Value value) override;
  bool is_set(int slot) const override;
  std::uint64_t revision(int slot) const override;
  void link(int slot, const std::string& source, const std::string& expression) override;
  void unlink(int slot) override;
  void observe(const std::string& property, int change) override;
  void report(lumen::Severity severity, const std::string& message) override;

  /// Adopts a job's result (outputs only).
  void adopt(int slot, lumen::DataPointer data, std::string state);

 private:
  friend class Session;
  friend class Rebuild;
  Session& session_;
  std::string id_, type_;
  std::shared_ptr<lumen::Plugin> plugin_;
  int generation_ = 0;
  std::vector<std::unique_ptr<Slot>> slots_;
  std::map<std::string, int, std::less<>> slot_by_id_;
  Json orphans_ = Json::object();
  std::map<std::string, int> observed_;
  std::vector<lumen::Problem> reports_;
  std::uint64_t replaced_ = 1;
};

}  // namespace lumenshop
