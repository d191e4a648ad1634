#include "helper/limits.h"

#include <cstdio>
#include <memory>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace lumenshop {

namespace {

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  rlimit current{};
  ::getrlimit(resource, &current);
  const rlimit wanted{soft < current.rlim_max ? soft : current.rlim_max, hard < current.rlim_max ? hard : current.rlim_max};
  ::setrlimit(resource, &wanted);
}

}  // namespace

void limit_process() {
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_NOFILE, 256, 256);
}

void limit_probe() {
  limit(RLIMIT_CPU, 2, 3);
  limit_memory(std::uint64_t{1} << 30);
}

void limit_memory(std::uint64_t additional) {
  const rlim_t bytes = data_memory() + additional;
  limit(RLIMIT_DATA, bytes, bytes);
}

std::uint64_t data_memory() {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen("/proc/self/statm", "re"), std::fclose);
  unsigned long pages = 0;
  // size resident shared text lib data
  if (!file || std::fscanf(file.get(), "%*u %*u %*u %*u %*u %lu", &pages) != 1) return 0;
  return std::uint64_t{pages} * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace lumenshop
