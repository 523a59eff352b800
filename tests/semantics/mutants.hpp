// Interpreters with one mistake each. The comparison must find every mistake: a check that never failed
// proves nothing.
#pragma once

#include <memory>
#include <vector>

#include "interpreter.hpp"

namespace semantics {

struct mutant {
  const char* mistake;
  std::unique_ptr<interpreter> (*made)(graph);
};

extern const std::vector<mutant> all_mutants;

}  // namespace semantics
