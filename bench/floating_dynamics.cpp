// The dynamics of a quadruped with a free base: recorded at compile time, and by the loops over its links
// that larger bodies use.
//
//   floating_dynamics NAME cca|loops ROUNDS      (two_ways.hpp)
//
// Each round begins with the angles. "sines" is what they take: the arithmetic is the rest.
#include <cmath>
#include <cstdio>
#include <string_view>

#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "quadruped.hpp"
#include "two_ways.hpp"

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
    for (int i = 0; i < n; ++i) both[i] = cca::math::cos(s.q[i]), both[n + i] = cca::math::sin(s.q[i]);
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

struct states {
  static constexpr double tolerance = 1e-12;
  static state next(int round) {
    state s;
    spread(s, round);
    s.base = {{0.3, -0.5, -9.7}, {0.4, s.q[0], 0.3}, {1, 2, s.q[1]}, {0.5, 0.1, -2}};
    return s;
  }
};

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::beside_loops<bench::states>, bench::sines, bench::inverse, bench::mass_matrix>(
      argc, argv);
}
