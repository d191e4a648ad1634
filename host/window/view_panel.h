/// The view: its picture at the resolution that holds the rate, its input, its chips.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "window/input_queue.h"
#include "window/picture_texture.h"
#include "window/resolution.h"
#include "window/settings.h"
#include "window/view_input.h"
#include "workshop.h"

namespace lumenshop {

class ViewPanel {
 public:
  struct Context {
    const Rectangle& place;
    const std::vector<WindowEvent>& events;
    const std::string& held_letter;
    std::string selection;
    const Settings& settings;
    bool figure = false;                                ///< the picture alone
    std::function<void(const std::string& id)> select;  ///< a click picked it; empty = the background
    std::function<void()> context_menu;                 ///< its entries
  };

  explicit ViewPanel(Workshop& workshop);
  /// The window's content and its input; call inside an ImGui frame. What it set takes effect in refresh().
  void draw(const Context& context);
  /// Brings the picture up to date, by one refinement at most. After all panels, before ImGui's rendering.
  void refresh(bool editing);
  /// A key for the view: true if an interactor took it.
  bool key(const WindowEvent& event);
  /// Nothing of the GL is held any more; before views are closed.
  void release();

  bool busy() const;                   ///< wants another frame at once
  double wake_at() const;              ///< or one at this time; 0 = no
  glm::ivec2 size() const { return size_; }
  double milliseconds() const { return milliseconds_; }  ///< of the last drawing
  const std::string& view() const { return view_; }
  /// What is drawn at a point of the window: an instance's id, or empty. Inside an ImGui frame, after draw().
  std::string instance_at(glm::vec2 point);
  ViewInputRouter& input() { return input_; }
  void let_go() { input_.let_go(); }

 private:
  void take_events(const Context& context, bool hovered);
  void take_button(const WindowEvent& event, const Context& context, bool hovered);
  void draw_chips(const Context& context);
  void draw_empty(const Rectangle& place);
  void draw_labels();
  lumen::InputEvent event_at(lumen::InputEvent::Type type, const WindowEvent& event) const;
  void begin_input(const Settings& settings, const std::string& selection);
  ViewRenderer* renderer();

  Workshop& workshop_;
  ViewInputRouter input_;
  Resolution resolution_;
  std::unique_ptr<PictureTexture> picture_;
  std::string view_, failure_;
  Rectangle place_;
  glm::ivec2 size_{0};
  int divider_ = 1;
  double milliseconds_ = 0, last_click_ = -1;
  glm::vec2 pointer_{0}, pressed_at_{0}, last_click_at_{-100};
  lumen::InputEvent::Button held_button_ = lumen::InputEvent::Button::none;
  bool moved_ = false, open_menu_ = false, wheeled_ = false;
  std::string held_letter_;
  std::uint64_t drawn_revision_ = 0;
  float progress_ = 1;
  bool unfinished_ = false, chip_shown_ = false;
};

}  // namespace lumenshop
