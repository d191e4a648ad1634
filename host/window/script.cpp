#include "window/script.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <epoxy/gl.h>
#include <imgui.h>

#include <lumen/error.h>

#include "model/json_value.h"

namespace lumenshop {
namespace {

constexpr std::uintmax_t longest_file = 1 << 20;
constexpr int frames_between_steps = 3;

std::pair<std::string, std::string> split_chord(const std::string& chord) {
  const auto plus = chord.rfind('+');
  if (plus == std::string::npos || plus + 1 == chord.size()) return {"", chord};
  return {chord.substr(0, plus), chord.substr(plus + 1)};
}

}  // namespace

Script::Script(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw lumen::Error(file.string(), "no such script");
  if (std::filesystem::file_size(file, error) > longest_file) throw lumen::Error(file.string(), "longer than 1 MiB");
  std::ifstream stream(file);
  steps_ = Json::parse(stream, nullptr, false);
  if (!steps_.is_array()) throw lumen::Error(file.string(), "not a JSON array of steps");
}

void Script::attach(Application& application, Gui& gui, GlfwWindow& window, InputQueue& queue) {
  application_ = &application;
  gui_ = &gui;
  window_ = &window;
  queue_ = &queue;
  gui.look().record = [this](const std::string& path, ImVec2 min, ImVec2 max) { places_[path] = {{min.x, min.y}, {max.x, max.y}, frames_}; };
}

void Script::fail(const std::string& why) { failures_ += "step " + std::to_string(next_) + ": " + why + "\n"; }

void Script::later(WindowEvent event) {
  event.control = control_;
  event.shift = shift_;
  pending_.push_back(std::move(event));
}

void Script::move_to(glm::vec2 position) {
  WindowEvent event;
  event.type = WindowEvent::Type::pointer;
  event.position = position;
  later(std::move(event));
}

void Script::button(int index, bool down) {
  WindowEvent event;
  event.type = WindowEvent::Type::button;
  event.button = index;
  event.down = down;
  later(std::move(event));
}

void Script::key(const std::string& name, bool down) {
  if (name == "Ctrl") control_ = down;
  if (name == "Shift") shift_ = down;
  WindowEvent event;
  event.type = WindowEvent::Type::key;
  event.key = key_of_name(name);
  event.name = name;
  event.down = down;
  if (event.key == 0) return fail("there is no key '" + name + "'");
  later(std::move(event));
}

void Script::press_keys(const std::string& chord, bool down) {
  for (const char* name : {"Ctrl", "Shift", "L"})
    if (chord.find(name) != std::string::npos) key(name, down);
}

glm::vec2 Script::aim(const Json& step, const std::string& place) {
  const auto found = places_.find(place);
  if (found == places_.end() || found->second.frame < frames_ - 1) {
    fail("there is no '" + place + "' on the screen");
    return {0, 0};
  }
  const Json at = step.value("at", Json::array({0.5, 0.5}));
  return glm::mix(found->second.min, found->second.max, glm::vec2(at.at(0).get<float>(), at.at(1).get<float>()));
}

void Script::begin_pointer(const Json& step, const std::string& verb) {
  const glm::vec2 position = aim(step, step.at(verb).get<std::string>());
  const std::string name = step.value("button", "left");
  const int which = name == "right" ? 1 : name == "middle" ? 2 : 0;
  const std::string held = step.value("keys", "") + step.value("hold", "");
  move_to(position);
  press_keys(held, true);
  if (verb == "click") {
    if (step.value("times", 1) > 1) {
      // Frames may take long: the clicks of one step are a double click however far apart they come, and those of no other.
      ImGui::GetIO().MouseDoubleClickTime = 60;
      ImGui::GetIO().MouseClickedTime[which] = -1e6;
    } else {
      ImGui::GetIO().MouseDoubleClickTime = 0.3f;
    }
    for (int time = 0; time < step.value("times", 1); ++time) {
      button(which, true);
      button(which, false);
    }
  } else if (verb == "wheel") {
    WindowEvent event;
    event.type = WindowEvent::Type::wheel;
    event.wheel = {0, step.value("notches", 1.0f)};
    later(std::move(event));
  } else if (verb == "drag") {
    const int steps = std::max(1, step.value("steps", 8));
    const glm::vec2 by = step.contains("to") ? aim(Json::object(), step["to"].get<std::string>()) - position
                                             : glm::vec2(step.at("by").at(0).get<float>(), step.at("by").at(1).get<float>());
    button(which, true);
    for (int index = 1; index <= steps; ++index) move_to(position + by * (static_cast<float>(index) / static_cast<float>(steps)));
    if (step.value("release", true)) button(which, false);
  }
  press_keys(held, false);
}

void Script::expect(const Json& step) {
  const std::string path = step.at("expect").get<std::string>();
  const auto state = application_->workbench().property(path);
  if (!state) return fail("there is no " + path);
  const Json value = Json::parse(to_json(state->value).dump());
  const std::string text = path + " is " + value.dump();
  if (step.contains("value")) {
    const Json& wanted = step["value"];
    const double tolerance = step.value("tolerance", 1e-6);
    const auto near = [&](const Json& a, const Json& b) { return a.is_number() && b.is_number() ? std::abs(a.get<double>() - b.get<double>()) <= tolerance : a == b; };
    bool same = near(value, wanted);
    if (value.is_array() && wanted.is_array() && value.size() == wanted.size()) {
      same = true;
      for (std::size_t index = 0; index < value.size(); ++index) same = same && near(value[index], wanted[index]);
    }
    if (!same) fail(text + ", not " + wanted.dump());
  }
  if (step.contains("above") && !(value.is_number() && value.get<double>() > step["above"].get<double>())) fail(text + ", not above " + step["above"].dump());
  if (step.contains("below") && !(value.is_number() && value.get<double>() < step["below"].get<double>())) fail(text + ", not below " + step["below"].dump());
  if (step.contains("differs") && value == step["differs"]) fail(text + ", as before");
  if (step.contains("set") && state->set != step["set"].get<bool>()) fail(path + (state->set ? " is set" : " is not set"));
  if (step.contains("link") && state->link != step["link"].get<std::string>()) fail(path + " is linked to '" + state->link + "'");
}

void Script::begin(const Json& step) {
  for (const char* verb : {"move", "click", "drag", "wheel"})
    if (step.contains(verb)) return begin_pointer(step, verb);
  if (step.contains("type")) {
    for (const char c : step["type"].get<std::string>()) {
      WindowEvent event;
      event.type = WindowEvent::Type::character;
      event.character = static_cast<unsigned char>(c);
      later(std::move(event));
    }
  } else if (step.contains("key")) {
    const auto [modifiers, name] = split_chord(step["key"].get<std::string>());
    press_keys(modifiers, true);
    key(name, true);
    key(name, false);
    press_keys(modifiers, false);
  } else if (step.contains("drop")) {
    WindowEvent event;
    event.type = WindowEvent::Type::drop;
    for (const Json& file : step["drop"]) event.files.push_back(file.get<std::string>());
    later(std::move(event));
  } else if (step.contains("command")) {
    if (!application_->commands().run(step["command"].get<std::string>())) fail("the command did not run");
  } else if (step.contains("select")) {
    application_->workbench().select(step["select"].get<std::string>());
  } else if (step.contains("idle")) {
    waiting_until_ = GlfwWindow::time() + step["idle"].get<double>();
    frames_allowed_ = step.value("frames", -1);
    frames_at_wait_ = frames_;
  } else if (step.contains("settle")) {
    settling_ = true;
    waiting_until_ = GlfwWindow::time() + 60;
  } else if (step.contains("expect")) {
    expect(step);
  } else if (step.contains("expect_place")) {
    const auto found = places_.find(step["expect_place"].get<std::string>());
    const bool there = found != places_.end() && found->second.frame >= frames_ - 1;
    if (there != step.value("there", true)) fail(step["expect_place"].get<std::string>() + (there ? " is on the screen" : " is not on the screen"));
  } else if (step.contains("expect_problems")) {
    const auto problems = application_->workbench().problems();
    if (problems.size() != step["expect_problems"].get<std::size_t>())
      fail(std::to_string(problems.size()) + " problems" + (problems.empty() ? "" : ", the first: " + problems.front().message));
  } else if (step.contains("shot")) {
    shot_ = step["shot"].get<std::string>();
  } else {
    fail("unknown step " + step.dump());
  }
}

double Script::wake_at() const {
  // What it waits for has no signal of its own: the end of all signals is what is waited for.
  return settling_ ? std::min(waiting_until_, GlfwWindow::time() + 0.02) : waiting_until_;
}

void Script::step(long frames) {
  frames_ = frames;
  if (finished_ || !queue_->empty()) return;
  if (!pending_.empty()) {
    queue_->push(std::move(pending_.front()));
    pending_.pop_front();
    rest_ = frames_between_steps;
    return;
  }
  if (settling_ && !application_->busy() && application_->wake_at() == 0) settling_ = false, waiting_until_ = 0;
  if (waiting_until_ > 0) {
    if (GlfwWindow::time() < waiting_until_) return;
    if (settling_) fail("still at work after a minute");
    if (frames_allowed_ >= 0 && frames_ - frames_at_wait_ > frames_allowed_)
      fail(std::to_string(frames_ - frames_at_wait_) + " frames while idle, not " + std::to_string(frames_allowed_));
    settling_ = false;
    waiting_until_ = 0;
    frames_allowed_ = -1;
  }
  if (rest_ > 0) {
    --rest_;
    return;
  }
  if (next_ == steps_.size()) {
    finished_ = true;
    return;
  }
  try {
    begin(steps_[next_]);
  } catch (const std::exception& error) {
    fail(error.what());
  }
  ++next_;
  if (waiting_until_ == 0) rest_ = frames_between_steps;
}

void Script::after_frame() {
  if (shot_.empty()) return;
  write_shot();
  shot_.clear();
}

void Script::write_shot() {
  const glm::ivec2 size = window_->size();
  std::vector<unsigned char> pixels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  std::ofstream stream(shot_, std::ios::binary);
  stream << "P6\n" << size.x << ' ' << size.y << "\n255\n";
  for (int row = size.y - 1; row >= 0; --row) stream.write(reinterpret_cast<const char*>(pixels.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) * 3), size.x * 3);
  if (!stream) fail("cannot write " + shot_.string());
}

}  // namespace lumenshop
