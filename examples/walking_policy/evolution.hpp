#pragma once
// An evolution strategy: maximises a function of which only noisy values are known, by steps along the
// directions in which it grew.
//
// `ask` for points, two for each direction, one to each side; `tell` the value of each, and repeat. Both
// points of a direction must meet the same circumstances; those of another direction may meet others, since
// only the difference of the two counts. The same seed gives the same points, in whatever order their values
// were found.
//
// Sources: Salimans, Ho, Chen, Sidor, Sutskever, Evolution strategies as a scalable alternative to
// reinforcement learning, arXiv:1703.03864, 2017 (mirrored sampling); Mania, Guy, Recht, Simple random search
// of static linear policies is competitive for reinforcement learning, NeurIPS 2018 (steps in units of the
// spread of the values).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace walking {

class evolution_strategy {
public:
  struct settings {
    int directions = 32;   // of a generation
    double noise = 0.02;   // how far the points are from the mean, in each coordinate
    double length = 0.01;  // of a step
    double kept = 0.8;     // of the last step
  };

  evolution_strategy(Eigen::VectorXd start, const settings& s, std::uint64_t seed)
      : mean_(std::move(start)),
        step_(Eigen::VectorXd::Zero(mean_.size())),
        s_(s),
        random_(seed),
        directions_(static_cast<std::size_t>(s.directions)) {}

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
    const std::size_t n = directions_.size();
    std::vector<double> grown, sizes;
    for (std::size_t i = 0; i < n; ++i) {
      grown.push_back(values[2 * i] - values[2 * i + 1]);
      sizes.push_back(std::abs(grown[i]));
    }
    // The median, and at most `most` times it: a few falls neither lead alone nor silence the others.
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double spread = std::max(1e-9, *middle);
    step_ *= s_.kept;
    for (std::size_t i = 0; i < n; ++i)
      step_ +=
          s_.length / static_cast<double>(n) * std::clamp(grown[i] / spread, -most, +most) * directions_[i];
    mean_ += step_;
  }

  const Eigen::VectorXd& mean() const { return mean_; }

private:
  static constexpr double most = 3;

  // Box and Muller; std::normal_distribution differs from library to library.
  double normal() {
    const auto uniform = [&] { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; };
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

  Eigen::VectorXd mean_, step_;
  settings s_;
  std::mt19937_64 random_;
  std::vector<Eigen::VectorXd> directions_;
};

}  // namespace walking
