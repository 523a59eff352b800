#pragma once
// Covariance matrix adaptation: maximises a function of which only the values are known.
//
// `ask` for a generation of points, `tell` the value of each, and repeat. Points are meant to lie in the unit
// cube, but `ask` may return points outside of it; the caller decides their value. Source: Hansen, "The CMA
// evolution strategy: a tutorial", arXiv:1604.00772; the numbers are those of its equations.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <Eigen/Dense>

namespace gait_search {

class cma_es {
public:
  cma_es(Eigen::VectorXd start, double step, int population, std::uint64_t seed)
      : n_(static_cast<double>(start.size())),
        mean_(std::move(start)),
        step_(step),
        random_(seed),
        points_(static_cast<std::size_t>(population)) {
    const int parents = population / 2;
    weights_.resize(parents);
    for (int i = 0; i < parents; ++i) weights_[i] = std::log(parents + 0.5) - std::log(i + 1.0);  // (49)
    weights_ /= weights_.sum();
    mass_ = 1 / weights_.squaredNorm();                                                               // (8)
    step_rate_ = (mass_ + 2) / (n_ + mass_ + 5);                                                      // (55)
    step_damping_ = 1 + step_rate_ + 2 * std::max(0.0, std::sqrt((mass_ - 1) / (n_ + 1)) - 1);        // (55)
    path_rate_ = (4 + mass_ / n_) / (n_ + 4 + 2 * mass_ / n_);                                        // (56)
    rank_one_ = 2 / ((n_ + 1.3) * (n_ + 1.3) + mass_);                                                // (57)
    rank_mu_ = std::min(1 - rank_one_, 2 * (mass_ - 2 + 1 / mass_) / ((n_ + 2) * (n_ + 2) + mass_));  // (58)
    expected_length_ = std::sqrt(n_) * (1 - 1 / (4 * n_) + 1 / (21 * n_ * n_));
    const auto size = mean_.size();
    axes_ = covariance_ = Eigen::MatrixXd::Identity(size, size);
    lengths_ = Eigen::VectorXd::Ones(size);
    path_ = step_path_ = Eigen::VectorXd::Zero(size);
  }

  // A new generation of points (38 to 40).
  const std::vector<Eigen::VectorXd>& ask() {
    for (auto& x : points_) {
      Eigen::VectorXd z(mean_.size());
      for (auto& v : z) v = normal();
      x = mean_ + step_ * (axes_ * lengths_.cwiseProduct(z));
    }
    return points_;
  }

  void tell(const std::vector<double>& values) {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return values[a] != values[b] ? values[a] > values[b] : a < b;
    });

    const Eigen::VectorXd former = mean_;
    mean_.setZero();
    for (Eigen::Index i = 0; i < weights_.size(); ++i)
      mean_ += weights_[i] * points_[order[static_cast<std::size_t>(i)]];
    const Eigen::VectorXd moved = (mean_ - former) / step_;  // (41, 42)

    const Eigen::VectorXd whitened = axes_ * (axes_.transpose() * moved).cwiseQuotient(lengths_);
    step_path_ =
        (1 - step_rate_) * step_path_ + std::sqrt(step_rate_ * (2 - step_rate_) * mass_) * whitened;  // (43)
    ++generation_;
    const double unbiased = std::sqrt(1 - std::pow(1 - step_rate_, 2.0 * generation_));
    const bool calm = step_path_.norm() / unbiased < (1.4 + 2 / (n_ + 1)) * expected_length_;
    path_ *= 1 - path_rate_;  // (45)
    if (calm) path_ += std::sqrt(path_rate_ * (2 - path_rate_) * mass_) * moved;

    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(mean_.size(), mean_.size());
    for (Eigen::Index i = 0; i < weights_.size(); ++i) {
      const Eigen::VectorXd y = (points_[order[static_cast<std::size_t>(i)]] - former) / step_;
      spread += weights_[i] * y * y.transpose();
    }
    covariance_ = (1 - rank_one_ - rank_mu_) * covariance_ + rank_one_ * path_ * path_.transpose() +
                  rank_mu_ * spread;  // (47)
    step_ = std::min(largest_step, step_ * std::exp(step_rate_ / step_damping_ *
                                                    (step_path_.norm() / expected_length_ - 1)));  // (44)

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> decomposed((covariance_ + covariance_.transpose()) /
                                                                    2);
    axes_ = decomposed.eigenvectors();
    lengths_ = decomposed.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
  }

  const Eigen::VectorXd& mean() const { return mean_; }
  double step() const { return step_; }
  int generation() const { return generation_; }

private:
  static constexpr double largest_step = 0.4;  // of the unit cube

  // Box and Muller; std::normal_distribution differs from library to library.
  double normal() {
    const auto uniform = [&] { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; };
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

  double n_;
  Eigen::VectorXd mean_;
  double step_;
  std::mt19937_64 random_;
  std::vector<Eigen::VectorXd> points_;
  Eigen::VectorXd weights_;
  double mass_, step_rate_, step_damping_, path_rate_, rank_one_, rank_mu_, expected_length_;
  Eigen::MatrixXd covariance_, axes_;
  Eigen::VectorXd lengths_, path_, step_path_;
  int generation_ = 0;
};

}  // namespace gait_search
