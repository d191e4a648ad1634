/// How a surface gets a material: a lit-sphere term of its own, linked to an importer of the picture.
#pragma once

#include <lumen/editor.h>

#include "material.h"

/// Whether the instance is a surface that is lit by terms.
bool takes_materials(const lumen::Workbench& workbench, const std::string& instance);

/// One undo step. A surface that was not shaded by pictures before gets the whole look: what the front and back light
/// leave dark becomes its ambient term, and a highlight that the picture may already show goes. Throws lumen::Error; then
/// nothing has changed.
void assign(lumen::Workbench& workbench, const std::string& surface, Role role, const Material& material);

/// The instance that gives the surface its picture for this role, or empty.
std::string picture_of(const lumen::Workbench& workbench, const std::string& surface, Role role);

/// Whether the instance makes this material.
bool makes(const lumen::Workbench& workbench, const std::string& instance, const Material& material);
