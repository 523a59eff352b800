// The dynamics of an arm of seven joints, by the library and by Orocos KDL.
//
//   dynamics check                 compares all results; exits with 1 if they differ
//   dynamics list                  the names of the quantities
//   dynamics NAME cca|kdl ROUNDS   computes one quantity this many times, for another state each time (under
//                                  callgrind)
//   dynamics NAME allocations      the allocations of 1000 rounds of the library
//
// Each round begins with the angles: no side reuses the kinematics of the round before. KDL's solvers are
// made once.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "arm.hpp"

extern "C" long bench_allocations();

namespace bench {

using vector = Eigen::Matrix<double, 7, 1>;
using pose = cca::body_pose<arm>;

struct state {
  vector q, dq, input;  // the input: accelerations or torques
};

KDL::Chain with_flange(KDL::Chain chain) {
  const auto& tip = arm_chain::tip.translation;
  chain.addSegment(KDL::Segment("flange", KDL::Joint("flange", KDL::Joint::None),
                                KDL::Frame(KDL::Vector(tip[0], tip[1], tip[2]))));
  return chain;
}

struct by_kdl {
  KDL::Chain chain = kdl_arm();
  KDL::ChainDynParam parameters{chain, KDL::Vector(0, 0, -9.81)};
  KDL::ChainIdSolver_RNE inverse{chain, KDL::Vector(0, 0, -9.81)};
  KDL::ChainFdSolver_RNE forward{chain, KDL::Vector(0, 0, -9.81)};
  KDL::Chain to_flange = with_flange(chain);
  KDL::ChainJntToJacSolver jacobians{to_flange};
  KDL::JntArray q{7}, dq{7}, input{7}, result{7};
  KDL::JntSpaceInertiaMatrix mass{7};
  KDL::Jacobian jacobian{7};
  KDL::Wrenches none{7};

  void take(const state& s) { q.data = s.q, dq.data = s.dq, input.data = s.input; }
};

struct mass_matrix {
  static constexpr const char* name = "mass matrix";
  static Eigen::Matrix<double, 7, 7> cca(const state& s) { return cca::mass_matrix(pose(s.q)); }
  static Eigen::Matrix<double, 7, 7> kdl(by_kdl& k) {
    k.parameters.JntToMass(k.q, k.mass);
    return k.mass.data;
  }
};
struct coriolis {
  static constexpr const char* name = "Coriolis torques";
  static vector cca(const state& s) { return cca::coriolis_torques(pose(s.q), s.dq); }
  static vector kdl(by_kdl& k) {
    k.parameters.JntToCoriolis(k.q, k.dq, k.result);
    return k.result.data;
  }
};
struct gravity {
  static constexpr const char* name = "gravity torques";
  static vector cca(const state& s) { return cca::gravity_torques(pose(s.q)); }
  static vector kdl(by_kdl& k) {
    k.parameters.JntToGravity(k.q, k.result);
    return k.result.data;
  }
};
struct inverse {
  static constexpr const char* name = "inverse dynamics";
  static vector cca(const state& s) { return cca::inverse_dynamics(pose(s.q), s.dq, s.input).torques; }
  static vector kdl(by_kdl& k) {
    k.inverse.CartToJnt(k.q, k.dq, k.input, k.none, k.result);
    return k.result.data;
  }
};
struct forward {
  static constexpr const char* name = "forward dynamics";
  static vector cca(const state& s) { return cca::forward_dynamics(pose(s.q), s.dq, s.input); }
  static vector kdl(by_kdl& k) {
    k.forward.CartToJnt(k.q, k.dq, k.input, k.none, k.result);
    return k.result.data;
  }
};
struct jacobian {
  static constexpr const char* name = "Jacobian";
  static Eigen::Matrix<double, 6, 7> cca(const state& s) { return pose(s.q).jacobian<"arm">(); }
  static Eigen::Matrix<double, 6, 7> kdl(by_kdl& k) {
    k.jacobians.JntToJac(k.q, k.jacobian);
    Eigen::Matrix<double, 6, 7> j;
    j << k.jacobian.data.bottomRows<3>(), k.jacobian.data.topRows<3>();
    return j;
  }
};

// Another state in each round, without a cost that counts.
state next(int round) {
  state s;
  for (int i = 0; i < 7; ++i) {
    const double x = (round * 7 + i) * 0.61803398875;
    s.q[i] = 2 * (x - std::floor(x)) - 1;
    s.dq[i] = 0.7 - s.q[i];
    s.input[i] = 3 * s.q[i] + 1;
  }
  return s;
}

// Of the library and of KDL: a call each, as in a beat of a controller.
template <class Quantity>
[[gnu::noinline]] auto once_cca(const state& s) {
  return Quantity::cca(s);
}
template <class Quantity>
[[gnu::noinline]] auto once_kdl(by_kdl& k) {
  return Quantity::kdl(k);
}

template <class Quantity>
int run(std::string_view how, int rounds) {
  by_kdl k;
  double sum = 0;
  for (int i = 0; i < rounds; ++i) {
    const state s = next(i);
    if (how == "cca") {
      sum += once_cca<Quantity>(s).sum();
    } else {
      k.take(s);
      sum += once_kdl<Quantity>(k).sum();
    }
  }
  return std::isfinite(sum) ? 0 : 1;
}

template <class Quantity>
bool check() {
  by_kdl k;
  for (int i = 0; i < 100; ++i) {
    const state s = next(i);
    k.take(s);
    const auto ours = once_cca<Quantity>(s), theirs = once_kdl<Quantity>(k);
    if ((ours - theirs).norm() < 1e-9 * (1 + theirs.norm())) continue;
    std::fprintf(stderr, "%s differs from KDL by %g\n", Quantity::name, (ours - theirs).norm());
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
    if (argc == 4) result = run<Quantity>(argv[2], std::atoi(argv[3]));
    if (argc == 3 && std::string_view(argv[2]) == "allocations") {
      const long before = bench_allocations();
      double sum = 0;
      for (int i = 0; i < 1000; ++i) sum += once_cca<Quantity>(next(i)).sum();
      std::printf("%ld\n", bench_allocations() - before);
      result = std::isfinite(sum) ? 0 : 1;
    }
  };
  (try_one(Quantities{}), ...);
  return result;
}

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::mass_matrix, bench::coriolis, bench::gravity, bench::inverse, bench::forward,
                        bench::jacobian>(argc, argv);
}
