#include "frame/surface_draw.h"

#include <glm/gtc/type_ptr.hpp>
#include <lumen/renderer.h>
#include <lumen/splitter.h>

#include "frame/hash.h"
#include "frame/surface_text.h"

namespace lumenshop {
namespace {

/// How far planes keep more than they should, of the scene's radius: what two halves clip at one plane must not leave a crack.
constexpr float plane_slack = 2e-6f;

/// A cap's face is the file of a program that draws no renderer's shader.
constexpr const char* cap_file = "cap";

/// The renderer's hand on a pass.
class SurfaceDraw final : public lumen::Draw {
 public:
  SurfaceDraw(const FrameContext& context, const SceneSurface& surface, const SurfaceOutput& output)
      : context_(context), surface_(surface), output_(output), world_to_clip_(context.geometry.world_to_clip()) {
    const auto* renderer = surface.instance->as<lumen::Renderer>(lumen::Kind::renderer);
    mirrored_ = glm::determinant(glm::mat3(renderer->traced().object_to_world)) < 0;
    for (std::size_t i = 0; i < surface.split.parts.size(); ++i) {
      const lumen::Part& part = surface.split.parts[i];
      if (output.what.wanted && !output.what.wanted(surface.instance->id(), part)) continue;
      parts_.push_back(part);
      if (output.what.closed) parts_.back() = {.group = part.group, .removable = false, .openings = std::vector<glm::vec4>{}};
      numbers_.push_back(int(i));
    }
    if (const Instance* interior = surface.interior) look_ = std::get<lumen::Choice>(interior->read(interior->slot_of("interior"))).name;
  }
  ~SurfaceDraw() override {
    for (int i = 0; i < clip_distances_; ++i) glDisable(GLenum(GL_CLIP_DISTANCE0 + i));
  }

  const lumen::Camera& camera() const override { return context_.geometry.camera; }
  const glm::mat4& world_to_clip() const override { return world_to_clip_; }
  glm::ivec2 size() const override { return context_.geometry.size(); }
  bool identifies() const override { return output_.identifies; }
  std::span<const lumen::Part> parts() const override { return parts_; }
  const std::shared_ptr<const std::vector<std::uint32_t>>& groups() const override { return surface_.split.groups; }

  Backs backs(int part) const override {
    const lumen::Part& chosen = parts_.at(std::size_t(part));
    if (!output_.front_suffices || removes(chosen)) return Backs::anywhere;
    if (capped(chosen)) return Backs::hidden;
    if (chosen.openings) return Backs::behind_openings;
    // A group may have been torn out of a closed surface.
    return chosen.planes.empty() && chosen.group < 0 ? Backs::hidden : Backs::anywhere;
  }

  void use(std::string_view shader, int part, std::span<const std::pair<const char*, const lumen::gl::Texture*>> inputs) override {
    const lumen::Part& chosen = parts_.at(std::size_t(part));
    const bool opened = surface_.interior != nullptr && ((!chosen.planes.empty() && !capped(chosen)) || removes(chosen));
    const SurfaceProgram made{.planes = int(chosen.planes.size()), .removes = removes(chosen), .inside = opened,
                              .cut_face = opened && (look_ == "cut_surface" || look_ == "cap")};
    Program& program = current(std::string(shader), part, chosen.planes, inputs, made);
    for (const auto& [name, texture] : inputs) program.bind(name, texture->name());
  }

  void number_from(int first) override { current_->set("lumen_first_primitive", first); }

  /// The caps of the parts that are drawn.
  void draw_caps() {
    for (const lumen::Cap& cap : surface_.split.caps)
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (output_.what.closed || numbers_[i] != cap.part || surface_.interior == nullptr) continue;
        const lumen::Part& part = parts_[i];
        std::vector<glm::vec4> others = part.planes;
        const glm::vec3 normal = -glm::vec3(others[std::size_t(cap.plane)]);
        others.erase(others.begin() + cap.plane);
        Program& program = current(cap_file, int(i), others, {}, {.planes = int(others.size()), .removes = removes(part), .inside = true, .cap = true});
        const glm::vec3 turned = glm::mat3(context_.geometry.camera.view) * glm::mat3(part.transform) * normal;
        program.set("lumen_cap_normal", glm::vec4(glm::normalize(turned), 0));
        context_.caps.draw(cap.shape);
      }
  }

 private:
  static bool capped(const lumen::Part& part) { return part.openings && part.openings->empty(); }
  bool removes(const lumen::Part& part) const { return part.removable && !surface_.prepared.empty(); }

  /// Makes the program current for the part, cut by these planes.
  Program& current(const std::string& file, int part, const std::vector<glm::vec4>& planes, std::span<const std::pair<const char*, const lumen::gl::Texture*>> inputs,
                   const SurfaceProgram& made) {
    const lumen::Part& chosen = parts_[std::size_t(part)];
    Program* program = program_for(file, inputs, made);
    if (program == nullptr) throw lumen::Error(file, "the shader does not compile");
    current_ = program;
    context_.bind(*program);
    context_.values.bind_row(row_binding::own, *surface_.instance);
    context_.shading.bind_style(*surface_.instance);
    program->set("lumen_instance", surface_.instance->number());
    program->set("lumen_part_index", numbers_[std::size_t(part)]);
    program->set("lumen_part", chosen.transform);
    program->set("lumen_first_primitive", 0);
    program->set("lumen_mirrored", mirrored_ != (glm::determinant(glm::mat3(chosen.transform)) < 0) ? 1 : 0);
    program->set("lumen_interior_style", context_.shading.interior_row(*surface_.instance));
    for (int i = 0; i < 8; ++i) (i < made.planes ? glEnable : glDisable)(GLenum(GL_CLIP_DISTANCE0 + i));
    clip_distances_ = made.planes;
    set_planes(*program, planes, chosen.transform);
    if (made.removes) {
      bind_splitters(context_, surface_, *program);
      program->set("lumen_world_to_place", glm::inverse(chosen.transform));
    }
    if (output_.prepare) output_.prepare(*program);
    return *program;
  }

  void set_planes(Program& program, const std::vector<glm::vec4>& planes, const glm::mat4& move) const {
    if (planes.empty()) return;
    const float slack = plane_slack * (context_.geometry.scene_radius + glm::length(context_.scene.bounds.center()));
    std::vector<glm::vec4> keeping, seen;
    const glm::mat4 to_place = glm::inverse(context_.geometry.camera.view * move);
    for (const glm::vec4& plane : planes) {
      keeping.push_back(plane + glm::vec4(0, 0, 0, slack));
      seen.push_back(glm::transpose(to_place) * plane);
      seen.back() /= std::max(glm::length(glm::vec3(seen.back())), 1e-30f);
    }
    const auto upload = [&](const char* name, const std::vector<glm::vec4>& values) {
      glProgramUniform4fv(program.name(), glGetUniformLocation(program.name(), name), GLsizei(values.size()), glm::value_ptr(values.front()));
    };
    upload("lumen_planes", keeping);
    upload("lumen_view_planes", seen);
  }

  Program* program_for(const std::string& file, std::span<const std::pair<const char*, const lumen::gl::Texture*>> inputs, const SurfaceProgram& made) {
    const Instance& instance = *surface_.instance;
    Hash hash;
    hash.add(file).add(made.planes).add(made.removes).add(made.inside).add(made.cut_face).add(properties_signature(instance)).add(output_.signature);
    if (made.removes) hash.add(splitters_signature(surface_));
    for (const auto& [name, texture] : inputs) hash.add(std::string_view(name));
    std::string slot = instance.id() + " " + output_.name;
    if (made.planes > 0) slot += " cut by " + std::to_string(made.planes);
    if (made.removes) slot += " removed by " + std::to_string(surface_.prepared.size());
    if (made.cap) slot += " caps";
    return context_.shaders.program(slot, hash.value(), [&](ProgramText& vertex, ProgramText& fragment) {
      write_surface_text(vertex, fragment, surface_, file, inputs, made);
      output_.write(fragment, instance);
    });
  }

  const FrameContext& context_;
  const SceneSurface& surface_;
  const SurfaceOutput& output_;
  glm::mat4 world_to_clip_;
  std::vector<lumen::Part> parts_;   ///< that are wanted
  std::vector<int> numbers_;         ///< of these among all parts
  std::string look_;                 ///< of the inside
  bool mirrored_ = false;
  int clip_distances_ = 0;
  Program* current_ = nullptr;
};

}  // namespace

void draw_surface(const FrameContext& context, const SceneSurface& surface, const SurfaceOutput& output) {
  try {
    SurfaceDraw draw(context, surface, output);
    if (draw.parts().empty()) return;
    surface.instance->as<lumen::Renderer>(lumen::Kind::renderer)->draw(draw);
    draw.draw_caps();
  } catch (const std::exception& error) {
    surface.instance->report(lumen::Severity::error, error.what());
  }
}

}  // namespace lumenshop
