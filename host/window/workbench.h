/// The open session as panels see it.
#pragma once

#include <functional>
#include <map>
#include <string>

#include <lumen/editor.h>

#include "modules/reloader.h"
#include "window/picture_shelf.h"
#include "workshop.h"

namespace lumenshop {

class SessionWorkbench final : public lumen::Workbench {
 public:
  /// `notice` shows what was refused. `wake`: called from worker threads when update() has something to do.
  SessionWorkbench(Workshop& workshop, std::function<void(const std::string&)> notice, std::function<void()> wake = {});

  void set_scale(float scale) { scale_ = scale; }
  void set_reduced_motion(bool on) { reduced_motion_ = on; }
  /// What the view shows at a point of the window.
  void set_picking(std::function<std::string(glm::vec2)> pick) { pick_ = std::move(pick); }
  /// Takes what was made in the background. True if something was.
  bool update() { return shelf_.update(); }
  void set_reloader(const Reloader* reloader) { reloader_ = reloader; }
  /// Badges of what was just loaded or kept. `now` in seconds, steady. The badge "loaded" goes after three seconds.
  void reloaded(const ReloadEvent& event, double now);
  void tick(double now);                 ///< lets old badges go
  double next_tick() const;              ///< when tick() has something to do; 0 = never

  // lumen::Workbench
  std::vector<lumen::InstanceState> instances() const override;
  std::vector<lumen::PropertyState> properties(const std::string& instance) const override;
  std::optional<lumen::PropertyState> property(const std::string& path) const override;
  void set(const std::string& path, lumen::Value value) override;
  void reset(const std::string& path) override;
  void begin_edit() override;
  void end_edit() override;
  void cancel_edit() override;
  void link(const std::string& path, const std::string& source, const std::string& expression) override;
  void unlink(const std::string& path) override;
  std::vector<std::string> linkable(const std::string& path) const override;
  std::string to_json(const lumen::Value& value) const override;
  lumen::Value from_json(const std::string& path, const std::string& json) const override;
  std::unique_ptr<lumen::Trial> trial(const std::string& view, const std::string& instance, const std::vector<std::string>& layers) override;
  std::string selection() const override;
  void select(const std::string& instance) override;
  std::vector<lumen::Problem> problems() const override;
  void open_source(const std::string& file, int line) override;
  std::vector<lumen::TypeState> types() const override;
  std::string add(const std::string& type, const std::string& properties = "{}") override;
  std::string instance_at(glm::vec2 point) override { return pick_ ? pick_(point) : std::string(); }
  std::shared_ptr<const lumen::Image> picture(const std::string& type, const std::string& properties) override { return shelf_.take(type, properties); }
  std::string gallery() const override;
  std::string capture(const std::string& surface) override;
  float scale() const override { return scale_; }
  bool reduced_motion() const override { return reduced_motion_; }

 private:
  struct Badge { std::string text; double until = 0; };  ///< until 0 = stays
  Session& session() const { return workshop_.session(); }
  lumen::InstanceState state_of(const Instance& instance) const;
  std::string badge_of(const std::string& type) const;
  template <class Action> void attempt(Action action);

  Workshop& workshop_;
  std::function<void(const std::string&)> notice_;
  std::function<std::string(glm::vec2)> pick_;
  PictureShelf shelf_;
  const Reloader* reloader_ = nullptr;
  float scale_ = 1;
  bool reduced_motion_ = false;
  std::string selection_;
  std::map<std::string, Badge> badges_;            ///< by library
  std::map<std::string, TypeInfo> types_;          ///< as the registry has them, since the last reload
  mutable std::vector<lumen::TypeState> addable_;  ///< of the same; empty: not asked for since
};

}  // namespace lumenshop
