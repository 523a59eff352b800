// What a call outside of the loop throws that can't be done: the message says what, where and what to do.
#pragma once

#include <stdexcept>

#ifndef __cpp_exceptions
#error \
    "cca: parameters and files that are refused are thrown, between beats and never within one: compile without -fno-exceptions"
#endif

namespace cca {

struct refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cca
