#pragma once
// The rhythmic movement in the plane of the table: an oscillator, and a movement primitive whose shape is an
// ellipse.
#include <numbers>

#include <cca/base/math.hpp>
#include <cca/motor/dmp_rhythmic.hpp>
#include <cca/motor/hopf.hpp>

#include "spaces.hpp"

namespace touch {

struct strokes : cca::hopf<stroke> {
  strokes() { p.frequency = 0.5; }
};

struct ellipse : cca::dmp_rhythmic<place_on_table, stroke, 30> {
  static constexpr double length = 0.06, width = 0.04;  // half axes, m
  ellipse() {
    p.frequency = 0.5;
    for (int i = 0; i < 30; ++i) {
      const double phi = 2 * std::numbers::pi * i / 30;
      const auto [sine, cosine] = cca::math::sine_and_cosine(phi);
      const Eigen::Vector2d at(length * cosine, width * sine), rate(-length * sine, width * cosine);
      p.weights.col(i) =
          ode::wanted_forcing(at, rate, -at, Eigen::Vector2d::Zero(), 1, {p.weights, p.stiffness});
    }
  }
};

// The ellipse lies about the place where the table was found.
struct middle_of_table {
  auto process() -> cca::out<"place", place_on_table> { return Eigen::Vector2d(0, 0); }
};

}  // namespace touch
