// A reservoir pattern generator (RCPG): an echo state network whose output, fed back, goes on as the pattern
// it was trained on.
//
//   cca::node<"cpg", cca::rcpg<leg_angles, 100>, cca::timed<10>>      100 units; a step each 10 beats
//   in  "teacher"    S, optional: each sample that arrives is fed back instead of the network's own output,
//   and published out "pattern"    S, any space of one number an axis
//
// The pattern runs by firings: at the clock that it was trained at. The readout is a parameter, a row an
// axis: a weight for each unit and then a constant; `activity()` are the regressors, while a teacher is
// present (ridge regression finds the weights; the network must be the same: seed, radius, leak, feedback,
// bias). The network is made on load, or in the first firing. Errors: none; the activity is bounded by 1, so
// is the pattern by its weights; a teacher that is not finite is not taken. Cost: N (10 + D) products and N
// hyperbolic tangents a firing; memory 120 bytes a unit. Source: reservoir.hpp; as a pattern generator:
// Wyffels and Schrauwen, Design of a central pattern generator using reservoir computing for learning human
// motion, ATEQUAL 2009. Example: tests/runtime/motor/rcpg.cpp.
#pragma once

#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/reservoir.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

template <detail::LinearSpace S, int N, int Connections = 10>
struct rcpg {
  using output = Eigen::Matrix<double, S::size, 1>;
  using regressors = Eigen::Matrix<double, N + 1, 1>;
  using readout_matrix = Eigen::Matrix<double, S::size, N + 1>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (readout_matrix, readout),
                             (bounded<int, 0, 1000000>, seed),
                             (bounded<double, 0, 2>, spectral_radius),
                             (bounded<double, 0, 1>, leak),
                             (bounded<double, 0, 100>, feedback),
                             (bounded<double, 0, 100>, bias));
  };
  parameters p{readout_matrix::Zero(), 1, 0.9, 0.3, 1.0, 0.2};

  auto process(optional_in<"teacher", S> teacher) -> out<"pattern", S> {
    if (!made) on_load();
    network.step(y, p.leak);
    const bool taught = teacher && teacher.fresh() && teacher.vector().allFinite();
    y = taught ? output(teacher.vector()) : output(p.readout * activity());
    return y;
  }

  // What the readout weights multiply.
  regressors activity() const {
    regressors all;
    all << network.get(), 1.0;
    return all;
  }

  void on_load() {
    network.make({static_cast<std::uint64_t>(p.seed), p.spectral_radius, p.feedback, p.bias});
    y.setZero();
    made = true;
  }

  // Starts again, from rest; the network stays.
  void on_start() {
    network.rest();
    y.setZero();
  }

private:
  reservoir<S::size, N, Connections> network;
  output y = output::Zero();
  bool made = false;
};

}  // namespace cca
