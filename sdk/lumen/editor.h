/// Editors: a Dear ImGui panel over properties. The SDK's library holds the one ImGui context that all share.
#pragma once

#include <memory>
#include <optional>

#include <lumen/image.h>
#include <lumen/plugin.h>

namespace lumen {

/// A property as a panel sees it.
struct PropertyState {
  PropertySpec spec;
  Value value;                   ///< through links
  bool set = false;
  std::string link;              ///< "instance.property" or empty
  std::string expression;        ///< of a link; empty = identity
  std::string error;             ///< why a link or value does not hold; empty = well
  std::string no_effect;         ///< why it has no effect now; empty = it has
  std::string data_state;        ///< data: "ready", "pending", or why it failed
};

struct InstanceState {
  std::string id, type;
  Kind kind = Kind::view;
  bool camera = false, light = false;  ///< interactors: what they can be to a view
  bool known = true;             ///< false: its plugin is not there; kept as it is
  bool enabled = true;
  int generation = 0;            ///< which build of its library it runs
  std::string badge;             ///< "building", "loaded", "kept 4" or empty
  std::string summary;           ///< "1,200,000 triangles"
  std::string doc, source;       ///< of its type
  std::vector<std::string> orphans;  ///< kept values that nothing declares, as "name: JSON"
};

/// What can be added to a session.
struct TypeState {
  std::string id, doc;
  Kind kind = Kind::view;
  bool camera = false, light = false;  ///< interactors: what they can be to a view
};

struct Problem {
  Severity severity = Severity::error;
  std::string instance;          ///< or empty
  std::string file;              ///< or empty
  int line = 0, column = 0;      ///< from 1; 0 = none
  std::string message;
  bool operator==(const Problem&) const = default;
};

/// A view drawn with another occlusion or transparency than its own, aside from the window, to compare techniques: step by
/// step, so that the window lives on. Thread: main, in Editor::draw.
class Trial {
 public:
  virtual ~Trial() = default;
  virtual bool step() = 0;                                             ///< one refinement; false once it is finished
  virtual float progress() const = 0;                                  ///< 0..1
  virtual std::shared_ptr<const Image> layer(const std::string& name) = 0;  ///< float channels, rows top-down; throws Error
  virtual double milliseconds() const = 0;                             ///< of the technique's own passes, all refinements together
  virtual std::size_t bytes() const = 0;                               ///< that the technique holds for the view
};

/// The open session, for panels. All changes can be undone. Thread: main.
class Workbench {
 public:
  virtual ~Workbench() = default;
  virtual std::vector<InstanceState> instances() const = 0;            ///< session order; views first
  virtual std::vector<PropertyState> properties(const std::string& instance) const = 0;
  virtual std::optional<PropertyState> property(const std::string& path) const = 0;  ///< "instance.property"

  /// Sets a value. Calls with the same property between begin_edit and end_edit are one undo step.
  virtual void set(const std::string& path, Value value) = 0;
  virtual void reset(const std::string& path) = 0;
  virtual void begin_edit() = 0;
  virtual void end_edit() = 0;
  virtual void cancel_edit() = 0;                                      ///< back to the values at begin_edit
  virtual void link(const std::string& path, const std::string& source, const std::string& expression) = 0;  ///< throws Error
  virtual void unlink(const std::string& path) = 0;
  virtual std::vector<std::string> linkable(const std::string& path) const = 0;  ///< sources that convert and do not cycle
  virtual std::string to_json(const Value& value) const = 0;
  virtual Value from_json(const std::string& path, const std::string& json) const = 0;  ///< throws Error

  /// Draws the view with `instance` (an occlusion or a transparency) in its place. Throws Error.
  virtual std::unique_ptr<Trial> trial(const std::string& view, const std::string& instance, const std::vector<std::string>& layers) = 0;

  virtual std::string selection() const = 0;                           ///< an instance's id or empty
  virtual void select(const std::string& instance) = 0;
  virtual std::vector<Problem> problems() const = 0;
  virtual void open_source(const std::string& file, int line) = 0;     ///< in $VISUAL
  virtual std::vector<TypeState> types() const = 0;                    ///< that are installed, by id
  /// Adds an instance of a type, with values as a session file has them: a JSON object. Its id. Throws Error; then nothing came.
  virtual std::string add(const std::string& type, const std::string& properties = "{}") = 0;
  /// What the view shows at a point of the window, in ImGui's pixels: an instance's id, or empty.
  virtual std::string instance_at(glm::vec2 point) = 0;
  /// The picture that an importer of this type makes of these values, in no session: null while it is being made, then
  /// handed over once. Throws Error: why there is none.
  virtual std::shared_ptr<const Image> picture(const std::string& type, const std::string& properties) = 0;
  /// The folder of a person's own materials, pictures of spheres; it may not be there yet.
  virtual std::string gallery() const = 0;
  /// Renders a surface's look on a sphere into that folder; the new file. Throws Error. The GL context must be current.
  virtual std::string capture(const std::string& surface) = 0;

  virtual float scale() const = 0;                                     ///< pixels per UI unit
  virtual bool reduced_motion() const = 0;
};

class Editor : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::editor; }
  virtual std::string title() const = 0;
  /// Fills the panel's window, which is already begun.
  virtual void draw(Workbench& workbench) = 0;
};

}  // namespace lumen
