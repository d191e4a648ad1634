/// The base of all plugins, and how a library presents its types to the host.
///
/// A plugin's complete state is its properties: the host may destroy it and build a newer generation of it from the same
/// values between any two frames. Keep everything else derivable, and build it when first needed.
///
/// Order of calls (all on the main thread): constructor - changed()* - the kind's functions - destructor. The GL context
/// is current in the kind's drawing functions, in released() and in the destructor, and nowhere else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <lumen/abi.h>
#include <lumen/error.h>
#include <lumen/layers.h>
#include <lumen/property.h>

namespace lumen {

enum class Kind {
  importer, exporter, filter, renderer, ambient, diffuse, specular, opacity,
  splitter, occlusion, transparency, compositor, interactor, editor, view
};
/// "importer" ... "view"; the part of a type id before the dot.
std::string_view name_of(Kind kind);

enum class Severity { note, warning, error };

/// The host's side of one instance. Plugins use it through Property and Plugin.
class Binding {
 public:
  virtual ~Binding() = default;
  virtual const std::string& id() const = 0;
  virtual int declare(PropertySpec spec) = 0;  ///< throws Error: id taken, ill-formed, or not fit for its type
  virtual void retract(int slot) = 0;
  virtual const PropertySpec& spec(int slot) const = 0;
  virtual const Value& read(int slot) const = 0;
  virtual void write(int slot, Value value) = 0;
  virtual void write_default(int slot, Value value) = 0;
  virtual bool is_set(int slot) const = 0;
  virtual std::uint64_t revision(int slot) const = 0;
  virtual void link(int slot, const std::string& source, const std::string& expression) = 0;
  virtual void unlink(int slot) = 0;
  virtual void observe(const std::string& property, int change) = 0;  ///< change: +1 begins, -1 ends
  virtual void report(Severity severity, const std::string& message) = 0;
};

class Plugin {
  // First: the properties below reach for it while they are constructed.
  Binding& binding_;
  std::vector<const Reads*> reads_;
  std::vector<const Writes*> writes_;

 public:
  explicit Plugin(Binding& binding);
  virtual ~Plugin();
  Plugin(const Plugin&) = delete;
  Plugin& operator=(const Plugin&) = delete;

  virtual Kind kind() const = 0;

  /// A property's value changed, or one that an Observer of this plugin watches ("other.radius"). Coalesced: at most
  /// once per property and frame, before the frame is drawn.
  virtual void changed(std::string_view property) { (void)property; }

  /// `enabled` went off: free what the GL holds; it is built again when next drawn.
  virtual void released() {}

  /// What it holds beside its layers and scratch textures: buffers, hierarchies. For comparisons.
  virtual std::size_t bytes() const { return 0; }

  Property<bool> enabled{this, "enabled", true, {.doc = "takes part in the picture; off frees its GPU memory and keeps its values"}};

  Binding& binding() const { return binding_; }
  const std::string& id() const { return binding_.id(); }
  /// Shows a line in Problems, until the next frame or job of this instance that does not report it.
  void report(Severity severity, const std::string& message) const { binding_.report(severity, message); }

  const std::vector<const Reads*>& reads() const { return reads_; }
  const std::vector<const Writes*>& writes() const { return writes_; }

 private:
  friend class Reads;
  friend class Writes;
};

/// While it lives, its owner's changed() hears of another instance's property.
class Observer {
 public:
  Observer(Plugin* owner, std::string property);  ///< "instance.property"; it may come to be later
  ~Observer();
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

 private:
  Plugin* owner_;
  std::string property_;
};

/// One type of a library.
struct PluginType {
  const char* id;                       ///< "<kind>.<name>"
  Plugin* (*create)(Binding& binding);  ///< may throw Error
  const char* doc;                      ///< what it is, and the paper it computes
  const char* source;                   ///< __FILE__ of its declaration, for "edit source"
};

/// What the host asks a library for, under the name `lumen_plugins`: the only symbol that it exports.
struct PluginTable {
  const char* abi;          ///< must equal the host's LUMEN_ABI
  const PluginType* begin;
  const PluginType* end;
};

}  // namespace lumen

/// The linker gathers the types of all files of a library between these two.
extern "C" {
[[gnu::visibility("hidden"), gnu::weak]] extern const lumen::PluginType __start_lumen_types[];
[[gnu::visibility("hidden"), gnu::weak]] extern const lumen::PluginType __stop_lumen_types[];
/// Emitted only where LUMEN_PLUGIN names it.
[[gnu::visibility("default")]] inline extern const lumen::PluginTable lumen_plugins = {LUMEN_ABI, __start_lumen_types, __stop_lumen_types};
}

/// Registers TYPE under ID, with a sentence on what it is and its paper: once per type, at file scope.
#define LUMEN_PLUGIN(TYPE, ID, DOC)                                                                                \
  [[gnu::used]] static const ::lumen::PluginTable* const lumen_table_##TYPE = &lumen_plugins;                      \
  [[gnu::used, gnu::section("lumen_types")]] static const ::lumen::PluginType lumen_type_##TYPE = {                \
      ID, [](::lumen::Binding& binding) -> ::lumen::Plugin* { return new TYPE(binding); }, DOC, __FILE__};
