// The exception of calls between beats that can't be done. Its message says what, where and what to do.
#pragma once

#include <cca/base/compiler.hpp>

#include <stdexcept>

#ifndef __cpp_exceptions
#error "cca throws refused parameters and files, between beats only: compile without -fno-exceptions"
#endif

namespace cca {

struct refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cca
