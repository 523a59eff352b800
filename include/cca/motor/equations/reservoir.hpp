// An echo state network: N leaky units with fixed random connections, made from a seed.
//
//   x <- (1 - a) x + a tanh(W x + w_y y + b)
//
// y is the feedback (D numbers). W has `Connections` entries per unit, uniform in (-1, 1), scaled to a
// spectral radius; w_y is uniform in +-feedback, b in +-bias. The same seed gives the same network on every
// machine: the numbers come from SplitMix64. A power iteration measures the spectral radius to about 1 %.
// Precondition: `make` before `step`. Cost: make takes 500 N Connections products, too much for a beat; step
// takes N (Connections + D) products and N hyperbolic tangents.
// Source: Jaeger, The "echo state" approach to analysing and training recurrent neural networks, GMD report
// 148, 2001; leaky units: Jaeger, Lukosevicius, Popovici, Siewert, Optimization and applications of echo
// state networks with leaky-integrator neurons, Neural Networks 20, 2007. Checked: spectral radius against
// eigenvalues, echo states (tests/runtime/motor/rcpg.cpp).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/base/math/random_numbers.hpp>
#include <cca/base/eigen.hpp>

namespace cca {

namespace detail {}  // namespace detail

struct reservoir_settings {
  std::uint64_t seed;
  double spectral_radius, feedback, bias;
};

template <int D, int N, int Connections>
class reservoir {
  static_assert(Connections >= 1 && Connections <= N);

public:
  using output = Eigen::Matrix<double, D, 1>;
  using activity = Eigen::Matrix<double, N, 1>;

  void make(const reservoir_settings& s) {
    random_numbers random(s.seed);
    for (int i = 0; i < N; ++i) {
      for (int c = 0; c < Connections; ++c) {
        from[at(i, c)] = static_cast<int>(random.below(N));
        weight[at(i, c)] = random.between(-1, 1);
      }
      for (int d = 0; d < D; ++d) back(i, d) = s.feedback * random.between(-1, 1);
      bias[i] = s.bias * random.between(-1, 1);
    }
    const double scale = s.spectral_radius / radius();
    for (double& w : weight) w *= scale;
    rest();
  }

  void step(const output& y, double leak) {
    activity next;
    for (int i = 0; i < N; ++i) {
      double sum = bias[i];
      for (int c = 0; c < Connections; ++c) sum += weight[at(i, c)] * x[from[at(i, c)]];
      for (int d = 0; d < D; ++d) sum += back(i, d) * y[d];
      next[i] = (1 - leak) * x[i] + leak * math::tanh(sum);
    }
    x = next;
  }

  const activity& get() const { return x; }
  void rest() { x.setZero(); }

  // W times a vector.
  activity recur(const activity& v) const {
    activity result;
    for (int i = 0; i < N; ++i) {
      double sum = 0;
      for (int c = 0; c < Connections; ++c) sum += weight[at(i, c)] * v[from[at(i, c)]];
      result[i] = sum;
    }
    return result;
  }

private:
  static constexpr std::size_t at(int i, int c) { return static_cast<std::size_t>(i * Connections + c); }

  // The mean growth over many steps: with a complex pair of largest eigenvalues a vector turns, so the growth
  // of a single step varies.
  double radius() const {
    activity v = activity::Constant(1 / math::sqrt(static_cast<double>(N)));
    double growth = 0;
    for (int k = 0; k < 500; ++k) {
      v = recur(v);
      const double length = math::sqrt(math::dot(v, v));
      if (!(length > 0)) return 1;
      v /= length;
      if (k >= 100) growth += math::log(length);
    }
    return math::exp(growth / 400);
  }

  std::array<int, static_cast<std::size_t>(N* Connections)> from{};
  std::array<double, static_cast<std::size_t>(N* Connections)> weight{};
  Eigen::Matrix<double, N, D> back = Eigen::Matrix<double, N, D>::Zero();
  activity bias = activity::Zero(), x = activity::Zero();
};

}  // namespace cca
