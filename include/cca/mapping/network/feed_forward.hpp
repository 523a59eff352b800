// A feed-forward network as a function: layers of weighted sums, each but the last with an activation after
// it.
//
//   z = (x - centre) .* scale,   h1 = f(W1 z + b1),   h2 = f(W2 h1 + b2), ...,   y = offset + gain .* (W h +
//   b)
//
//   using net = cca::feed_forward<cca::hyperbolic_tangent, 48, 256, 128, 12>;      48 numbers in, 12 out
//   net::answer(p, x)                                                              p: a net::parameters
//
// All weights stand in one array, layer by layer: W by columns, then b. So a program may search over them as
// one vector.
//
//   hyperbolic_tangent   Lambert's continued fraction to x^9 / x^8, 1 beyond 6.297: within 7e-6 of tanh.
//   Plain
//                        arithmetic instead of std::tanh, so compilers vectorise it, and every machine gives
//                        the same
//   rectifier            max(x, 0), at most 1e12
//
// NaN in x gives NaN, or with the rectifier any number: the policy asks before. Finite numbers of up to 1e12
// stay finite. Cost: the products, an addition per unit, and the activation: some 20 operations per tangent.
// Source: Rumelhart, Hinton, Williams, Learning representations by back-propagating errors, Nature 323, 1986;
// Lambert, Memoires de l'academie royale des sciences de Berlin 17, 1768.
// Example: tests/runtime/mapping/policy.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <cca/base/eigen.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/reflect.hpp>
#include <cca/component/input_status.hpp>
#include <cca/mapping/network/weighted_sums.hpp>

namespace cca {

struct hyperbolic_tangent {
  static constexpr std::string_view name = "tanh";
  // Four at a time, so that all steps of one stay in registers.
  template <class Vector>
  static void apply(Vector& v) {
    constexpr int size = Vector::RowsAtCompileTime, wide = 4;
    int i = 0;
    for (; i + wide <= size; i += wide) of_some<wide>(v, i);
    for (; i < size; ++i) of_some<1>(v, i);
  }

private:
  template <int Count>
  [[gnu::always_inline]] static void of_some(auto& v, int at) {
    using array = Eigen::Array<double, Count, 1>;
    const array x = v.template segment<Count>(at).array().min(end).max(-end), s = x * x;
    const array above = (((s + 990) * s + 135135) * s + 4729725) * s + 34459425,
                under = (((45 * s + 13860) * s + 945945) * s + 16216200) * s + 34459425;
    v.template segment<Count>(at) = x * above / under;
  }
  static constexpr double end = 6.2972;  // the fraction is 1 there
};

struct rectifier {
  static constexpr std::string_view name = "relu";
  template <class Vector>
  static void apply(Vector& v) {
    v = v.array().max(0.0).min(largest_input);
  }
};

namespace detail {

template <int... Sizes>
inline constexpr int weights_of_layers = [] {
  constexpr std::array sizes{Sizes...};
  int count = 0;
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i) count += (sizes[i] + 1) * sizes[i + 1];
  return count;
}();

// Layers from the one with `From` inputs on.
template <class Activation, int From, int To, int... Rest>
struct layers {
  template <class Vector>
  [[gnu::always_inline]] static auto answer(const double* weights, const Vector& x) {
    auto y = weighted_sums<double, From, To>::of(weights, x);
    if constexpr (sizeof...(Rest) == 0) {
      return y;
    } else {
      Activation::apply(y);
      return layers<Activation, To, Rest...>::answer(weights + To * (From + 1), y);
    }
  }
};

template <int... Units>
struct empty_layer {
  static constexpr void tell(text& m) {
    int layer = 0, empty = -1;  // 0: the inputs
    ((empty = empty < 0 && Units < 1 ? layer : empty, ++layer), ...);
    m << "mapping.bad_policy: layer " << empty << " of the network ";
    int written = 0;
    ((m << (written++ > 0 ? " - " : "") << Units), ...);
    m << " (inputs, layers, outputs) has no units; each number in cca::hidden_layers<...> is at least 1";
  }
};
template <int Inputs>
struct no_outputs {
  static constexpr void tell(text& m) {
    m << "mapping.bad_policy: a cca::feed_forward has " << Inputs
      << " inputs and no number of outputs: write it behind them, and behind the layers between";
  }
};
// In a function; mapping.hpp says why.
template <int... Units>
constexpr auto check_layers() {
  static_assert(holds_or_tells<((Units >= 1) && ...), empty_layer<Units...>>::value);
}

}  // namespace detail

template <class Activation, int Inputs, int... Others>
struct feed_forward {
  static_assert(detail::holds_or_tells<(sizeof...(Others) >= 1), detail::no_outputs<Inputs>>::value);
  using checked = decltype(detail::check_layers<Inputs, Others...>());
  static constexpr int outputs = std::array{Inputs, Others...}.back();
  static constexpr int weight_count = detail::weights_of_layers<Inputs, Others...>;
  using input = Eigen::Matrix<double, Inputs, 1>;
  using output = Eigen::Matrix<double, outputs, 1>;
  using weight_array = std::array<double, static_cast<std::size_t>(weight_count)>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (input, centre),
                             (input, scale),
                             (output, offset),
                             (output, gain),
                             (weight_array, weights));
    parameters()
        : centre(input::Zero()),
          scale(input::Ones()),
          offset(output::Zero()),
          gain(output::Ones()),
          weights() {}
    std::string_view check() const {
      double most = 0;
      for (const double w : weights) most = std::max(most, std::abs(w));
      for (const auto& part : {most, centre.cwiseAbs().maxCoeff(), scale.cwiseAbs().maxCoeff(),
                               offset.cwiseAbs().maxCoeff(), gain.cwiseAbs().maxCoeff()})
        if (part > largest_input) return "a number is above 1e12";
      return "";
    }
  };

  [[gnu::always_inline]] static output answer(const parameters& p, const input& x) {
    const input z = (x - p.centre).cwiseProduct(p.scale);
    return p.offset +
           p.gain.cwiseProduct(detail::layers<Activation, Inputs, Others...>::answer(p.weights.data(), z));
  }

  // "feed_forward tanh 48 256 128 12"
  static std::string title() {
    std::string text("feed_forward ");
    text.append(Activation::name).append(" ").append(std::to_string(Inputs));
    (text.append(" ").append(std::to_string(Others)), ...);
    return text;
  }
};

}  // namespace cca
