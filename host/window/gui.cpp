#include "window/gui.h"

#include <algorithm>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <backends/imgui_impl_opengl3.h>

#include "window/fonts.h"
#include "window/style.h"

namespace lumenshop {
namespace {

void map_keys(ImGuiIO& io) {
  const std::pair<ImGuiKey, int> keys[] = {
      {ImGuiKey_Tab, GLFW_KEY_TAB}, {ImGuiKey_LeftArrow, GLFW_KEY_LEFT}, {ImGuiKey_RightArrow, GLFW_KEY_RIGHT}, {ImGuiKey_UpArrow, GLFW_KEY_UP},
      {ImGuiKey_DownArrow, GLFW_KEY_DOWN}, {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP}, {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN}, {ImGuiKey_Home, GLFW_KEY_HOME},
      {ImGuiKey_End, GLFW_KEY_END}, {ImGuiKey_Insert, GLFW_KEY_INSERT}, {ImGuiKey_Delete, GLFW_KEY_DELETE}, {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
      {ImGuiKey_Space, GLFW_KEY_SPACE}, {ImGuiKey_Enter, GLFW_KEY_ENTER}, {ImGuiKey_Escape, GLFW_KEY_ESCAPE}, {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
      {ImGuiKey_A, GLFW_KEY_A}, {ImGuiKey_C, GLFW_KEY_C}, {ImGuiKey_V, GLFW_KEY_V}, {ImGuiKey_X, GLFW_KEY_X}, {ImGuiKey_Y, GLFW_KEY_Y}, {ImGuiKey_Z, GLFW_KEY_Z}};
  for (const auto& [name, key] : keys) io.KeyMap[name] = key;
}

}  // namespace

Gui::Gui(GlfwWindow& window) : window_(window) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.UserData = &look_;
  io.IniFilename = nullptr;            // panels are placed by the host, and remembered in its own settings
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // a blinking caret would need frames while idle
  io.ConfigDragClickToInputText = true;
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.MousePos = {-FLT_MAX, -FLT_MAX};
  map_keys(io);
  io.ClipboardUserData = window_.handle();
  io.SetClipboardTextFn = [](void* handle, const char* text) { glfwSetClipboardString(static_cast<GLFWwindow*>(handle), text); };
  io.GetClipboardTextFn = [](void* handle) { return glfwGetClipboardString(static_cast<GLFWwindow*>(handle)); };
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Gui::set_look(lumen::ui::Theme theme, float scale, bool reduced_motion) {
  const bool rebuild = look_.scale != scale || !ImGui::GetIO().Fonts->IsBuilt();
  theme_ = theme;
  look_.colors = lumen::ui::palette(theme);
  look_.scale = scale;
  look_.reduced_motion = reduced_motion;
  if (rebuild) {
    load_fonts(look_);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    // Glyphs lie on whole pixels and fills read one white texel: what linear filtering gives, for a part of its time in software.
    const auto atlas = static_cast<GLuint>(reinterpret_cast<std::intptr_t>(ImGui::GetIO().Fonts->TexID));
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTextureParameteri(atlas, filter, GL_NEAREST);
  }
  apply_imgui_style(look_);
}

void Gui::feed(const WindowEvent& event) {
  using Type = WindowEvent::Type;
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = event.control;
  io.KeyShift = event.shift;
  switch (event.type) {
    case Type::pointer: io.MousePos = {event.position.x, event.position.y}; break;
    case Type::button:
      if (event.button >= 0 && event.button < 5) io.MouseDown[event.button] = event.down;
      break;
    case Type::wheel:
      io.MouseWheelH += event.wheel.x;
      io.MouseWheel += event.wheel.y;
      break;
    case Type::key:
      if (event.key >= 0 && event.key < 512) io.KeysDown[event.key] = event.down;
      if (event.name == "Ctrl") io.KeyCtrl = event.down;
      if (event.name == "Shift") io.KeyShift = event.down;
      if (event.name.size() == 1 && event.name[0] >= 'A' && event.name[0] <= 'Z') held_ = event.down ? event.name : held_ == event.name ? "" : held_;
      break;
    case Type::character: io.AddInputCharacter(event.character); break;
    case Type::focus:
      io.AddFocusEvent(event.down);
      if (!event.down) held_.clear();
      break;
    case Type::drop: case Type::close: break;
  }
}

void Gui::begin(const std::vector<WindowEvent>& events) {
  ImGuiIO& io = ImGui::GetIO();
  for (const WindowEvent& event : events) feed(event);
  if (!io.MouseDown[1]) look_.swallow_right = false;
  const glm::ivec2 size = window_.size();
  io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
  const double now = GlfwWindow::time();
  io.DeltaTime = static_cast<float>(std::max(1e-4, now - last_time_));
  last_time_ = now;
  look_.wake_at = 0;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

double Gui::wake_at() const {
  // ImGui's clock stood at its last frame's time since then.
  return look_.wake_at > 0 ? last_time_ + look_.wake_at - ImGui::GetTime() : 0;
}

void Gui::end() {
  ImGui::Render();
  window_.set_cursor(ImGui::GetMouseCursor());
  const glm::ivec2 size = window_.size();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.x, size.y);
  const ImVec4 canvas = ImGui::ColorConvertU32ToFloat4(look_.colors.canvas);
  glClearColor(canvas.x, canvas.y, canvas.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace lumenshop
