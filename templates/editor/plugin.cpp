/// A panel that lists the instances of the session.

#include <imgui.h>

#include <lumen/editor.h>

namespace {

struct @Class@ : lumen::Editor {
  using Editor::Editor;

  std::string title() const override { return "@Title@"; }

  void draw(lumen::Workbench& workbench) override {
    for (const lumen::InstanceState& instance : workbench.instances())
      if (ImGui::Selectable(instance.id.c_str(), workbench.selection() == instance.id)) workbench.select(instance.id);
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "editor.@name@", "A panel that lists the instances of the session.")
