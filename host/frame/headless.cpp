#include "frame/headless.h"

#include <cstdio>

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <lumen/error.h>

namespace lumenshop {

struct HeadlessContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

namespace {

[[noreturn]] void fail(const char* what) {
  char reason[64];
  std::snprintf(reason, sizeof reason, "%s failed (EGL error 0x%04x)", what, eglGetError());
  throw lumen::Error("OpenGL", reason, "a driver with OpenGL 4.5 and EGL surfaceless is needed (Debian: libegl1, libgl1-mesa-dri)");
}

}  // namespace

HeadlessContext::HeadlessContext() : state_(std::make_unique<State>()) {
  state_->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (state_->display == EGL_NO_DISPLAY || !eglInitialize(state_->display, nullptr, nullptr)) fail("opening the surfaceless display");
  if (!eglBindAPI(EGL_OPENGL_API)) fail("choosing OpenGL");
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  state_->context = eglCreateContext(state_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (state_->context == EGL_NO_CONTEXT) fail("making an OpenGL 4.5 core context");
  if (!eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context)) fail("making the context current");
}

HeadlessContext::~HeadlessContext() {
  eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(state_->display, state_->context);
  eglTerminate(state_->display);
}

}  // namespace lumenshop
