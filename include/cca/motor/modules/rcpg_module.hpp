// A reservoir pattern generator as an adaptive module: it learns a periodic pattern from a demonstration,
// keeps it in a file, and goes on with it.
//
//   cca::tracker<cca::rcpg_module<leg_angles, 100>, cca::tracking<leg_angles>>        100 units
//
//   in  "reference"      S                  the pattern is learned relative to it, and moves with it
//   in  "demonstration"  S                  optional: the pattern to learn, while the learner listens
//   in  "learn"          learning_request   optional: a request of another component
//   out "command"        S                  maybe; while the learner listens: the demonstration
//   out "ode"            ode_status_port    converged at rest
//   out "module"         module_status_port what the learner does, and whether this activity was trained
//
// S is any space with one number per axis. The ode is that of the leaky units, t x' = -x + tanh(W x + w y +
// b), with one step of Euler's method in each firing: run the module at the clock of its training.
//
// While the learner collects or learns online, each fresh demonstration is fed back instead of the pattern,
// with a little noise, which makes the readout robust against its own errors; after `washout` firings the
// activity of the units and the pattern make one example per firing. Otherwise the network hears itself.
//
// Parameters: the network (the source document, spectral_radius, leak, feedback, bias), which a file states
// too; noise (in the unit of S), washout, settling, settings (of the learner), files. The network is made on
// load, or in the first firing. The learner is recursive least squares: in a batch ridge regression; online
// it holds for N of up to 127.
//
// Inputs (input_status.hpp): while "reference" is NaN or infinite, the network stands still, only the
// statuses are published, and "ode" is `unreadable`; beyond 1e12 it is cut, with `clamped`. A demonstration
// that is NaN or infinite counts as none: it is never learned, and the network hears itself.
//
// Errors: learner.model; `cca::refused` for files. The activity is bounded by 1, so the pattern is bounded by
// its weights. Cost: N (10 + D) products, N hyperbolic tangents, and N^2 products for the trained region;
// while it learns online 2 N^2 more. Memory: N + D numbers per example. Source: equations/reservoir.hpp;
// Wyffels, Schrauwen, Design of a central pattern generator using reservoir computing for learning human
// motion, ATEQUAL 2009; noise: Jaeger, GMD report 148, 2001.
// Example: tests/runtime/adaptive/other_modules.cpp.
#pragma once

#include <string>
#include <string_view>

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/module/adaptive_module.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>
#include <cca/base/math/random_numbers.hpp>
#include <cca/component/input_status.hpp>
#include <cca/motor/dmp_shapes.hpp>
#include <cca/motor/equations/reservoir.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

// The readout of a reservoir of N units: y = W (x, 1).
template <detail::LinearSpace S, int N>
struct readout_function {
  using input = Eigen::Matrix<double, N, 1>;
  using output = Eigen::Matrix<double, S::size, 1>;
  using weight_matrix = Eigen::Matrix<double, S::size, N + 1>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (weight_matrix, weights));
    parameters() : weights(weight_matrix::Zero()) {}
  };
  static Eigen::Matrix<double, N + 1, 1> regressors(const input& x) {
    Eigen::Matrix<double, N + 1, 1> all;
    all << x, 1.0;
    return all;
  }
  static output answer(const parameters& p, const input& x) {
    return math::product(p.weights, regressors(x));
  }
  static std::string title() {
    return detail::title_over("readout_function", detail::space_of<S>,
                              "with " + std::to_string(N) + " units");
  }
};

template <detail::LinearSpace S, int N, int Connections>
class reservoir_motion {
public:
  using model = readout_function<S, N>;
  using default_learner = recursive_least_squares<model>;
  using demonstrated = S;
  using inputs = module_inputs<in<"reference", S>>;
  using outputs = module_outputs<maybe<"command", S>>;

  template <class Settings>
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (bounded<int, 0, 1000000>, seed),
                             (bounded<double, 0, 2>, spectral_radius),
                             (bounded<double, 0, 1>, leak),
                             (bounded<double, 0, 100>, feedback),
                             (bounded<double, 0, 100>, bias),
                             (bounded<double, 0, 1e6>, noise),
                             (bounded<int, 0, 1000000>, washout),
                             (ode_settling, settling),
                             (Settings, settings),
                             (learned_files, files));
    parameters(int seed_of_weights = 1,
               double radius = 0.9,
               double leaks = 0.3,
               double feeds_back = 1,
               double constant = 0.2,
               double disturbance = 0.01,
               int first_ignored = 100,
               const ode_settling& settles = {1e-3, 1e-2},
               const Settings& of_learner = {},
               const learned_files& names = {})
        : seed(seed_of_weights),
          spectral_radius(radius),
          leak(leaks),
          feedback(feeds_back),
          bias(constant),
          noise(disturbance),
          washout(first_ignored),
          settling(settles),
          settings(of_learner),
          files(names) {}
  };

  // The weights belong to a network.
  static std::vector<learned_header::constant> constants(const auto& p) {
    return {{"connections", Connections},
            {"seed", static_cast<double>(p.seed)},
            {"spectral_radius", p.spectral_radius},
            {"leak", p.leak},
            {"feedback", p.feedback},
            {"bias", p.bias}};
  }

  template <class Give, class Parameters, class Teacher>
  [[gnu::always_inline]] auto step(const Give& give,
                                   const Parameters& p,
                                   const typename model::parameters& function,
                                   const Teacher& teach,
                                   const in<"reference", S>& reference,
                                   const optional_in<"demonstration", S>& shown,
                                   beat now) {
    if (!made) load(p);
    detail::input_check read;
    const output centre = read(reference.vector());
    maybe<"command", S> command;
    if (reference.origin() == never || read.unreadable())
      return give(status_of(read.get(), ode_state.get()), network.get(), command);
    const activity before = network.get();
    network.step(y, p.leak);
    const bool taught = teach.listens() && shown && shown.fresh() && detail::all_finite(shown.vector());
    if (taught) {
      const output wanted = read(shown.vector()) - centre;
      if (in_a_row++ >= p.washout) teach(network.get(), wanted);
      for (int i = 0; i < S::size; ++i) y[i] = wanted[i] + p.noise * random.between(-1, 1);
    } else {
      in_a_row = 0;
      y = read(model::answer(function, network.get()));
    }
    command = taught ? output(shown.vector()) : output(centre + y);
    const double rate = math::norm(network.get() - before) / now.dt();
    return give(status_of(read.get(), ode_state.update(rate, p.settling)), network.get(), command);
  }

  template <class Parameters>
  void load(const Parameters& p) {
    network.make({static_cast<std::uint64_t>(p.seed), p.spectral_radius, p.feedback, p.bias});
    made = true;
    start();
  }

  // Begins at rest; the network stays the same.
  void start() {
    network.rest();
    y.setZero();
    ode_state = {};
    in_a_row = 0;
    random = random_numbers(1);
  }

private:
  using output = typename model::output;
  using activity = typename model::input;

  reservoir<S::size, N, Connections> network;
  ode_monitor ode_state;
  output y = output::Zero();  // what the network hears next
  random_numbers random{1};
  int in_a_row = 0;  // demonstrations
  bool made = false;
};

template <detail::LinearSpace S,
          int N,
          Learner Rule = recursive_least_squares<readout_function<S, N>>,
          int Capacity = 1000,
          int Connections = 10>
struct rcpg_module : adaptive_module<reservoir_motion<S, N, Connections>, Rule, Capacity> {};

}  // namespace cca
