#include "window/live_frame_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include <epoxy/gl.h>

#include "frame/shader_library.h"

namespace lumenshop {
namespace {

std::string gl_errors() {
  std::string text;
  // Bounded: a lost context reports an error for ever.
  for (int count = 0; count < 16; ++count) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    char code[32];
    std::snprintf(code, sizeof code, "GL error 0x%04x", error);
    if (text.empty()) text = code;
  }
  return text;
}

/// What instances report as errors: a plugin that throws while it draws is reported and survived.
std::set<std::string> reported_errors(const Session& session) {
  std::set<std::string> messages;
  for (const auto& instance : session.plugins())
    for (const lumen::Problem& problem : instance->problems())
      if (problem.severity == lumen::Severity::error) messages.insert(instance->id() + ": " + problem.message);
  return messages;
}

}  // namespace

std::string LiveFrameCheck::try_frame() {
  if (workshop_.session().views().empty()) return {};
  gl_errors();  // what was there before is not the candidate's
  const std::set<std::string> before = reported_errors(workshop_.session());
  try {
    ViewRenderer& view = workshop_.view();
    view.draw();
    for (const std::string& message : reported_errors(workshop_.session()))
      if (!before.contains(message)) return message;
    if (std::string errors = gl_errors(); !errors.empty()) return errors + " while drawing";
    const std::vector<float> pixels = view.picture().download();
    if (std::any_of(pixels.begin(), pixels.end(), [](float value) { return std::isnan(value); })) return "NaN in the picture";
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

void LiveFrameCheck::shaders_changed(const std::vector<std::filesystem::path>& files) { workshop_.shaders().changed(files); }

}  // namespace lumenshop
