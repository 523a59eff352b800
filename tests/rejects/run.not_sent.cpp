// EXPECT: run\.not_sent: a run returns `step`, which cannot go to another rank: return a value that is trivially copyable
// What a run returns goes from its rank to all others as bytes: numbers, vectors of them, and structs whose
// fields are stated. A pointer means nothing there.
#include <cstddef>
#include <vector>

#include <cca/base/reflect.hpp>
#include <cca/mpi/ranks.hpp>

#if CCA_REJECT
struct step {
  std::vector<double> path;
};
#else
struct step {
  BOOST_HANA_DEFINE_STRUCT(step, (std::vector<double>, path));
};
#endif

std::vector<step> steps(cca::mpi::ranks& all) {
  return all.rollouts(10, [](std::size_t) { return step{}; });
}
