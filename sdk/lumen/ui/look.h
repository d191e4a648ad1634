/// What the host hands to all panels: colors, fonts, scale, and where to note the places of controls.
///
/// It hangs on the ImGui context (io.UserData), so that panels in plugins find it. Thread: main, inside an ImGui frame.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <imgui.h>

#include <lumen/ui/palette.h>

namespace lumen::ui {

/// The number that is being dragged; at most one.
struct Drag {
  ImGuiID field = 0;
  double start = 0, travel = 0;  ///< value at the press; UI units since then, slowed ones included
  bool moving = false;           ///< past the threshold: it is a drag, not a click
};

/// A text that is being typed.
struct Typing {
  std::string text, before;
  int frame = 0;                 ///< when its field was last drawn
  bool started = false;          ///< has had the keyboard
};

struct Look {
  Palette colors = palette(Theme::dark);
  ImFont* text = nullptr;       ///< null = ImGui's default font
  ImFont* heading = nullptr;
  ImFont* mono = nullptr;       ///< numbers, ids, code
  float scale = 1;              ///< pixels per UI unit
  bool reduced_motion = false;
  std::string panel;            ///< the panel being drawn: "properties"
  std::string editing;          ///< the property whose edit is open, or empty
  int editing_frame = 0;        ///< when its field was last drawn
  double editing_until = 0;     ///< ImGui time up to which nudges join it
  Drag drag;
  std::map<ImGuiID, Typing> typing;
  bool swallow_right = false;   ///< the right button cancelled a drag: no menu until it is up
  std::string filter;           ///< of the list that is open
  /// Opens the host's file browser at a file or folder; the answer comes in `browsed`, for the control `browse_for`.
  std::function<void(const std::string& from)> browse;
  ImGuiID browse_for = 0;
  std::string browsed;
  std::string notice;           ///< what a control could not do; the host shows it and clears it
  int keys_frame = -1;          ///< when a control under the pointer last took editing keys
  double wake_at = 0;           ///< ImGui time of the next frame that a control asked for; 0 = none
  /// Told the rectangle of each control, as "panel/path"; scripts aim with it. Empty = not wanted.
  std::function<void(const std::string& path, ImVec2 min, ImVec2 max)> record;

  float operator()(float units) const { return units * scale; }  ///< pixels
};

/// The look of the current ImGui context. Throws Error if the host gave none.
Look& look();

/// Notes the last item's rectangle under "panel/path".
void record(std::string_view path);
void record(std::string_view path, ImVec2 min, ImVec2 max);

/// Delete, Backspace, copy and paste belong to what is under the pointer in this frame, not to the program's commands.
void take_keys();

/// Asks for a frame in `seconds`, though nothing happens until then.
void wake_in(double seconds);

/// A font for a scope; null does nothing.
struct FontScope {
  explicit FontScope(ImFont* font) : on_(font != nullptr) { if (on_) ImGui::PushFont(font); }
  ~FontScope() { if (on_) ImGui::PopFont(); }
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;

 private:
  bool on_;
};

/// Text in a color of the palette.
void text(std::string_view text, ImU32 color);
/// The same, shortened with an ellipsis to `width` pixels.
void text_elided(ImDrawList* list, ImVec2 position, float width, std::string_view text, ImU32 color, bool keep_end = false);

/// A tooltip for the last item after half a second of rest; also over disabled items. True when it is to be filled;
/// then call end_tooltip().
bool begin_tooltip();
void end_tooltip();
void tooltip(std::string_view text);

}  // namespace lumen::ui
