// An extreme learning machine: a fixed random hidden layer, and an output layer found by ridge regression.
//
//   y = W h,  h = (tanh(A z + b), 1),  z = (x - centre) / width
//   A, b: random by the seed, uniform from -spread to spread; centre and width: of the examples
//   W = (sum y h^T) (ridge + sum h h^T)^-1                             batch
//
// elm_function<From, To, Hidden> is the model. From and To are spaces; one with several numbers per axis (an
// orientation) counts as plain coordinates. Trained region: near some example (covered_region.hpp). It learns
// in batches only.
//
// Examples and inputs that are NaN or infinite don't come here (learner.hpp). The answer to NaN is NaN; the
// one to infinity may be finite, because the hyperbolic tangent ends at 1: the status says `outside`.
//
// Cost: an answer takes Hidden (I + O) products and Hidden hyperbolic tangents; a batch Hidden^2 per example
// and Hidden^3. Source: Huang, Zhu, Siew, Extreme learning machine: theory and applications, Neurocomputing
// 70, 2006; with ridge: Deng, Zheng, Chen, Regularized extreme learning machine, CIDM 2009; for inverse
// kinematics in AMARSi: Reinhart, Steil, Neural learning and dynamical selection of redundant solutions for
// inverse kinematic control, Humanoids 2011. Checked: the weights are the stationary point of the ridge's
// sum.
// Example: tests/runtime/adaptive/mapping.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Cholesky>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/base/math/random_numbers.hpp>
#include <cca/adaptive/numerics/covered_region.hpp>
#include <cca/adaptive/learner.hpp>
#include <cca/component/field_types.hpp>
#include <cca/space/info.hpp>

namespace cca {
namespace detail {

// Count numbers in [-1, 1).
template <int Count>
constexpr std::array<double, static_cast<std::size_t>(Count)> drawn_weights(std::uint64_t seed) {
  std::array<double, static_cast<std::size_t>(Count)> numbers{};
  cca::random_numbers random(seed);
  for (double& one : numbers) one = random.between(-1, 1);
  return numbers;
}

}  // namespace detail

template <Space From, Space To, int Hidden, std::uint64_t Seed = 1>
struct elm_function {
  using from = From;
  using to = To;
  static constexpr int I = From::size, O = To::size;
  using input = Eigen::Matrix<double, I, 1>;
  using output = Eigen::Matrix<double, O, 1>;
  using activity = Eigen::Matrix<double, Hidden + 1, 1>;
  using weight_matrix = Eigen::Matrix<double, O, Hidden + 1>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(
        parameters, (input, centre), (input, width), (double, spread), (weight_matrix, weights));
    parameters() : centre(input::Zero()), width(input::Ones()), spread(1), weights(weight_matrix::Zero()) {}
  };

  static activity hidden(const parameters& p, const input& x) {
    const Eigen::Map<const Eigen::Matrix<double, Hidden, I>> A(random.data());
    const Eigen::Map<const Eigen::Matrix<double, Hidden, 1>> b(random.data() + Hidden * I);
    activity h;
    h.template head<Hidden>() = p.spread * (math::product(A, (x - p.centre).cwiseQuotient(p.width)) + b);
    for (int i = 0; i < Hidden; ++i) h[i] = math::tanh(h[i]);
    h[Hidden] = 1;
    return h;
  }
  static output answer(const parameters& p, const input& x) { return math::product(p.weights, hidden(p, x)); }
  static std::string title() {
    return "elm_function from " + std::string(detail::space_of<From>.name) + " to " +
           std::string(detail::space_of<To>.name) + " with " + std::to_string(Hidden) + " units, seed " +
           std::to_string(Seed);
  }

private:
  static constexpr auto random = detail::drawn_weights<Hidden*(I + 1)>(Seed);
};

template <class Model> concept ElmModel =
    AdaptableModel<Model> && requires(const typename Model::parameters& p, const typename Model::input& x) {
      { Model::hidden(p, x) } -> std::same_as<typename Model::activity>;
    };

template <ElmModel Model, int Region = 64>
struct extreme_learning_machine {
  using model = Model;
  using input = typename model::input;
  using output = typename model::output;
  using parameters = typename model::parameters;
  using region = covered_region<input::RowsAtCompileTime, Region>;
  static constexpr std::string_view name = "extreme_learning_machine";

  struct settings {
    BOOST_HANA_DEFINE_STRUCT(settings,
                             (bounded<double, 1e-12, 1e12>, ridge),
                             (bounded<double, 0, 100>, spread),
                             (bounded<double, 0, infinity>, margin));
    constexpr settings(double small = 1e-8, double wide = 1.0, double beyond = 0.1)
        : ridge(small), spread(wide), margin(beyond) {}
  };

  struct learned {
    BOOST_HANA_DEFINE_STRUCT(learned, (parameters, function), (region, trained));
    learned() : function(), trained() {}
  };

  static bool inside(const learned& known, const input& x, const settings& s) {
    return known.trained.contains(x, s.margin);
  }

  static learned batch(std::span<const example<model>> examples, const settings& s) {
    learned known;
    if (examples.empty()) return known;
    std::vector<input> inputs;
    for (const auto& one : examples) inputs.push_back(one.x);
    known.trained = region::over(inputs);
    known.function.centre = middle(inputs);
    known.function.width = known.trained.width;
    known.function.spread = s.spread;
    using square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
    constexpr int size = model::activity::RowsAtCompileTime;
    square A = s.ridge * square::Identity(size, size), b = square::Zero(size, output::RowsAtCompileTime);
    for (const auto& one : examples) {
      const typename model::activity h = model::hidden(known.function, one.x);
      A.selfadjointView<Eigen::Lower>().rankUpdate(h);
      b += h * one.y.transpose();
    }
    known.function.weights = Eigen::LLT<square>(A).solve(b).transpose();
    return known;
  }

private:
  static input middle(const std::vector<input>& inputs) {
    input sum = input::Zero();
    for (const input& x : inputs) sum += x;
    return sum / static_cast<double>(inputs.size());
  }
};

}  // namespace cca
