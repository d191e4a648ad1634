#include "window/glfw_window.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <lumen/error.h>

namespace lumenshop {
namespace {

InputQueue& queue_of(GLFWwindow* window) { return *static_cast<InputQueue*>(glfwGetWindowUserPointer(window)); }

bool pressed(GLFWwindow* window, int left, int right) { return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS; }

WindowEvent event_of(GLFWwindow* window, WindowEvent::Type type) {
  WindowEvent event;
  event.type = type;
  event.shift = pressed(window, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  event.control = pressed(window, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  return event;
}

/// Letters are named by the person's keyboard, all else by the key's place.
std::string name_on_keyboard(int key, int scancode) {
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) {
    const char* name = glfwGetKeyName(key, scancode);
    if (name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0) return std::string(1, static_cast<char>(name[0] - 'a' + 'A'));
  }
  return name_of_key(key);
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
  WindowEvent event = event_of(window, WindowEvent::Type::key);
  event.key = key;
  event.name = name_on_keyboard(key, scancode);
  event.down = action != GLFW_RELEASE;
  event.repeated = action == GLFW_REPEAT;
  event.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  event.control = (modifiers & GLFW_MOD_CONTROL) != 0;
  queue_of(window).push(std::move(event));
}

void on_button(GLFWwindow* window, int button, int action, int) {
  WindowEvent event = event_of(window, WindowEvent::Type::button);
  event.button = button;
  event.down = action == GLFW_PRESS;
  queue_of(window).push(std::move(event));
}

void on_pointer(GLFWwindow* window, double x, double y) {
  WindowEvent event = event_of(window, WindowEvent::Type::pointer);
  event.position = {x, y};
  queue_of(window).push(std::move(event));
}

void on_wheel(GLFWwindow* window, double x, double y) {
  WindowEvent event = event_of(window, WindowEvent::Type::wheel);
  event.wheel = {x, y};
  queue_of(window).push(std::move(event));
}

void on_character(GLFWwindow* window, unsigned character) {
  WindowEvent event = event_of(window, WindowEvent::Type::character);
  event.character = character;
  queue_of(window).push(std::move(event));
}

void on_drop(GLFWwindow* window, int count, const char** files) {
  WindowEvent event = event_of(window, WindowEvent::Type::drop);
  event.files.assign(files, files + count);
  queue_of(window).push(std::move(event));
}

void on_focus(GLFWwindow* window, int focused) {
  WindowEvent event = event_of(window, WindowEvent::Type::focus);
  event.down = focused != 0;
  queue_of(window).push(std::move(event));
}

void on_close(GLFWwindow* window) {
  glfwSetWindowShouldClose(window, GLFW_FALSE);  // whether it closes is for the program to say
  queue_of(window).push(event_of(window, WindowEvent::Type::close));
}

/// What was uncovered or resized is drawn again: a focus event that changes nothing.
void on_refresh(GLFWwindow* window) {
  WindowEvent event = event_of(window, WindowEvent::Type::focus);
  event.down = glfwGetWindowAttrib(window, GLFW_FOCUSED) != 0;
  queue_of(window).push(std::move(event));
}

std::string last_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : "unknown reason";
}

}  // namespace

GlfwWindow::GlfwWindow(glm::ivec2 size, const std::string& title, InputQueue& queue) : queue_(queue) {
  if (!glfwInit()) throw lumen::Error("window", last_error(), "without a display use `lumenshop render`");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = last_error();
    glfwTerminate();
    throw lumen::Error("window", reason, "OpenGL 4.5 is needed");
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, &queue_);
  glfwSetKeyCallback(window_, on_key);
  glfwSetMouseButtonCallback(window_, on_button);
  glfwSetCursorPosCallback(window_, on_pointer);
  glfwSetScrollCallback(window_, on_wheel);
  glfwSetCharCallback(window_, on_character);
  glfwSetDropCallback(window_, on_drop);
  glfwSetWindowFocusCallback(window_, on_focus);
  glfwSetWindowCloseCallback(window_, on_close);
  glfwSetWindowRefreshCallback(window_, on_refresh);
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { on_refresh(window); });

  constexpr int shapes[] = {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_CROSSHAIR_CURSOR, GLFW_VRESIZE_CURSOR, GLFW_HRESIZE_CURSOR,
                            GLFW_CROSSHAIR_CURSOR, GLFW_CROSSHAIR_CURSOR, GLFW_HAND_CURSOR, GLFW_ARROW_CURSOR};
  for (int index = 0; index < ImGuiMouseCursor_COUNT; ++index) cursors_[index] = glfwCreateStandardCursor(shapes[index]);
}

GlfwWindow::~GlfwWindow() {
  for (void* cursor : cursors_)
    if (cursor) glfwDestroyCursor(static_cast<GLFWcursor*>(cursor));
  glfwDestroyWindow(window_);
  glfwTerminate();
}

glm::ivec2 GlfwWindow::size() const {
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

float GlfwWindow::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x;
}

void GlfwWindow::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void GlfwWindow::set_cursor(int cursor) {
  if (cursor == cursor_) return;
  cursor_ = cursor;
  glfwSetInputMode(window_, GLFW_CURSOR, cursor < 0 ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
  if (cursor >= 0 && cursor < ImGuiMouseCursor_COUNT) glfwSetCursor(window_, static_cast<GLFWcursor*>(cursors_[cursor]));
}

void GlfwWindow::set_full_screen(bool on) {
  if (on == full_screen_) return;
  full_screen_ = on;
  if (on) {
    glfwGetWindowPos(window_, &windowed_position_.x, &windowed_position_.y);
    glfwGetWindowSize(window_, &windowed_size_.x, &windowed_size_.y);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode) glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  } else {
    glfwSetWindowMonitor(window_, nullptr, windowed_position_.x, windowed_position_.y, windowed_size_.x, windowed_size_.y, 0);
  }
}

void GlfwWindow::swap() { glfwSwapBuffers(window_); }

void GlfwWindow::wait(double seconds) {
  if (seconds == 0) glfwPollEvents();
  else if (seconds < 0) glfwWaitEvents();
  else glfwWaitEventsTimeout(seconds);
}

void GlfwWindow::wake() { glfwPostEmptyEvent(); }
double GlfwWindow::time() { return glfwGetTime(); }

}  // namespace lumenshop
