// A component that has finished returns `done`: it stops itself, and fires again when somebody starts it. Its
// node has the strategy `stoppable` (strategy.not_stoppable). What it returns beside is published.
#pragma once

#include <cca/base/compiler.hpp>

namespace cca {

class done {
public:
  constexpr done() = default;
  constexpr done(bool is_so) : so(is_so) {}

  explicit constexpr operator bool() const { return so; }

private:
  bool so = false;
};

}  // namespace cca
