/// What a view names, found: the live instances of one picture, in drawing order.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <lumen/camera.h>
#include <lumen/data.h>
#include <lumen/editor.h>
#include <lumen/frame.h>
#include <lumen/part.h>

#include "frame/split_store.h"
#include "model/session.h"
#include "model/view.h"

namespace lumenshop {

struct LitSurface;

struct SceneSurface {
  Instance* instance;
  std::vector<Instance*> splitters = {};
  lumen::Split split = {};                 ///< what they make of it; one whole part until split_surfaces()
  Instance* interior = nullptr;            ///< the splitter that says how its inside looks; null: as its outside
  /// Of the splitters whose shaders remove fragments, those that are prepared for this view, and what they read there.
  std::map<const Instance*, lumen::TextureInputs> prepared = {};
  bool removes() const;                    ///< a splitter's shader removes fragments
};

struct ViewScene {
  View* view = nullptr;
  Instance* camera = nullptr;              ///< null: a camera that fits the scene
  std::vector<Instance*> lights;           ///< at most Shading::light_limit
  std::vector<SceneSurface> opaque, transparent;
  Instance* occlusion = nullptr;
  Instance* transparency = nullptr;
  std::vector<Instance*> compositors;
  std::vector<Instance*> overlays;         ///< interactors that write `color`
  std::vector<Instance*> interactors;
  lumen::Bounds bounds;                    ///< world, surfaces unsplit
  lumen::Bounds split_bounds;              ///< world, parts where they are drawn, once they are split
  std::vector<lumen::Problem> problems;    ///< what cannot be, in words that name the instances

  std::vector<LitSurface> lit_surfaces() const;
};

/// `substitute`: an occlusion or transparency in place of the view's own, a splitter to be left out, or empty. Throws lumen::Error if the session has
/// no such view.
ViewScene find_scene(const Session& session, const std::string& view, const std::string& substitute = {});

/// World bounds of all surfaces of the session, unsplit, that the splitter cuts.
lumen::Bounds bounds_cut_by(const Session& session, const Instance& splitter);

/// Asks the splitters for the parts that the camera's picture has; the view's store keeps what their composition needs. What cannot be split stays whole and is a problem.
void split_surfaces(ViewScene& scene, const lumen::Camera& camera, SplitStore& store);

}  // namespace lumenshop
