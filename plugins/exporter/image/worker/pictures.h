/// Pictures through OpenImageIO.
#pragma once

#include <lumen/image.h>
#include <lumen/worker.h>

/// Arguments: path (its extension is the format), depth ("8", "float", else what suits the format), name (of the file in
/// messages). One input, an Image: 8-bit formats get its numbers clamped to 0..1 and rounded, float formats 32 bit as they are.
/// Throws lumen::Error.
void write_picture(const lumen::WorkerRequest& request, lumen::WorkerProgress progress);

/// Argument: path. 8- and 16-bit color channels are decoded from sRGB. At most 2^28 numbers. Throws lumen::Error.
void read_picture(const lumen::WorkerRequest& request, lumen::WorkerReply& reply, lumen::WorkerProgress progress);
