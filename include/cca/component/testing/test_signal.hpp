// The signals of a test of an input (graph/items/test_input.hpp), for an amplitude of 1.
//
//   step           1
//   sine           sin(2 pi f t)
//   chirp          a sine whose frequency grows by the same factor in each second: from f to g within T
//   linear_chirp   a sine whose frequency grows by as much in each second
//
// The phase of a chirp is the integral of its frequency, in turns: f T / ln(g / f) (e^(t ln(g / f) / T) - 1),
// and of a linear one f t + (g - f) t^2 / (2 T). Source: Pintelon and Schoukens, System Identification, 2012,
// section 5.3. Every machine computes the same bits (base/math.hpp).
#pragma once

#include <numbers>

#include <cca/base/math.hpp>

namespace cca {

enum class test_signal { off, step, sine, chirp, linear_chirp };

namespace detail {

// In turns, `t` seconds after the begin. f, g: Hz, above 0.
inline double turns_of_test(test_signal signal, double t, double f, double g, double duration) {
  if (signal == test_signal::linear_chirp) return (f + 0.5 * (g - f) * t / duration) * t;
  // So near to f, the difference of the phases can't be seen.
  const double growth = signal == test_signal::chirp ? math::log(g / f) : 0;
  if (growth < 1e-9 && growth > -1e-9) return f * t;
  return f * duration / growth * math::expm1(growth * t / duration);
}

}  // namespace detail

// `t` seconds after the begin; f, g: frequencies in Hz, above 0.
inline double test_value(test_signal signal, double t, double f, double g, double duration) {
  if (signal == test_signal::off) return 0;
  if (signal == test_signal::step) return 1;
  const double turns = detail::turns_of_test(signal, t, f, g, duration);
  return math::sin(2 * std::numbers::pi * (turns - math::floor(turns)));
}

}  // namespace cca
