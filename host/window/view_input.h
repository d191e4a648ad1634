/// Takes the events of a view to its interactors: the first that claims one has it, the camera is asked last.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <lumen/interactor.h>

#include "frame/view_renderer.h"
#include "window/layout.h"

namespace lumenshop {

class ViewInputRouter final : public lumen::ViewInput {
 public:
  struct Situation {
    Session* session = nullptr;
    ViewRenderer* renderer = nullptr;
    std::string view;             ///< id
    std::string selection;        ///< id or empty
    glm::ivec2 size{1};           ///< pixels of the view, whatever the renderer's resolution
    double time = 0;
    bool blender_keys = false, reduced_motion = false;
  };
  /// The state of the frame that the following calls are in.
  void begin(Situation situation) { situation_ = std::move(situation); }

  /// True if an interactor claimed it. A claimed press is an open edit until its release, or until Esc takes it back.
  bool send(const lumen::InputEvent& event);
  bool captured() const { return !captured_by_.empty(); }
  /// Somebody else than the camera has the press: a click of it means something else than selecting.
  bool captured_by_tool() const;
  /// Lets go of a drag whose release was lost; its edit ends.
  void let_go();
  /// Calls tick() of those that asked for it. True if one still moves.
  bool tick();
  bool animating() const { return !animated_.empty(); }
  lumen::Cursor cursor() const { return cursor_; }
  /// Where an interactor's words go.
  struct PlacedLabel { std::string instance, text; glm::vec2 pixel; };
  std::vector<PlacedLabel> labels() const;

  // lumen::ViewInput
  glm::ivec2 size() const override { return situation_.size; }
  const lumen::Camera& camera() const override { return situation_.renderer->camera(); }
  lumen::Bounds scene() const override { return situation_.renderer->scene_bounds(); }
  lumen::Bounds selection() const override;
  std::optional<glm::vec3> surface_at(glm::vec2 pixel) override;
  std::string instance_at(glm::vec2 pixel) override;
  std::optional<lumen::Picked> pick(glm::vec2 pixel, const std::vector<std::string>& renderers = {}) override;
  void set_cursor(lumen::Cursor cursor) override { cursor_ = cursor; }
  bool blender_keys() const override { return situation_.blender_keys; }
  double time() const override { return situation_.time; }
  bool reduced_motion() const override { return situation_.reduced_motion; }
  void animate() override;

 private:
  Instance* instance_of(int number) const;  ///< null: none
  std::vector<Instance*> order() const;
  bool ask(Instance& instance, const lumen::InputEvent& event);
  ViewRenderer::Hit hit(glm::vec2 pixel, const std::function<bool(const Instance&)>& wanted = {});

  Situation situation_;
  std::string captured_by_;               ///< an id: the object may be replaced by a reload
  std::string asked_;                     ///< whose call this is
  std::vector<std::string> animated_;
  lumen::Cursor cursor_ = lumen::Cursor::arrow;
};

}  // namespace lumenshop
