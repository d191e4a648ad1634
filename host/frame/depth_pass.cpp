#include "frame/depth_pass.h"

#include <limits>
#include <span>

#include <lumen/gl/framebuffer.h>

#include "frame/surface_draw.h"

namespace lumenshop {
namespace {

/// Leaves out fragments by chance: Enderton, Sintorn, Shirley, Luebke, Stochastic Transparency, I3D 2010. Chances come from
/// pixel and depth: they are the same in every run.
void sample_fragments(SurfaceOutput& output) {
  output.name = "depth sample";
  output.write = [](ProgramText& text, const Instance&) {
    text.include("lib/noise.glsl");
    text.generated("layout(location = 0) out float lumen_depth;\nuniform float lumen_share;\nuniform int lumen_sample;\n"
                   "void main() {\n  lumen_depth = -lumen_surface().position.z;\n"
                   "  ivec2 fragment = ivec2(gl_FragCoord.xy) + ivec2(lumen_sample << 16, floatBitsToInt(lumen_depth));\n"
                   "  if (hash(fragment).x >= lumen_share) discard;\n}\n");
  };
  output.prepare = [share = output.what.share, sample = output.what.sample](Program& program) {
    program.set("lumen_share", share);
    program.set("lumen_sample", sample);
  };
}

}  // namespace

void draw_depth(const FrameContext& context, const lumen::Camera& camera, const lumen::gl::Texture& depth, const lumen::DepthDraw& what) {
  const ViewScene& scene = context.scene;
  const ViewGeometry geometry = make_geometry(camera, {.picture = depth.size(), .size = depth.size()}, scene.bounds, scene.split_bounds, {}, 0);
  const lumen::gl::Buffer block(std::as_bytes(std::span(&geometry.block, 1)));
  const FrameContext other{context.session, context.shaders, context.values, context.shading, context.log,
                           context.caps,    context.layers,  context.centers, context.scene,  geometry,        context.main,    block,
                           context.light_block, context.to_centers, context.geometry_key, context.light_key, context.lights, context.set};
  const lumen::gl::Texture buffer(lumen::Format::depth32F, depth.size());
  const lumen::gl::Texture* const targets[] = {&depth};
  const lumen::gl::Framebuffer target(targets, &buffer);
  target.bind();
  glViewport(0, 0, depth.size().x, depth.size().y);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(what.farthest ? GL_GREATER : GL_LESS);
  glDepthMask(GL_TRUE);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float nothing[4] = {what.farthest ? -infinity : infinity, 0, 0, 0}, limit = what.farthest ? 0 : 1;
  glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, nothing);
  glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &limit);
  SurfaceOutput output{.name = "depth", .write = [](ProgramText& text, const Instance&) {
    text.generated("layout(location = 0) out float lumen_depth;\nvoid main() { lumen_depth = -lumen_surface().position.z; }\n");
  }, .what = what};
  if (what.share < 1) sample_fragments(output);
  for (const SceneSurface& surface : scene.opaque) draw_surface(other, surface, output);
  glDepthFunc(GL_LESS);
}

}  // namespace lumenshop
