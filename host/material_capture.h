/// A surface's look as a picture of a sphere, for lit-sphere terms.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <lumen/image.h>

#include "model/session.h"

namespace lumenshop {

class PluginFactory;
class Scheduler;
class ShaderLibrary;

/// Renders a sphere with the surface's ambient, diffuse and specular term and its material, under the view's lights, as the
/// view's camera turns them; orthographic, without occlusion and opacity. Lights at a point shine as they do at the surface's
/// center.
///
/// The picture is equidistant: the angle between normal and eye grows evenly from 0 in the middle to a right angle at the
/// edges, so that the rim is as fine as the rest; beyond it the edge goes on outward. Linear RGB.
///
/// `types` makes the plugins. `shaders`: of its own, or the view's programs would give way to this one's. GL context current.
/// Throws lumen::Error.
std::shared_ptr<lumen::Image> captured_material(const Session& session, const std::string& surface, const std::string& view, PluginFactory& types,
                                                ShaderLibrary& shaders, int size = 512);

/// What the names of equidistant pictures end with, before the extension: "wall.equidistant.exr".
inline constexpr const char* equidistant_mark = ".equidistant";

/// Writes a captured material into the folder, which is made if need be, under a name that is free. Throws lumen::Error.
std::filesystem::path save_material(Scheduler& scheduler, Instance& exporter, std::shared_ptr<lumen::Image> picture, const std::filesystem::path& folder,
                                    const std::string& name);

}  // namespace lumenshop
