/// A triangle mesh as a lit surface, colored by its material or by an array through a color map. Clusters of triangles
/// that lie outside of the view, or that wholly face away on a closed surface, are not drawn.

#include <lumen/interactor.h>
#include <lumen/renderer.h>

#include "mesh_buffers.h"

namespace {

/// Viridis in nine steps. Smith, van der Walt, A Better Default Colormap for Matplotlib, SciPy 2015. Linear RGB.
lumen::TransferFunction viridis(glm::vec2 range) {
  static constexpr glm::vec3 srgb[] = {{.267f, .005f, .329f}, {.283f, .141f, .458f}, {.254f, .265f, .530f}, {.207f, .372f, .553f}, {.164f, .471f, .558f},
                                       {.128f, .567f, .551f}, {.267f, .749f, .441f}, {.478f, .821f, .318f}, {.993f, .906f, .144f}};
  static constexpr float places[] = {0, .125f, .25f, .375f, .5f, .61f, .78f, .87f, 1};
  lumen::TransferFunction map{.range = range};
  for (int i = 0; i < 9; ++i) map.points.push_back({glm::mix(range.x, range.y, places[i]), glm::vec4(glm::pow(srgb[i], glm::vec3(2.2f)), 1)});
  return map;
}

struct Surface : lumen::Renderer {
  using Renderer::Renderer;

  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "the triangles"}};
  lumen::Property<glm::mat4> transform{this, "transform", glm::mat4(1), {.doc = "object to world"}};
  lumen::Style style{this};
  lumen::Property<lumen::References> splitter{this, "splitter", {}, {.doc = "cut the surface in parts, one after the other; none: whole", .group = "Shading", .accepts = "splitter"}};
  lumen::Property<std::string> color_by{this, "color_by", {}, {.doc = "name of the array that gives the diffuse color; empty: the material's", .group = "Color by array"}};
  lumen::Property<bool> colored{this, "colored", false, {.doc = "show the array's colors; follows color_by unless set", .group = "Color by array", .when = "color_by", .constant = true}};
  lumen::Property<lumen::TransferFunction> color_map{this, "color_map", viridis({0, 1}), {.doc = "value to color; spans the array's range unless set", .group = "Color by array", .when = "colored"}};

  lumen::Property<bool> curved{this, "curved", false, {.doc = "terms see the mesh's array curvature (of filter.curvature), as opacity.contours does; on if it has one, unless set", .group = "Shading", .advanced = true, .constant = true}};

  lumen::Bounds bounds() const override {
    const auto data = mesh.get();
    return data == nullptr ? lumen::Bounds{} : data->bounds().transformed(transform);
  }
  bool colors_itself() const override { return colored && attribute() != nullptr; }
  lumen::TracedSurface traced() const override { return {.mesh = mesh.get(), .object_to_world = transform}; }

  void changed(std::string_view property) override {
    if (property == "mesh" || property == "color_by") {
      buffers_.reset();
      choose_colors();
    }
    if (property == "mesh") curved.set_default(curvature() != nullptr);
    if (property == "curved") buffers_.reset();
  }
  void released() override { buffers_.reset(); }

  void draw(lumen::Draw& draw) override {
    const auto data = mesh.get();
    if (data == nullptr || data->triangles.empty()) return;
    if (buffers_ == nullptr || !buffers_->made_for(draw.groups())) buffers_ = std::make_unique<MeshBuffers>(*data, attribute(), curved ? curvature() : nullptr, draw.groups());
    for (int part = 0; part < int(draw.parts().size()); ++part) {
      draw.use("renderer/surface.glsl", part);
      if (draw.identifies()) buffers_->draw_group(*data, draw.parts()[std::size_t(part)].group, draw);  // primitives are numbered through
      else buffers_->draw(visibility(draw, part), coverage(draw, part));
    }
  }

 private:
  const lumen::Attribute* attribute() const {
    const auto data = mesh.get();
    return data == nullptr || color_by->empty() ? nullptr : data->attribute(*color_by);
  }

  /// The tensors that terms see, or null. They bend away from the normals, without which they would have no sign.
  const lumen::Attribute* curvature() const {
    const auto data = mesh.get();
    const lumen::Attribute* array = data == nullptr || data->normals.empty() ? nullptr : data->attribute("curvature");
    return array != nullptr && array->components == 6 && array->on == lumen::Attribute::On::points ? array : nullptr;
  }

  void choose_colors() {
    const lumen::Attribute* chosen = attribute();
    colored.set_default(chosen != nullptr);
    if (chosen == nullptr) {
      if (!color_by->empty() && mesh.get() != nullptr) report(lumen::Severity::warning, "the mesh has no array '" + *color_by + "'");
      return;
    }
    const std::vector<float> values = shown_values(*chosen);
    glm::vec2 range(std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity());
    for (const float value : values)
      if (std::isfinite(value)) range = {std::min(range.x, value), std::max(range.y, value)};
    if (!(range.x < range.y)) range = std::isfinite(range.x) ? glm::vec2(range.x, range.x + 1) : glm::vec2(0, 1);
    color_map.set_default(viridis(range));
  }

  Visibility visibility(const lumen::Draw& draw, int index) const {
    const lumen::Part& part = draw.parts()[std::size_t(index)];
    Visibility visible{.group = part.group};
    const auto keep = [](std::vector<glm::vec4>& planes, const glm::vec4& plane) { planes.push_back(plane / std::max(glm::length(glm::vec3(plane)), 1e-30f)); };
    const glm::mat4 object_to_world = part.transform * transform.get();
    const glm::mat4 rows = glm::transpose(draw.world_to_clip() * object_to_world);
    for (int i = 0; i < 6; ++i) keep(visible.planes, i % 2 ? rows[3] - rows[i / 2] : rows[3] + rows[i / 2]);
    const glm::mat4 to_object = glm::inverse(object_to_world);
    const glm::mat4 eye_to_world = glm::inverse(draw.camera().view);
    visible.orthographic = draw.camera().orthographic;
    visible.eye = visible.orthographic ? glm::normalize(glm::mat3(to_object) * glm::vec3(-eye_to_world[2])) : glm::vec3(to_object * eye_to_world[3]);
    const bool turned_outward = buffers_->clusters().solid && glm::determinant(glm::mat3(object_to_world)) > 0;
    visible.skip_backs = turned_outward && draw.backs(index) != lumen::Draw::Backs::anywhere && !inside(visible);
    bool outside_cut = false;  // the eye is where the part was cut away
    for (const glm::vec4& plane : part.planes) {
      const glm::vec4 local = glm::transpose(transform.get()) * plane;
      outside_cut = outside_cut || (visible.orthographic ? glm::dot(glm::vec3(local), visible.eye) > 0 : glm::dot(local, glm::vec4(visible.eye, 1)) < 0);
      keep(visible.cuts, local);
    }
    if (visible.skip_backs && draw.backs(index) == lumen::Draw::Backs::behind_openings && outside_cut) {
      const glm::mat4 world_to_object = glm::inverse(transform.get());
      const float scale = std::max({glm::length(world_to_object[0]), glm::length(world_to_object[1]), glm::length(world_to_object[2])});
      for (const glm::vec4& sphere : *part.openings) visible.openings.emplace_back(glm::vec3(world_to_object * glm::vec4(glm::vec3(sphere), 1)), sphere.w * scale);
    }
    return visible;
  }

  Coverage coverage(const lumen::Draw& draw, int index) const {
    const glm::mat4& moved = draw.parts()[std::size_t(index)].transform;
    const lumen::Bounds box = bounds();
    const float reach = glm::length(box.center()) + box.radius() + glm::length(glm::vec3(moved[3])) + glm::length(glm::vec3(glm::inverse(draw.camera().view)[3]));
    return Coverage(draw.world_to_clip(), moved * transform.get(), draw.size(), reach);
  }

  /// From inside, back faces are what one sees.
  bool inside(const Visibility& visible) const {
    const lumen::Bounds box = mesh.get()->bounds();
    return !visible.orthographic && glm::all(glm::greaterThan(visible.eye, box.min)) && glm::all(glm::lessThan(visible.eye, box.max));
  }

  std::unique_ptr<MeshBuffers> buffers_;
};

}  // namespace

LUMEN_PLUGIN(Surface, "renderer.surface", "A triangle mesh as a lit surface, colored by its material or by an array through a color map.")
