// A reservoir pattern generator (RCPG): an echo state network whose output is fed back, so it continues the
// pattern that it was trained on.
//
//   cca::node<"cpg", cca::rcpg<leg_angles, 100>, cca::timed<10>>      100 units, one step every 10 beats
//
//   in  "teacher"  S    optional: each fresh sample is fed back and published instead of the network's output
//   out "pattern"  S    any space with one number per axis
//   out "status"   input_status_port
//
// The pattern advances once per firing, so run it at the clock of its training. The parameter `readout` has
// one row per axis: a weight per unit, then a constant. To train: feed the teacher, collect `activity()` as
// regressors, find the weights by ridge regression. The network must be the same then: seed, spectral_radius,
// leak, feedback, bias. The network is made on load, or in the first firing.
//
// Inputs (input_status.hpp): a teacher sample with NaN or infinity is ignored: the network goes on by itself,
// with the status `unreadable`; beyond 1e12 it is cut, with the status `clamped`.
//
// Errors: none. The activity is bounded by 1, so the pattern is bounded by its weights. Cost: N (10 + D)
// products and N hyperbolic tangents per firing; 120 bytes per unit. Source: equations/reservoir.hpp; as a
// pattern generator: Wyffels and Schrauwen, Design of a central pattern generator using reservoir computing
// for learning human motion, ATEQUAL 2009. Example: tests/runtime/motor/rcpg.cpp.
#pragma once

#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/input_status.hpp>
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
    parameters(const readout_matrix& weights = readout_matrix::Zero(),
               int seed_of_weights = 1,
               double radius = 0.9,
               double leaks = 0.3,
               double feeds_back = 1,
               double constant = 0.2)
        : readout(weights),
          seed(seed_of_weights),
          spectral_radius(radius),
          leak(leaks),
          feedback(feeds_back),
          bias(constant) {}
    std::string_view check() const {
      return detail::too_large(readout, "a weight of `readout` is above 1e12");
    }
  };
  parameters p{};

  auto process(optional_in<"teacher", S> teacher)
      -> std::tuple<out<"pattern", S>, out<"status", input_status_port>> {
    if (!made) on_load();
    network.step(y, p.leak);
    detail::input_check inputs;
    const bool taught = teacher && teacher.fresh();
    output wanted = output::Zero();
    if (taught) wanted = inputs(teacher.vector());
    y = taught && !inputs.unreadable() ? wanted : output(math::product(p.readout, activity()));
    return {y, status_of(inputs.get())};
  }

  // The regressors of the readout: the activity of each unit, then 1.
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

  // Begins at rest; the network stays the same.
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
