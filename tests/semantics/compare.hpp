// The comparison of one run on the library with the interpreter, and of the mutants with it.
#pragma once

#include <string>
#include <vector>

#include "coverage.hpp"
#include "description.hpp"
#include "mutants.hpp"
#include "outcome.hpp"

namespace semantics {

class comparison {
public:
  void add(const std::string& text, const outcome& o, int beats);
  // True: no difference. If it is to be a proof, also: everything was exercised, and every mutant caught. Of
  // environments or modes: what matters there was exercised, and every mutant with a mistake about that
  // caught.
  enum class proof { none, of_all, of_environments, of_modes };
  bool report(proof wanted) const;

private:
  void tell(const std::string& text, const outcome& o, const interpreter& i, long at);

  coverage seen;
  long differences = 0;
  std::vector<long> caught_in = std::vector<long>(all_mutants.size());
};

long difference(const log& a, const log& b);
std::unique_ptr<interpreter> interpreted(const graph& g, int beats);

}  // namespace semantics
