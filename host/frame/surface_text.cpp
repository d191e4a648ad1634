#include "frame/surface_text.h"

#include <set>

#include <lumen/splitter.h>

#include "frame/hash.h"
#include "frame/layer_text.h"

namespace lumenshop {
namespace {

/// A splitter whose shader removes fragments.
struct Remover {
  Instance* instance;
  std::string file, prefix;
  int binding;  ///< the first has its row bound, the others look theirs up
  std::string row;
  const lumen::TextureInputs& inputs;
};

std::vector<Remover> removers_of(const SceneSurface& surface) {
  std::vector<Remover> removers;
  for (Instance* splitter : surface.splitters) {
    const auto prepared = surface.prepared.find(splitter);
    if (prepared == surface.prepared.end()) continue;
    const std::string file = shader_file(*splitter), number = std::to_string(removers.size());
    removers.push_back({splitter, file, prefix_of(file) + number + "_", removers.empty() ? row_binding::splitter : row_binding::any, "lumen_remover_" + number, prepared->second});
  }
  return removers;
}

/// lumen_removed(s) and lumen_cut_normal(s) over all splitters that remove.
void write_removal(ProgramText& fragment, const SceneSurface& surface) {
  fragment.include("lib/values.glsl");
  fragment.include("lib/splitter.glsl");
  std::string removed, normal;
  std::set<std::string> declared;
  for (const Remover& remover : removers_of(surface)) {
    for (const auto& [name, texture] : remover.inputs)
      if (!declared.insert(name).second) throw lumen::Error(surface.instance->id(), std::string("two of its splitters read a texture '") + name + "'", "give it one of that type");
    fragment.generated("uniform int " + remover.row + ";\n" + inputs_text(remover.inputs) + properties_text(*remover.instance, remover.prefix, remover.binding));
    fragment.file(remover.file, {"removed", "cut_normal"}, remover.prefix);
    const std::string arguments = "(" + remover.prefix + "load(" + remover.row + "), s)";
    removed += "  if (" + remover.prefix + "removed" + arguments + ") return true;\n";
    if (normal.empty()) normal = remover.prefix + "cut_normal" + arguments;
  }
  fragment.generated("uniform mat4 lumen_world_to_place;\nbool lumen_removed(Surface s) {\n" + removed + "  return false;\n}\n"
                     "vec3 lumen_removal_normal(Surface s) { return mat3(lumen.view) * " + normal + "; }\n");
}

/// lumen_cut(world) for vertices; `planes` clip distances.
std::string cut_text(int planes) {
  if (planes == 0) return "void lumen_cut(vec3 world) {}\n";
  const std::string count = std::to_string(planes);
  return "uniform vec4 lumen_planes[" + count + "];\nout float gl_ClipDistance[" + count + "];\n"
         "void lumen_cut(vec3 world) { for (int i = 0; i < " + count + "; ++i) gl_ClipDistance[i] = dot(lumen_planes[i], vec4(world, 1)); }\n";
}

/// lumen_face_normal(s): of the face by which the eye's ray last came in before it met the inside at s, toward the eye.
std::string face_text(const SurfaceProgram& program) {
  std::string text = "vec3 lumen_face_normal(Surface s) {\n  vec3 normal = " + std::string(program.removes ? "lumen_removal_normal(s)" : "s.normal") + ";\n";
  if (program.planes == 0) return text + "  return normal;\n}\n";
  const std::string count = std::to_string(program.planes);
  return "uniform vec4 lumen_view_planes[" + count + "];\n" + text +
         "  float nearest = 1e30;\n"
         "  for (int i = 0; i < " + count + "; ++i) {\n"
         "    float towards = -dot(lumen_view_planes[i].xyz, s.to_eye), way = dot(lumen_view_planes[i], vec4(s.position, 1)) / max(towards, 1e-20);\n"
         "    if (towards > 0.0 && way < nearest) { nearest = way; normal = -lumen_view_planes[i].xyz; }\n"
         "  }\n  return normal;\n}\n";
}

constexpr const char* removal = "  s.place = (lumen_world_to_place * vec4(to_world(s.position), 1)).xyz;\n  if (lumen_removed(s)) discard;\n";

std::string renderer_surface_text(const std::string& prefix, const SurfaceProgram& program) {
  std::string text = "Surface lumen_surface() {\n  Surface s;\n"
                     "  s.instance = lumen_instance;\n  s.style = lumen_instance;\n  s.part = lumen_part_index;\n  s.primitive = 0;\n  s.curvature = mat3(0);\n"
                     "  s.front = gl_FrontFacing != (lumen_mirrored != 0);\n"
                     "  lumen_own_material(s);\n  " + prefix + "surface(" + prefix + "load(0), s);\n  s.to_eye = to_eye(s.position);\n";
  text += "  s.normal = lumen_facing(s.normal, s.to_eye, cross(dFdx(s.position), dFdy(s.position)));\n";
  if (program.removes) text += removal;
  if (program.inside) {
    text += "  if (!s.front) {\n    s.style = lumen_interior_style;\n    lumen_material(s);\n";
    if (program.cut_face) text += "    s.normal = lumen_face_normal(s);\n";
    text += "  }\n";
  }
  return text + "  return s;\n}\n";
}

std::string cap_surface_text(const SurfaceProgram& program) {
  return std::string("in vec3 lumen_cap_position;\nuniform vec4 lumen_cap_normal;\nSurface lumen_surface() {\n  Surface s;\n"
                     "  s.instance = lumen_instance;\n  s.style = lumen_interior_style;\n  s.part = lumen_part_index;\n  s.primitive = -1;\n  s.front = true;\n  s.curvature = mat3(0);\n"
                     "  lumen_material(s);\n  s.position = lumen_cap_position;\n  s.to_eye = to_eye(s.position);\n") +
         (program.removes ? removal : "") +
         "  s.normal = dot(lumen_cap_normal.xyz, s.to_eye) < 0.0 ? -lumen_cap_normal.xyz : lumen_cap_normal.xyz;\n  return s;\n}\n";
}

}  // namespace

void write_surface_text(ProgramText& vertex, ProgramText& fragment, const SceneSurface& surface, const std::string& file,
                        std::span<const std::pair<const char*, const lumen::gl::Texture*>> inputs, const SurfaceProgram& program) {
  const std::string prefix = prefix_of(file);
  const std::string properties = program.cap ? std::string() : properties_text(*surface.instance, prefix, row_binding::own);
  vertex.generated(cut_text(program.planes));
  vertex.include("lib/values.glsl");
  if (program.cap) {
    vertex.include("lib/geometry.glsl");
    vertex.generated("layout(location = 0) in vec3 position;\nout vec3 lumen_cap_position;\n"
                     "void main() {\n  lumen_cap_position = to_view(split(position));\n  gl_Position = project(lumen_cap_position);\n}\n");
  } else {
    vertex.generated(properties);
    vertex.file(file, {"vertex"}, prefix);
    vertex.generated("void main() { " + prefix + "vertex(" + prefix + "load(0)); }\n");
  }

  fragment.generated("uniform int lumen_instance, lumen_part_index, lumen_first_primitive, lumen_interior_style, lumen_mirrored;\n"
                     "int primitive_number() { return lumen_first_primitive + gl_PrimitiveID; }\nvoid lumen_cut(vec3 world) {}\n");
  for (const auto& [name, texture] : inputs) fragment.generated(std::string("uniform sampler2D ") + name + ";");
  fragment.include("lib/values.glsl");
  fragment.include("lib/frame.glsl");
  fragment.include("host/styles.glsl");
  if (program.removes) write_removal(fragment, surface);
  if (program.cap) {
    fragment.generated(cap_surface_text(program));
    return;
  }
  if (program.cut_face) fragment.generated(face_text(program));
  fragment.generated(properties);
  fragment.file(file, {"surface"}, prefix);
  fragment.generated(renderer_surface_text(prefix, program));
}

std::uint64_t splitters_signature(const SceneSurface& surface) {
  Hash hash;
  for (const Remover& remover : removers_of(surface)) {
    hash.add(remover.file).add(properties_signature(*remover.instance));
    for (const auto& [name, texture] : remover.inputs) hash.add(std::string_view(name)).add(texture->format());
  }
  return hash.value();
}

void bind_splitters(const FrameContext& context, const SceneSurface& surface, Program& program) {
  for (const Remover& remover : removers_of(surface)) {
    if (remover.binding != row_binding::any) context.values.bind_row(remover.binding, *remover.instance);
    program.set(remover.row, context.values.row_of(*remover.instance));
    for (const auto& [name, texture] : remover.inputs) program.bind(name, texture->name());
  }
  program.set("lumen_eye_to_world", glm::inverse(context.geometry.camera.view));
  program.set("lumen_main_view", context.main.camera.view);
  program.set("lumen_main_unproject", context.main.block.unproject);
  program.set("lumen_main_orthographic", context.main.camera.orthographic ? 1 : 0);
}

}  // namespace lumenshop
