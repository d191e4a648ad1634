/// All contracts at once: what the precompiled header of plugins holds.
#pragma once

#include <lumen/compositor.h>
#include <lumen/exporter.h>
#include <lumen/filter.h>
#include <lumen/image.h>
#include <lumen/importer.h>
#include <lumen/interactor.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/occlusion.h>
#include <lumen/renderer.h>
#include <lumen/splitter.h>
#include <lumen/term.h>
#include <lumen/transparency.h>
#include <lumen/volume.h>
