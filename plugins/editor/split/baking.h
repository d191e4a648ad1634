/// A surface whose cut is made in image space, in every frame, or in object space, once: what is there, and the change between both.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <lumen/editor.h>
#include <lumen/mesh.h>

/// A surface with a plane of its own.
struct CutSurface {
  std::string surface, plane;           ///< renderer and splitter.plane
  std::string filter;                   ///< the filter.split that cuts it once; or did, if it is cut in each frame; empty: none yet
  bool once = false;
  std::shared_ptr<const lumen::Mesh> mesh;  ///< before the cut; null: not there yet
};

/// All of the session. A surface with several planes is there several times.
std::vector<CutSurface> cut_surfaces(const lumen::Workbench& workbench);

/// Cuts the surface by a filter.split instead of its splitter: one with the splitter's values, linked. One undo step. Throws Error.
void cut_once(lumen::Workbench& workbench, const CutSurface& cut);
/// The way back; the filter stays, switched off. One undo step. Throws Error.
void cut_each_frame(lumen::Workbench& workbench, const CutSurface& cut);

/// Main memory of what the filter made; 0: nothing yet.
std::size_t bytes_of_halves(const lumen::Workbench& workbench, const std::string& filter);
