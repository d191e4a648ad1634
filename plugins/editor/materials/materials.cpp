/// The gallery of lit-sphere materials: generated ones and a person's own, for the front light, the back light and the
/// highlight of a surface. After Ostendorf 2021, section 4 and figure 4.2.
#include <cfloat>
#include <cmath>
#include <utility>

#include <imgui.h>

#include <lumen/editor.h>
#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>

#include "assignment.h"
#include "grid_cursor.h"
#include "thumbnails.h"

namespace {

using namespace lumen;

constexpr double seconds_between_looks = 1;  // into the folder

struct Materials : Editor {
  using Editor::Editor;

  Property<int> size{this, "size", 48, {.min = 32, .max = 128, .unit = "pixels", .doc = "of the spheres, at scale 1", .affects = Affects::nothing}};

  std::string title() const override { return "Materials"; }

  void draw(Workbench& workbench) override {
    const ui::Look& look = ui::look();
    const std::string selection = workbench.selection();
    const std::string surface = takes_materials(workbench, selection) ? selection : std::string();
    thumbnails_.begin_frame();
    look_into_folder(workbench);
    draw_buttons(workbench, surface);
    ImGui::BeginChild("rows");
    cursor_.begin_frame();
    keyboard_ = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) && !ImGui::GetIO().WantTextInput;
    for (const Role role : {Role::front, Role::back, Role::highlight}) draw_row(workbench, role, surface);
    if (keyboard_ && cursor_.take_keys()) {
      scroll_to_cursor_ = true;
      ui::wake_in(0);
    }
    ImGui::EndChild();
    if (dragged_ && !ImGui::IsMouseDown(0)) dragged_.reset();
    if (dragged_) draw_dragged(workbench, look);
  }

 private:
  struct Dragged {
    Role role;
    Material material;
  };

  /// What it does not do is said in a toast.
  template <class Action>
  static void attempt(Action action) {
    try {
      action();
    } catch (const Error& error) {
      ui::look().notice = error.what();
    }
  }

  void look_into_folder(const Workbench& workbench) {
    if (ImGui::GetTime() < next_look_) return;
    next_look_ = ImGui::GetTime() + seconds_between_looks;
    own_ = materials_in(workbench.gallery());
  }

  void draw_buttons(Workbench& workbench, const std::string& surface) {
    ui::Look& look = ui::look();
    ImGui::BeginDisabled(surface.empty());
    const bool capture = ImGui::Button("Capture to gallery");
    ImGui::EndDisabled();
    ui::record("capture");
    ui::tooltip(surface.empty() ? "Select a surface: its look, rendered on a sphere, becomes a material of your own." : "Renders the look of " + surface + " on a sphere, under the view's lights, as a material of your own.");
    if (capture) attempt([&] {
      workbench.capture(surface);
      next_look_ = 0;
    });
    ImGui::SameLine();
    if (ImGui::Button("Add picture...") && look.browse) {
      look.browse_for = ImGui::GetID("added picture");
      look.browse(workbench.gallery());
    }
    ui::record("add");
    ui::tooltip("Copies a picture of a sphere into your gallery, " + workbench.gallery());
    if (look.browse_for == ImGui::GetID("added picture") && !look.browsed.empty()) {
      look.browse_for = 0;
      attempt([&] {
        add_to_folder(std::exchange(look.browsed, {}), workbench.gallery());
        next_look_ = 0;
      });
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (surface.empty()) ui::text("select a surface, or drag a sphere onto one", look.colors.dim);
    else ui::text(surface, look.colors.label);
  }

  void draw_row(Workbench& workbench, Role role, const std::string& surface) {
    const ui::Look& look = ui::look();
    const std::string current = surface.empty() ? std::string() : picture_of(workbench, surface, role);
    ImGui::PushID(name_of(role));
    const float begin = ImGui::GetCursorPosX() + look(78), right = ImGui::GetContentRegionMax().x;
    ui::text(name_of(role), look.colors.label);
    ui::tooltip(role == Role::front ? "the picture that the first light of the view is answered with"
                : role == Role::back ? "the picture that the other lights are answered with" : "the picture of the highlight, beside the rest of the shading");
    ImGui::SameLine();
    float x = begin;
    const float step = look(float(size.get())) + look(8);
    const auto place = [&](const Material& material) {
      if (x > begin && x + step > right) x = begin;
      if (x > begin) ImGui::SameLine();
      ImGui::SetCursorPosX(x);
      draw_material(workbench, role, material, surface, current);
      x += step;
    };
    for (const Material& material : generated_)
      if (material.highlight == (role == Role::highlight)) place(material);
    for (const Material& material : own_) place(material);
    ImGui::Dummy({0, look(4)});
    ImGui::PopID();
  }

  void draw_material(Workbench& workbench, Role role, const Material& material, const std::string& surface, const std::string& current) {
    const ui::Look& look = ui::look();
    const float width = look(float(size.get())), height = width + ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(material.json().c_str(), {width, height});
    const std::string name = std::string(name_of(role)) + ":" + material.name;
    cursor_.add(name, corner);
    if (ImGui::IsItemActivated()) cursor_.put(name);
    const bool at_cursor = keyboard_ && cursor_.is_at(name);
    if (at_cursor && std::exchange(scroll_to_cursor_, false)) ImGui::SetScrollHereY();
    if (!ImGui::IsItemVisible()) return;
    ui::record(name);
    const bool hovered = ImGui::IsItemHovered(), chosen = !current.empty() && makes(workbench, current, material);
    const Thumbnails::Entry& thumbnail = thumbnails_.of(workbench, material);

    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImVec2 low(corner.x - look(2), corner.y - look(2)), high(corner.x + width + look(2), corner.y + height + look(2));
    if (chosen) list->AddRectFilled(low, high, look.colors.selection, look(3));
    else if (hovered) list->AddRectFilled(low, high, look.colors.hover, look(3));
    draw_sphere(list, thumbnail, corner, width);
    if (chosen) ui::draw_icon(list, ui::Icon::check, {corner.x + width - look(14), corner.y}, look(14), look.colors.text);
    ui::text_elided(list, {corner.x, corner.y + width}, width, material.name, chosen ? look.colors.text : look.colors.label);

    if (at_cursor) {
      list->AddRect(low, high, look.colors.focus, look(3), 0, look(1.5f));
      ui::record("cursor:" + name);
    }
    const auto entered = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
    const bool applied = at_cursor && (entered(ImGuiKey_Enter) || entered(ImGuiKey_KeyPadEnter));
    if (applied || (hovered && ImGui::IsMouseDoubleClicked(0))) attempt([&] { assign(workbench, surface, role, material); });
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0)) dragged_ = {role, material};
    if (ImGui::IsItemDeactivated() && dragged_) drop(workbench, *std::exchange(dragged_, std::nullopt));
    if (ui::begin_tooltip()) {
      ui::text(material.name, look.colors.text);
      if (!thumbnail.failure.empty()) ui::text(thumbnail.failure, look.colors.error);
      ui::text(surface.empty() ? "drag: onto a surface in the picture" : "double click, or arrow keys and Enter: onto " + surface + "; drag: onto a surface in the picture", look.colors.dim);
      ui::end_tooltip();
    }
  }

  static void draw_sphere(ImDrawList* list, const Thumbnails::Entry& thumbnail, ImVec2 corner, float width) {
    const ui::Look& look = ui::look();
    if (thumbnail.texture) {
      // Rows of GL textures run upward.
      const auto name = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(thumbnail.texture.name()));
      return list->AddImage(name, corner, {corner.x + width, corner.y + width}, {0, 1}, {1, 0});
    }
    list->AddCircle({corner.x + width / 2, corner.y + width / 2}, width / 2 - 1, look.colors.border);
    if (!thumbnail.failure.empty()) ui::draw_icon(list, ui::Icon::triangle, {corner.x + width / 2 - look(8), corner.y + width / 2 - look(8)}, look(16), look.colors.error);
  }

  static void drop(Workbench& workbench, const Dragged& dropped) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const std::string target = workbench.instance_at({at.x, at.y});
    if (target.empty()) return;
    attempt([&] {
      assign(workbench, target, dropped.role, dropped.material);
      workbench.select(target);
    });
  }

  void draw_dragged(Workbench& workbench, const ui::Look& look) {
    const float width = look(float(size.get())) * 0.75f;
    const ImVec2 at = ImGui::GetIO().MousePos;
    draw_sphere(ImGui::GetForegroundDrawList(), thumbnails_.of(workbench, dragged_->material), {at.x - width / 2, at.y - width / 2}, width);
  }

  const std::vector<Material> generated_ = generated_materials();
  std::vector<Material> own_;           ///< of the folder, as last seen
  double next_look_ = 0;                ///< ImGui time
  Thumbnails thumbnails_;
  std::optional<Dragged> dragged_;
  GridCursor cursor_;
  bool keyboard_ = false;               ///< the rows have it
  bool scroll_to_cursor_ = false;
};

}  // namespace

LUMEN_PLUGIN(Materials, "editor.materials", "the gallery of lit-sphere materials, generated and a person's own. Ostendorf 2021, section 4")
