/// The host's own CPU time per frame: what is left when the GL does nothing.
#pragma once

#include <optional>

#include "command/samples.h"

namespace lumenshop {

/// Runs this same command line in a child whose driver drops all GL work (Mesa's GALLIUM_NOOP), with --host-cpu.
/// Milliseconds per frame, the driver's own bookkeeping included; nothing if the child failed. Call before any GL.
std::optional<Quartiles> host_cpu_of_child();

}  // namespace lumenshop
