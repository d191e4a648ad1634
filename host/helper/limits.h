/// What a child of the helper process may use.
#pragma once

#include <cstdint>

namespace lumenshop {

void limit_process();                         ///< no core files, few descriptors, no new privileges
void limit_probe();                           ///< 2 s of processor time, 1 GiB
void limit_memory(std::uint64_t additional);  ///< bytes beyond what is held now
std::uint64_t data_memory();                  ///< bytes of private writable memory held now

}  // namespace lumenshop
