#include "frame/lighting_pass.h"

#include <lumen/gl/framebuffer.h>

#include "frame/hash.h"

namespace lumenshop {

Visibility visibility_of(const FrameContext& context) {
  Visibility visibility;
  if (context.scene.occlusion == nullptr) return visibility;
  const auto* occlusion = context.scene.occlusion->as<lumen::Occlusion>(lumen::Kind::occlusion);
  visibility.attenuates = occlusion->attenuates();
  for (const lumen::Writes* writes : occlusion->writes())
    if (writes->layer() == "occlusion" || writes->layer() == "illumination") visibility.layer = writes->layer();
  if (context.centers.find(visibility.layer) == nullptr) visibility.layer.clear();
  return visibility;
}

void run_lighting_pass(const FrameContext& context, LightingOutput output) {
  LayerStore& layers = context.layers;
  const glm::ivec2 size = context.geometry.size();
  Visibility visibility = visibility_of(context);
  if (output == LightingOutput::apart) visibility.layer.clear();
  const lumen::gl::Texture* albedo = layers.find("albedo");
  std::vector<const char*> names = {"lit"};
  if (output == LightingOutput::summands) names.insert(names.end(), {"ambient", "diffuse", "specular"});
  if (output == LightingOutput::apart) names.push_back("open");
  std::vector<const lumen::gl::Texture*> targets;
  for (const char* name : names) targets.push_back(&layers.allocate(name, lumen::Format::RGBA32F, size));

  // With one renderer its style is read at constant places; with several it is looked up per pixel.
  const Instance* only = context.shading.single();
  const std::uint64_t signature = Hash()
                                      .add(context.shading.signature(context.shaders))
                                      .add(visibility.layer)
                                      .add(visibility.attenuates)
                                      .add(albedo != nullptr)
                                      .add(output)
                                      .add(context.lights)
                                      .add(only == nullptr)
                                      .value();
  const bool nothing_to_light = context.scene.opaque.empty();
  Hash key;
  key.add(size).add(output).add(layers.revision("normal"));
  if (!nothing_to_light)
    key.add(signature)
        .add(context.geometry_key)
        .add(context.light_key)
        .add(context.shading.opaque_revision())
        .add(visibility.layer.empty() ? 0 : context.centers.revision(visibility.layer))
        .add(context.shaders.revision("host/lighting.glsl"));
  context.log.run("lighting", context.set, key.value(), [&] {
    const lumen::gl::Framebuffer target(targets, layers.find("depth_buffer"));
    target.bind();
    glViewport(0, 0, size.x, size.y);
    const float nothing[4] = {};
    for (std::size_t i = 0; i < targets.size(); ++i) glClearNamedFramebufferfv(target.name(), GL_COLOR, GLint(i), nothing);
    for (const char* name : names) layers.drawn(name);
    if (nothing_to_light) return;
    Program* program = context.shaders.program("lighting", signature, [&](ProgramText& vertex, ProgramText& fragment) {
      vertex.generated(fullscreen_triangle);
      fragment.generated("uniform sampler2D lumen_layer_normal, lumen_layer_depth, lumen_layer_albedo, lumen_visibility_layer;\nuniform vec4 lumen_to_centers;");
      fragment.include("host/styles.glsl");
      fragment.include("host/lighting.glsl");
      context.shading.write(fragment, visibility.attenuates, context.lights, false, only);
      std::string main;
      for (std::size_t i = 0; i < names.size(); ++i) main += "layout(location = " + std::to_string(i) + ") out vec4 lumen_" + names[i] + ";\n";
      main += "void main() {\n  vec2 uv = gl_FragCoord.xy / lumen.size.xy;\n  Surface s = surface_at(uv);\n";
      main += only == nullptr ? "  lumen_material(s);\n" : "  lumen_own_material(s);\n";
      if (albedo != nullptr) main += "  s.diffuse_color = textureLod(lumen_layer_albedo, uv, 0.0).rgb;\n";
      main += "  vec3 visibility = vec3(1);\n";
      if (!visibility.layer.empty()) main += "  vec4 seen = textureLod(lumen_visibility_layer, uv * lumen_to_centers.xy + lumen_to_centers.zw, 0.0);\n";
      if (visibility.layer == "occlusion") main += "  visibility -= seen.r;\n";
      if (visibility.layer == "illumination") main += "  visibility = seen.rgb;\n";
      main += "  Lighting l = shade(s, visibility);\n";
      if (output == LightingOutput::apart) {
        const char* const attenuated = visibility.attenuates == lumen::Attenuates::ambient      ? "l.ambient"
                                       : visibility.attenuates == lumen::Attenuates::everything ? "l.ambient + l.diffuse + l.specular"
                                                                                                : "l.ambient + l.diffuse";
        main += std::string("  lumen_open = vec4(") + attenuated + ", 0);\n  lumen_lit = vec4(l.ambient + l.diffuse + l.specular - lumen_open.rgb, 1);\n";
      } else {
        main += "  lumen_lit = vec4(l.ambient + l.diffuse + l.specular, 1);\n";
        for (std::size_t i = 1; i < names.size(); ++i) main += std::string("  lumen_") + names[i] + " = vec4(l." + names[i] + ", 1);\n";
      }
      fragment.generated(main + "}\n");
    });
    if (program == nullptr) return;
    context.bind(*program);
    if (only != nullptr) context.shading.bind_style(*only);
    program->bind("lumen_layer_normal", layers.find("normal")->name());
    program->bind("lumen_layer_depth", layers.find("depth")->name());
    if (albedo != nullptr) program->bind("lumen_layer_albedo", albedo->name());
    if (!visibility.layer.empty()) {
      program->bind("lumen_visibility_layer", context.centers.find(visibility.layer)->name());
      program->set("lumen_to_centers", context.to_centers);
    }
    // Only covered pixels: the triangle lies at the far plane, behind what was drawn.
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    draw_fullscreen_triangle();
    glDepthMask(GL_TRUE);
  });
}

}  // namespace lumenshop
