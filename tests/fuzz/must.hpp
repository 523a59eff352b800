// What must hold, whatever the bytes are: else the fuzzer has found something.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <source_location>

namespace fuzz {

inline void must(bool holds, const std::source_location where = std::source_location::current()) {
  if (holds) return;
  std::fprintf(stderr, "%s:%u does not hold\n", where.file_name(), static_cast<unsigned>(where.line()));
  std::abort();
}

}  // namespace fuzz
