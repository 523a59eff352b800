// A file in memory, for readers that take the name of a file.
#pragma once

#include <cstddef>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "must.hpp"

namespace fuzz {

class memory_file {
public:
  memory_file() : file(::memfd_create("cca_fuzz", MFD_CLOEXEC)) { must(file >= 0); }
  memory_file(const memory_file&) = delete;
  memory_file& operator=(const memory_file&) = delete;
  ~memory_file() { ::close(file); }

  std::string name() const { return "/proc/self/fd/" + std::to_string(file); }
  void holds(const void* bytes, std::size_t size) const {
    must(::ftruncate(file, 0) == 0 && ::pwrite(file, bytes, size, 0) == static_cast<ssize_t>(size));
  }

private:
  int file;
};

}  // namespace fuzz
