// EXPECT: run\.not_sent: a run returns `path`, which cannot go to another rank: return a value that is trivially copyable
// Of a run that goes in steps it is what its `result()` returns; its controller and its world stay where they
// are.
#include <cstddef>
#include <vector>

#include <cca/base/reflect.hpp>
#include <cca/mpi/ranks.hpp>

#if CCA_REJECT
struct path {
  std::vector<double> heights;
};
#else
struct path {
  BOOST_HANA_DEFINE_STRUCT(path, (std::vector<double>, heights));
};
#endif

struct falling {
  double height = 1;
  std::vector<double> heights;
  double& world() { return height; }
  bool step() {
    heights.push_back(height *= 0.9);
    return height > 0.1;
  }
  path result() {
    path all;
    all.heights = heights;
    return all;
  }
};

std::vector<path> paths(cca::mpi::ranks& all) {
  return all.rollouts(10, [](std::size_t) { return falling{}; });
}
