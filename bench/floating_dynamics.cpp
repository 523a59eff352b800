// The dynamics of a quadruped with a free base: recorded at compile time, and by the loops over its links
// that larger bodies use.
//
//   floating_dynamics check                      compares all results; exits with 1 if they differ
//   floating_dynamics list                       the names of the quantities
//   floating_dynamics NAME cca|loops ROUNDS      computes one quantity this many times, for another state each
//                                                time (under callgrind)
//   floating_dynamics NAME allocations           the allocations of 1000 rounds of the library
//
// Each round begins with the angles. "sines" is what they take: the arithmetic is the rest.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "quadruped.hpp"

extern "C" long bench_allocations();

namespace bench {

constexpr int n = cca::axes_of<quadruped>::count;
using vector = Eigen::Matrix<double, n, 1>;
using pose = cca::body_pose<quadruped>;
namespace cd = cca::detail;
constexpr const auto& links = cd::weighed_links_of<quadruped>;

struct state {
  vector q, dq, input;  // the input: accelerations or torques
  cca::base_motion base;
};

auto placed(const state& s) {
  std::array<cd::placed_link, links.size()> all;
  cd::place_links(links, s.q, all);
  return all;
}
template <class Load>
Eigen::Matrix<double, 6 + n, 1> joined(const vector& joints, const Load& base) {
  Eigen::Matrix<double, 6 + n, 1> all;
  all << base, joints;
  return all;
}

struct sines {
  static constexpr const char* name = "sines";
  static Eigen::Matrix<double, 2 * n, 1> cca(const state& s) {
    return Eigen::Matrix<double, 2 * n, 1>::Map(pose(s.q).joint_values());
  }
  static Eigen::Matrix<double, 2 * n, 1> loops(const state& s) {
    Eigen::Matrix<double, 2 * n, 1> both;
    for (int i = 0; i < n; ++i) both[i] = std::cos(s.q[i]), both[n + i] = std::sin(s.q[i]);
    return both;
  }
};
struct inverse {
  static constexpr const char* name = "inverse dynamics";
  static auto cca(const state& s) {
    const auto r = cca::inverse_dynamics(pose(s.q), s.dq, s.input, s.base);
    return joined(r.torques, r.wrench);
  }
  static auto loops(const state& s) {
    const auto r = cd::newton_euler<links.size(), n>(links, placed(s), cd::base_inertia_of<quadruped>(), s.dq,
                                                     s.input, s.base);
    return joined(r.torques, r.wrench);
  }
};
struct mass_matrix {
  static constexpr const char* name = "mass matrix";
  static auto cca(const state& s) { return cca::floating_mass_matrix(pose(s.q)); }
  static auto loops(const state& s) {
    return cd::whole_inertia<n>(
        links, cd::composite_bodies<links.size()>(links, placed(s), cd::base_inertia_of<quadruped>()));
  }
};

// Another state in each round, without a cost that counts.
state next(int round) {
  state s;
  for (int i = 0; i < n; ++i) {
    const double x = (round * n + i) * 0.61803398875;
    s.q[i] = 2 * (x - std::floor(x)) - 1;
    s.dq[i] = 0.7 - s.q[i];
    s.input[i] = 3 * s.q[i] + 1;
  }
  s.base = {{0.3, -0.5, -9.7}, {0.4, s.q[0], 0.3}, {1, 2, s.q[1]}, {0.5, 0.1, -2}};
  return s;
}

template <class Quantity>
[[gnu::noinline]] auto once_cca(const state& s) {
  return Quantity::cca(s);
}
template <class Quantity>
[[gnu::noinline]] auto once_loops(const state& s) {
  return Quantity::loops(s);
}

template <class Quantity>
bool check() {
  for (int i = 0; i < 100; ++i) {
    const state s = next(i);
    const auto a = once_cca<Quantity>(s), b = once_loops<Quantity>(s);
    if ((a - b).cwiseAbs().maxCoeff() <= 1e-12 * b.cwiseAbs().maxCoeff()) continue;
    std::fprintf(stderr, "%s differs from the loops by %g\n", Quantity::name, (a - b).norm());
    return false;
  }
  return true;
}

template <class... Quantities>
int program(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "check") return (check<Quantities>() && ...) ? 0 : 1;
  if (what == "list") {
    (std::puts(Quantities::name), ...);
    return 0;
  }
  int result = 2;
  const auto try_one = [&]<class Quantity>(Quantity) {
    if (what != Quantity::name) return;
    double sum = 0;
    if (argc == 4)
      for (int i = 0; i < std::atoi(argv[3]); ++i)
        sum += std::string_view(argv[2]) == "cca" ? once_cca<Quantity>(next(i)).sum()
                                                  : once_loops<Quantity>(next(i)).sum();
    if (argc == 3 && std::string_view(argv[2]) == "allocations") {
      const long before = bench_allocations();
      for (int i = 0; i < 1000; ++i) sum += once_cca<Quantity>(next(i)).sum();
      std::printf("%ld\n", bench_allocations() - before);
    }
    result = std::isfinite(sum) ? 0 : 1;
  };
  (try_one(Quantities{}), ...);
  return result;
}

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::sines, bench::inverse, bench::mass_matrix>(argc, argv);
}
