/// Plugins under test: a scene in a few lines, drawn without a window, its pixels as floats.
///
///   lumen::testing::Scene scene({128, 128});
///   scene.surface("ball", lumen::testing::sphere(), R"({"diffuse": "lambert", "diffuse_color": [1, 0, 0]})");
///   scene.add("diffuse.lambert", "lambert");
///   EXPECT_NEAR(scene.layer("diffuse").at(64, 64, 0), 1.0f, 1e-4f);
///
/// All plugins of the installation are there. Link with the host's library (target lumenshop-host). Thread: one.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <lumen/editor.h>
#include <lumen/image.h>
#include <lumen/mesh.h>
#include <lumen/plugin.h>

namespace lumen::testing {

/// Meshes with exact normals, counterclockwise from outside, centered at the origin.
/// A sphere of `segments` meridians and half as many parallels; its points lie on the sphere.
std::shared_ptr<Mesh> sphere(int segments = 64, float radius = 1);
/// A rectangle in the plane z = 0 that faces +z.
std::shared_ptr<Mesh> rectangle(float width = 2, float height = 2);
/// A box with flat faces.
std::shared_ptr<Mesh> box(glm::vec3 size = glm::vec3(2));
/// The mesh moved.
std::shared_ptr<Mesh> moved(const Mesh& mesh, glm::vec3 offset);
/// All triangles in one mesh.
std::shared_ptr<Mesh> joined(const std::vector<std::shared_ptr<Mesh>>& meshes);

/// A layer or a picture. x to the right and y down, in pixels from the top left.
class Pixels {
 public:
  explicit Pixels(std::shared_ptr<const Image> image);
  int width() const { return image_->width; }
  int height() const { return image_->height; }
  int channels() const { return int(image_->channels.size()); }
  float at(int x, int y, int channel = 0) const;  ///< throws Error beyond the picture
  glm::vec3 rgb(int x, int y) const;              ///< the first three channels; missing ones are 0
  glm::vec4 rgba(int x, int y) const;             ///< missing alpha is 1
  const Image& image() const { return *image_; }

 private:
  std::shared_ptr<const Image> image_;
};

/// The largest difference of any channel at any pixel. Throws Error if the sizes differ.
float largest_difference(const Pixels& a, const Pixels& b);

/// A session of its own: view "main" with one sample per pixel; camera "camera", orthographic, 2.2 world units high, at
/// distance 10 from the origin, along -z, so that a unit sphere fills most of the picture; light "front", directional from
/// the eye, white. No occlusion, no compositors.
class Scene {
 public:
  explicit Scene(glm::ivec2 size = {64, 64});
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Adds an instance with these properties (a JSON object) and puts it in its place in the view: renderers, lights,
  /// compositors and interactors at the end of their list; occlusion, transparency and camera instead of what was there.
  /// References to what comes later are well. Throws Error.
  Plugin& add(const std::string& type, const std::string& id, std::string_view properties = "{}");
  /// Adds data made by the test: instance `id` with the output mesh, lines, volume or image. Given again, it replaces it.
  void give(const std::string& id, DataPointer data);
  /// Adds renderer.surface `id` that shows the mesh, which is given as `id`_data.
  void surface(const std::string& id, std::shared_ptr<const Mesh> mesh, std::string_view properties = "{}");

  /// Gives "instance.property" a value: JSON ("0.5", "[1, 0, 0]", {"link": ...}), else a string. Throws Error.
  void set(const std::string& path, std::string_view json_or_text);
  void set_value(const std::string& path, Value value);
  Value value(const std::string& path) const;     ///< through links
  void resize(glm::ivec2 size);

  /// Jobs done, all refinements drawn. Throws Error naming the layers there are.
  Pixels layer(const std::string& name);
  /// The finished picture, linear, associated alpha.
  Pixels picture();
  /// How often the pass ran since the scene began; 0 if there is no such pass.
  int runs(const std::string& pass) const;
  /// All that is wrong, of every severity.
  std::vector<Problem> problems() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumen::testing
