/// Measured numbers and what is said of them.
#pragma once

#include <vector>

namespace lumenshop {

/// Quartiles by linear interpolation. All 0 without samples.
struct Quartiles {
  double first = 0, median = 0, third = 0;
  double spread() const { return third - first; }
};
Quartiles quartiles_of(std::vector<double> samples);

/// CPU seconds that the calling thread has used so far.
double thread_cpu_seconds();

/// Peak main memory of this process so far, bytes.
std::size_t peak_memory();

}  // namespace lumenshop
