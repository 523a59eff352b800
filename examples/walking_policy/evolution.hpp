#pragma once
// Augmented random search: maximises a function of which only the values are known, by steps along the
// directions in which it grew.
//
// `ask` for points, two for each direction, `tell` the value of each, and repeat. The same seed gives the
// same points, in whatever order their values were found. Source: Mania, Guy, Recht, Simple random search of
// static linear policies is competitive for reinforcement learning, NeurIPS 2018, algorithm 1, V1-t.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace walking {

class augmented_random_search {
public:
  struct settings {
    int directions = 16;   // of each generation
    int best = 8;          // of them count
    double noise = 0.03;   // how far the points lie from the mean, in each coordinate
    double length = 0.02;  // of a step
  };

  augmented_random_search(Eigen::VectorXd start, const settings& s, std::uint64_t seed)
      : mean_(std::move(start)), s_(s), random_(seed), directions_(static_cast<std::size_t>(s.directions)) {}

  std::vector<Eigen::VectorXd> ask() {
    std::vector<Eigen::VectorXd> points;
    for (auto& direction : directions_) {
      direction.resize(mean_.size());
      for (double& x : direction) x = normal();
      points.emplace_back(mean_ + s_.noise * direction);
      points.emplace_back(mean_ - s_.noise * direction);
    }
    return points;
  }

  void tell(const std::vector<double>& values) {
    std::vector<std::size_t> order(directions_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto better = [&](std::size_t i) { return std::max(values[2 * i], values[2 * i + 1]); };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return better(a) != better(b) ? better(a) > better(b) : a < b;
    });
    order.resize(static_cast<std::size_t>(s_.best));
    double sum = 0, squares = 0;
    for (const std::size_t i : order)
      for (const double value : {values[2 * i], values[2 * i + 1]}) sum += value, squares += value * value;
    const double n = 2.0 * s_.best;
    const double spread = std::sqrt(std::max(1e-12, squares / n - sum / n * sum / n));
    for (const std::size_t i : order)
      mean_ += s_.length / (s_.best * spread) * (values[2 * i] - values[2 * i + 1]) * directions_[i];
  }

  const Eigen::VectorXd& mean() const { return mean_; }

private:
  // Box and Muller; std::normal_distribution differs from library to library.
  double normal() {
    const auto uniform = [&] { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; };
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

  Eigen::VectorXd mean_;
  settings s_;
  std::mt19937_64 random_;
  std::vector<Eigen::VectorXd> directions_;
};

}  // namespace walking
