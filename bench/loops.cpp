// Dynamics by loops, of bodies with more links than are recorded: a humanoid of 30 joints, a random tree
// of 23.
//
//   g++ -std=c++20 -O2 -DCCA_HEADER_ONLY -Iinclude -isystem /usr/include/eigen3 bench/loops.cpp -o loops
//   valgrind --tool=callgrind --callgrind-out-file=out ./loops 10
//   callgrind_annotate --inclusive=yes --threshold=100 out
//
// Each function is called ten times, so callgrind's counts are ten times those of a call. As in a beat, all
// is inlined into them; with -DAPART it is not. docs/decisions/0049 has the figures.
#include <array>
#include <cstdio>
#include <cstdlib>

#include <cca/base/math/random_numbers.hpp>
#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/derivatives.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/momentum.hpp>

#include "../tests/runtime/body/recorded_bodies.hpp"

namespace {

namespace cd = cca::detail;
using body_test::random_chain;

struct large_tree : cca::body<body_test::random_frame<-1>,
                              cca::part<"a", random_chain<-1, 0>>,
                              cca::part<"b", random_chain<0, 1>>,
                              cca::part<"c", random_chain<-1, 2>>,
                              cca::part<"d", random_chain<0, 4>>,
                              cca::part<"e", random_chain<4, 3>>,
                              cca::part<"f", random_chain<3, 5>>,
                              cca::part<"g", random_chain<5, 6>>,
                              cca::part<"h", random_chain<2, 7>>,
                              cca::part<"i", random_chain<7, 9>>> {
  static constexpr cca::link_inertia base = body_test::dice{1}.inertia();
};

#if defined(APART)
#define COUNTED [[gnu::noinline]] static
#else
#define COUNTED [[gnu::noinline, gnu::flatten]] static
#endif

template <class Body>
struct functions {
  using pose = cca::body_pose<Body>;
  using vector = typename pose::vector_type;
  static constexpr int n = pose::size;
  using matrix = Eigen::Matrix<double, n, n>;
  static constexpr const auto& links = cd::weighed_links_of<Body>;
  static constexpr std::size_t count = links.size();
  using placed = std::array<cd::placed_link, count>;
  using bodies = cd::composite_bodies<count>;
  using derived = cca::inverse_dynamics_derivatives_result<n>;

  COUNTED void kinematics(const vector& q, placed& out) {
    const pose now(q);
    const auto& all = now.links();
    for (std::size_t i = 0; i < count; ++i) out[i] = all[i];
  }
  COUNTED void inverse(const placed& p, const vector& dq, const vector& ddq, vector& out) {
    out = cd::newton_euler<count, n>(links, p, cd::base_inertia_of<Body>(), dq, ddq, {}).torques;
  }
  COUNTED void gravity(const placed& p, vector& out) {
    out = cd::torques_at_rest<n>(links, p, cd::vector3(0, 0, -9.81));
  }
  COUNTED void mass(const placed& p, matrix& out) {
    out = cd::joint_space_inertia<n>(links, bodies(links, p, {}));
  }
  COUNTED void coriolis(const placed& p, const vector& dq, matrix& out) {
    out = cd::coriolis_of<n>(links, p, dq);
  }
  COUNTED void momentum(const placed& p, const vector& dq, vector& out) {
    const auto r = cd::momentum_of_joints<n>(links, p, dq);
    out = r.momentum + r.change;
  }
  COUNTED void momentum_matrix(const placed& p, Eigen::Matrix<double, 6, n + 6>& out) {
    out = cd::momentum_matrix<n>(links, bodies(links, p, cd::base_inertia_of<Body>()));
  }
  COUNTED void forward(const placed& p, const vector& dq, const vector& t, vector& out) {
    out = cd::articulated_body<false, n>(links, p, {}, dq, t, {}, cd::vector6(cd::vector6::Zero()))
              .accelerations;
  }
  COUNTED void derivatives(const placed& p, const vector& dq, const vector& ddq, derived& out) {
    out = cd::derivatives_of_torques<n, count>(links, p, dq, ddq, {});
  }

  static double all(cca::random_numbers& random) {
    vector q, dq, ddq, v;
    for (double& x : q) x = random.between(-2, 2);
    for (double& x : dq) x = random.between(-1, 1);
    for (double& x : ddq) x = random.between(-1, 1);
    placed p;
    matrix m;
    Eigen::Matrix<double, 6, n + 6> momenta;
    derived d;
    double sum = 0;
    kinematics(q, p);
    inverse(p, dq, ddq, v), sum += v[0];
    gravity(p, v), sum += v[1];
    mass(p, m), sum += m(0, 1);
    coriolis(p, dq, m), sum += m(1, 0);
    momentum(p, dq, v), sum += v[1];
    momentum_matrix(p, momenta), sum += momenta(0, 7);
    forward(p, dq, ddq, v), sum += v[0];
    derivatives(p, dq, ddq, d), sum += d.by_angles(1, 2);
    return sum;
  }
};

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 10;
  cca::random_numbers random(1);
  double sum = 0;
  for (int i = 0; i < rounds; ++i)
    sum += functions<body_test::humanoid>::all(random) + functions<large_tree>::all(random);
  std::printf("%.17g\n", sum);
}
