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
#include "model/property_table.h"
#include "model/slot.h"

namespace lumenshop {

class PluginFactory;
class Session;

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
  /// For the first of the pictures that draw it, until it lets go of it; null for the others.
  std::shared_ptr<const void> take_lead();
  int number() const { return number_; }         ///< 1.. in session order (layer id); views 0

  const std::vector<std::unique_ptr<Slot>>& slots() const { return table_->slots(); }  ///< retracted ones, too
  int slot_of(std::string_view property) const { return table_->slot_of(property); }   ///< -1 if not declared
  const Json& orphans() const { return table_->kept(); }  ///< an object: property -> JSON

  /// Grows when a property that affects drawing (shading) changes its effective value, and when the object is replaced.
  std::uint64_t draw_revision() const;
  std::uint64_t shading_revision() const;

  /// Problems that the object reported, or that its values have.
  std::vector<lumen::Problem> problems() const;
  void clear_reports() { table_->clear_reports(); }

  // lumen::Binding: that of the current object, whose own binding is its table.
  const std::string& id() const override { return id_; }
  int declare(lumen::PropertySpec spec) override { return table_->declare(std::move(spec)); }
  void retract(int slot) override { table_->retract(slot); }
  const lumen::PropertySpec& spec(int slot) const override { return table_->spec(slot); }
  const lumen::Value& read(int slot) const override { return table_->read(slot); }
  void write(int slot, lumen::Value value) override { table_->write(slot, std::move(value)); }
  void write_default(int slot, lumen::Value value) override { table_->write_default(slot, std::move(value)); }
  bool is_set(int slot) const override { return table_->is_set(slot); }
  std::uint64_t revision(int slot) const override { return table_->revision(slot); }
  void link(int slot, const std::string& source, const std::string& expression) override { table_->link(slot, source, expression); }
  void unlink(int slot) override { table_->unlink(slot); }
  void observe(const std::string& property, int change) override { table_->observe(property, change); }
  void report(lumen::Severity severity, const std::string& message) override { table_->report(severity, message); }

  /// Adopts a job's result (outputs only).
  void adopt(int slot, lumen::DataPointer data, std::string state);

 private:
  friend class LinkGraph;
  friend class PropertyTable;
  friend class Session;
  friend class Rebuild;

  /// An object and its table. The object keeps its table alive, whoever holds it.
  struct Object {
    std::shared_ptr<PropertyTable> table;
    std::shared_ptr<lumen::Plugin> plugin;
    int generation = 0;
  };
  /// Builds an object beside the current one. Null plugin if the factory lacks the type. Throws lumen::Error.
  Object build(PluginFactory& factory, Json kept, PropertyTable* predecessor);
  /// The current object becomes `object` and the other way round; revisions go on growing.
  void exchange(Object& object);
  /// Builds and takes it; a constructor that throws leaves the values as they are and becomes a problem.
  void create(PluginFactory& factory, Json kept);

  Session& session_;
  std::string id_, type_;
  std::shared_ptr<PropertyTable> table_;
  std::shared_ptr<lumen::Plugin> plugin_;
  int generation_ = 0, number_ = 0;
  std::weak_ptr<const void> lead_;
  bool was_enabled_ = true;                             ///< at the last update
  std::string failure_;                                 ///< why the object could not be made
  std::map<std::string, std::string> change_failures_;  ///< property -> what changed() threw
  std::uint64_t replaced_ = 1;
  struct Revisions { std::uint64_t values = 0, draw = 0, shading = 0; };
  mutable Revisions revisions_;                         ///< as of the graph's values
  const Revisions& revisions() const;
};

}  // namespace lumenshop
