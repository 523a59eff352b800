#pragma once
// Fits the policy's network to lessons: the mean square of its errors, each in units of the spread of the
// answer, is made small by steps along the gradient (back-propagation) of a few lessons at a time.
//
// Sources: Rumelhart, Hinton, Williams, Learning representations by back-propagating errors, Nature 323,
// 1986; Kingma, Ba, Adam: a method for stochastic optimization, ICLR 2015, algorithm 1.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include "teaching.hpp"

namespace walking {

// A layer in the array of all weights: `to` by `from` weights, then `to` summands.
struct layer {
  int at, from, to;
  constexpr int end() const { return at + (from + 1) * to; }
  constexpr int size() const { return end() - at; }
};
inline constexpr layer last_layer{policy::network::weight_count - (units + 1) * policy::network::outputs,
                                  units, policy::network::outputs};

class imitation {
public:
  using network = policy::network;
  using parameters = network::parameters;

  imitation(parameters& fitted, const std::vector<lesson>& first, std::uint64_t seed)
      : fitted_(fitted), random_(seed) {
    choose_units(first);
    // Variance 1 / inputs keeps the sums of a layer near the size of its inputs.
    draw(first_layer, inputs);
    draw(second_layer, units);
    draw(last_layer, units);
  }

  // Each lesson once in a pass. The steps become shorter, from `longest` down to 1 % of it.
  void learn(const std::vector<lesson>& all, int passes, double longest = 3e-3) {
    const std::size_t steps = all.size() / batch * static_cast<std::size_t>(passes);
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    moment_.setZero(), square_.setZero();
    std::size_t step = 0;
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random_() % i]);
      for (std::size_t at = 0; at + batch <= order.size(); at += batch, ++step) {
        for (std::size_t i = 0; i < batch; ++i) take(all[order[at + i]], static_cast<Eigen::Index>(i));
        find_gradient();
        const double part = static_cast<double>(step) / static_cast<double>(steps);
        move(longest * (0.01 + 0.99 * 0.5 * (1 + std::cos(std::numbers::pi * part))), step + 1);
      }
    }
  }

  // rad, root mean square of all angles.
  double error(const std::vector<lesson>& all) const {
    double sum = 0;
    for (const lesson& one : all)
      sum += (network::answer(fitted_, one.observed) - one.answer).squaredNorm() / network::outputs;
    return std::sqrt(sum / static_cast<double>(all.size()));
  }

private:
  static constexpr int inputs = network::input::RowsAtCompileTime, outputs = network::outputs;
  static constexpr std::size_t batch = 128;
  static constexpr double smallest_spread = 1e-3;
  static constexpr layer first_layer{0, inputs, units}, second_layer{first_layer.end(), units, units};

  static_assert(second_layer.end() == last_layer.at && last_layer.end() == network::weight_count);

  using matrix = Eigen::MatrixXd;
  using vector = Eigen::VectorXd;
  template <int Rows>
  using rows = Eigen::Matrix<double, Rows, Eigen::Dynamic>;

  static auto weights(double* all, layer l) { return Eigen::Map<matrix>(all + l.at, l.to, l.from); }
  static auto bias(double* all, layer l) { return Eigen::Map<vector>(all + l.at + l.from * l.to, l.to); }

  void choose_units(const std::vector<lesson>& all) {
    network::input x = network::input::Zero(), xx = x;
    network::output y = network::output::Zero(), yy = y;
    for (const lesson& one : all) {
      x += one.observed, xx += one.observed.cwiseAbs2();
      y += one.answer, yy += one.answer.cwiseAbs2();
    }
    const double n = static_cast<double>(all.size());
    const auto spread = [n](auto sum, auto squares) {
      return (squares / n - (sum / n).cwiseAbs2())
          .cwiseMax(smallest_spread * smallest_spread)
          .cwiseSqrt()
          .eval();
    };
    fitted_.centre = x / n;
    fitted_.scale = spread(x, xx).cwiseInverse();
    fitted_.offset = y / n;
    fitted_.gain = spread(y, yy);
  }

  void draw(layer l, int from) {
    const double widest = std::sqrt(3.0 / from);
    auto w = weights(fitted_.weights.data(), l);
    for (int j = 0; j < l.from; ++j)
      for (int i = 0; i < l.to; ++i)
        w(i, j) = widest * (2 * static_cast<double>(random_() >> 11) * 0x1p-53 - 1);
    bias(fitted_.weights.data(), l).setZero();
  }

  void take(const lesson& one, Eigen::Index column) {
    x_.col(column) = (one.observed - fitted_.centre).cwiseProduct(fitted_.scale);
    y_.col(column) = (one.answer - fitted_.offset).cwiseQuotient(fitted_.gain);
  }

  static void activate(rows<units>& sums) {
    for (Eigen::Index i = 0; i < sums.cols(); ++i) {
      auto column = sums.col(i);
      cca::hyperbolic_tangent::apply(column);
    }
  }

  void find_gradient() {
    double* w = fitted_.weights.data();
    rows<units> one = (weights(w, first_layer) * x_).colwise() + bias(w, first_layer);
    activate(one);
    rows<units> two = (weights(w, second_layer) * one).colwise() + bias(w, second_layer);
    activate(two);
    rows<outputs> back = ((weights(w, last_layer) * two).colwise() + bias(w, last_layer)) - y_;
    back *= 2.0 / static_cast<double>(batch * outputs);
    double* g = gradient_.data();
    weights(g, last_layer) = back * two.transpose();
    bias(g, last_layer) = back.rowwise().sum();
    rows<units> back_two =
        (weights(w, last_layer).transpose() * back).cwiseProduct((1 - two.array().square()).matrix());
    weights(g, second_layer) = back_two * one.transpose();
    bias(g, second_layer) = back_two.rowwise().sum();
    rows<units> back_one =
        (weights(w, second_layer).transpose() * back_two).cwiseProduct((1 - one.array().square()).matrix());
    weights(g, first_layer) = back_one * x_.transpose();
    bias(g, first_layer) = back_one.rowwise().sum();
  }

  void move(double length, std::size_t step) {
    constexpr double kept = 0.9, kept_square = 0.999;
    moment_ = kept * moment_ + (1 - kept) * gradient_;
    square_ = kept_square * square_ + (1 - kept_square) * gradient_.cwiseAbs2();
    const double time = static_cast<double>(step), unbiased = 1 - std::pow(kept, time),
                 unbiased_square = 1 - std::pow(kept_square, time);
    Eigen::Map<vector>(fitted_.weights.data(), network::weight_count).array() -=
        length * (moment_ / unbiased).array() / ((square_ / unbiased_square).array().sqrt() + 1e-8);
  }

  parameters& fitted_;
  std::mt19937_64 random_;
  rows<inputs> x_{inputs, static_cast<Eigen::Index>(batch)};
  rows<outputs> y_{outputs, static_cast<Eigen::Index>(batch)};
  vector gradient_ = vector::Zero(network::weight_count), moment_ = gradient_, square_ = gradient_;
};

}  // namespace walking
