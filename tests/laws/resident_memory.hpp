// How much memory this process has, for what must not grow.
#pragma once

#include <unistd.h>

#include <cstdio>

namespace laws {

// In KiB; 0: the system does not say.
inline long resident_memory() {
  long size = 0, pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld %ld", &size, &pages) != 2) pages = 0;
    std::fclose(file);
  }
  return pages * (::sysconf(_SC_PAGESIZE) / 1024);
}

}  // namespace laws
