// Interpreters with one mistake each. The comparison must see every one of them: a check that was never seen
// to fail proves nothing.
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
