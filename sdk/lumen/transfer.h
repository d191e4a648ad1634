/// Data in one piece of shared memory, so that processes hand it over without copying it again.
///
/// The memory is sealed: nobody can change or shrink it after it was made. The receiver trusts nothing else about it.
/// Thread: any.
#pragma once

#include <cstddef>

#include <lumen/data.h>
#include <lumen/descriptor.h>

namespace lumen {

/// The bytes of shared memory that pack() will take.
std::size_t packed_size(const Data& data);

/// Copies data into sealed shared memory (close-on-exec). Throws Error if the system has none left.
Descriptor pack(const Data& data);

/// The data of a sealed piece of memory, finished (indices and numbers checked); its arrays are views of the mapping, which
/// lives as long as they do. `descriptor` stays the caller's. Throws Error: not sealed, malformed, or what finish() refused.
DataPointer unpack(int descriptor);

}  // namespace lumen
