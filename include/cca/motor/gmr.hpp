// A motion model by Gaussian mixture regression over a phase, a time or a progress.
//
//   cca::node<"motion", cca::gmr<progress, leg_angles, 6>>           6 Gaussians over (input, axes)
//
//   in  "input"     Input         a space of one axis; a phase wraps around the circle
//   out "position"  S             any space with one number per axis: the mean
//   out "spread"    spread_of<S>  standard deviation in the unit of S: how much the demonstrations differed
//   out "status"    input_status_port
//
// For a phase each Gaussian is evaluated at its nearest turn. Standard deviations above a quarter of a turn
// are no longer those of a wrapped Gaussian. The parameter `mixture` is the model.
//
// Inputs (input_status.hpp): while the input is NaN or infinite, position and spread keep their last values
// (at first: 0), with the status `unreadable`; beyond 1e12 it is cut, with the status `clamped`.
//
// Errors: none. Cost: a logarithm, an exponential and O^2 products per
// Gaussian. Source: equations/gaussian_mixture.hpp. Example: tests/runtime/motor/gmr.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>

#include <cca/base/math/roots.hpp>
#include <cca/component/input_status.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/gaussian_mixture.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

// The standard deviation of samples of a space along each axis, in the unit of the space.
template <class Whole>
struct spread_of : space<number, typename Whole::axes> {};

template <detail::LinearSpace Input, detail::LinearSpace S, int K>
  requires(Input::size == 1)
struct gmr {
  using model = gaussian_mixture<1, S::size, K>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (model, mixture));
  };
  parameters p{};

  auto process(in<"input", Input> input)
      -> std::tuple<out<"position", S>, out<"spread", spread_of<S>>, out<"status", input_status_port>> {
    using scalar = typename model::input;
    detail::input_check inputs;
    const scalar at = inputs(input.vector());
    if (inputs.unreadable()) return {position, spread, status_of(inputs.get())};
    const auto answer =
        regress<1, S::size, K>(p.mixture, p.mixture.priors, at, [](const scalar& x, const scalar& mean) {
          if constexpr (std::is_same_v<typename Input::domain, cca::phase>)
            return scalar(wrap_signed(x[0] - mean[0]));
          else return scalar(x - mean);
        });
    position = answer.mean;
    for (int i = 0; i < S::size; ++i) spread[i] = math::sqrt(std::max(0.0, answer.covariance(i, i)));
    return {position, spread, status_of(inputs.get())};
  }

  void on_start() {
    position.setZero();
    spread.setZero();
  }

private:
  typename S::vector_type position = S::vector_type::Zero();
  typename spread_of<S>::vector_type spread = spread_of<S>::vector_type::Zero();
};

}  // namespace cca
