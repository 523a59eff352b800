// One descent of inverse kinematics: damped least squares within the joint limits.
//
// It searches the angles with the least distance to the wanted position (orientation, pose). A step solves (J
// J^T + m I) y = e, dq = J^T y, over the joints that no limit blocks. It is taken if it reduces the distance;
// the damping m follows the ratio of actual to predicted gain (Nielsen 1999). A descent ends in a minimum of
// the distance, which need not be the least one: many_starts.hpp tries others.
// Precondition: the target is not NaN or infinite; inverse_kinematics.hpp checks it. Then the angles stay
// finite.
// Cost: a step is one evaluation of the chain and one solution of at most six equations.
//
// Sources: Wampler, Manipulator inverse kinematic solutions based on vector formulations and damped
// least-squares methods, IEEE Trans. SMC 16(1), 1986; Nielsen, Damping parameter in Marquardt's method,
// report IMM-REP-1999-05, Technical University of Denmark.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/mapping/tip_task.hpp>

namespace cca {

// The settings, at compile time: derive from this struct and hide a number with another one.
struct damped_least_squares {
  static constexpr int steps_per_beat = 100;  // no beat takes more; the search goes on in the next one
  static constexpr int starts = 128;          // descents before a target counts as out of reach
  static constexpr int iterations = 100;      // steps of a descent that is not the best one
  static constexpr double tolerance = 1e-9;   // m: a smaller distance counts as reached
  static constexpr double lever = 0.1;        // m: an error of 1 rad counts as this distance
};

namespace detail {

// Solves A x = b for a positive definite A by Cholesky's decomposition. (The core does not include Eigen's
// own.)
template <int Size>
Eigen::Matrix<double, Size, 1> solve_positive(Eigen::Matrix<double, Size, Size> a,
                                              Eigen::Matrix<double, Size, 1> b) {
  for (int j = 0; j < Size; ++j) {
    for (int k = 0; k < j; ++k) a(j, j) -= a(j, k) * a(j, k);
    a(j, j) = math::sqrt(a(j, j) > 0 ? a(j, j) : std::numeric_limits<double>::min());
    for (int i = j + 1; i < Size; ++i) {
      for (int k = 0; k < j; ++k) a(i, j) -= a(i, k) * a(j, k);
      a(i, j) /= a(j, j);
    }
  }
  for (int i = 0; i < Size; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= a(i, k) * b[k];
    b[i] /= a(i, i);
  }
  for (int i = Size - 1; i >= 0; --i) {
    for (int k = i + 1; k < Size; ++k) b[i] -= a(k, i) * b[k];
    b[i] /= a(i, i);
  }
  return b;
}

template <class Chain, class Joints, class Tip, class Settings>
class descent {
  using task = tip_task<Tip, Settings>;
  using limits = chain_limits<Chain, Joints>;
  enum class phase : std::uint8_t { idle, running, reached, minimum, exhausted, hopeless };

public:
  using vector = typename limits::vector;

  vector q = vector::Zero();
  double square = std::numeric_limits<double>::infinity();  // m^2: of the distance that is left

  bool running() const { return at == phase::running; }
  bool reached() const { return at == phase::reached; }
  bool exhausted() const { return at == phase::exhausted; }  // out of iterations before a minimum

  void begin(const vector& from) {
    *this = descent();
    q = from;
    at = phase::running;
  }
  // The target has moved, or this descent became the best one.
  void go_on() {
    at = phase::running;
    taken = 0;
    square_before = std::numeric_limits<double>::infinity();
  }

  // Runs for at most `steps` evaluations of the chain, and returns how many it took. It gives up if progress
  // is slow and `best`, the square of another one's distance, is nearer; without another one it goes on to a
  // minimum.
  int run(const typename Tip::vector_type& wanted,
          int steps,
          double best = std::numeric_limits<double>::infinity()) {
    constexpr double span = limits::span;
    const bool alone = best == std::numeric_limits<double>::infinity();
    chain_pose<Chain> now(q);
    auto e = task::error(wanted, now.tip());
    square = math::dot(e, e);
    int evaluations = 1;
    for (;; ++evaluations) {
      if (square <= Settings::tolerance * Settings::tolerance) return ends(phase::reached, evaluations);
      if (evaluations >= steps) return evaluations;
      auto j = task::rows_of(now.jacobian());
      vector gradient = math::product(j.transpose(), e);
      for (int k = 0; k < limits::size; ++k)
        if ((q[k] <= limits::lower(k) && gradient[k] < 0) || (q[k] >= limits::upper(k) && gradient[k] > 0)) {
          j.col(k).setZero();
          gradient[k] = 0;
        }
      // Within 1e-7 of the span of the nearest point the distance is exact to rounding.
      if (math::dot(gradient, gradient) <= 1e-12 * span * span * square)
        return ends(phase::minimum, evaluations);

      Eigen::Matrix<double, task::rows, task::rows> a = math::product(j, j.transpose());
      a.diagonal().array() += damping;
      vector step = math::product(j.transpose(), solve_positive<task::rows>(a, e));
      const double part = std::min(1.0, longest_step / step.cwiseAbs().maxCoeff());
      step *= part;
      const vector next = limits::clamped(q + step);
      const chain_pose<Chain> there(next);
      const auto error = task::error(wanted, there.tip());
      const double predicted = math::dot(step, damping * step + (2 - part) * gradient),
                   square_there = math::dot(error, error);
      if (square_there < square) {
        const double gain =
            2 * (square - square_there) / std::max(predicted, std::numeric_limits<double>::min()) - 1;
        damping = std::max(1e-12 * span * span, damping * std::clamp(1 - gain * gain * gain, 1.0 / 3, 2.0));
        growth = 2;
        q = next, now = there, e = error, square = square_there;
      } else {
        // The step is below rounding: this is the nearest point.
        if (math::dot(step, step) < 1e-20) return ends(phase::minimum, evaluations + 1);
        damping *= growth;
        growth *= 2;
      }
      if (++taken % 8 != 0) continue;
      const double gained = square_before - square;  // in eight steps
      if (gained <= 1e-6 * square && gained <= 2e-8 * span * math::sqrt(square))
        return ends(phase::minimum, evaluations + 1);
      if (!alone && square - patience * gained > best) return ends(phase::hopeless, evaluations + 1);
      if (!alone && taken >= Settings::iterations) return ends(phase::exhausted, evaluations + 1);
      square_before = square;
    }
  }

private:
  // rad (prismatic joints: m): a longer step would jump over minima that lie where joints are at their
  // limits.
  static constexpr double longest_step = 0.8;
  // A descent gives up if as many steps again, times this, would not make it the best.
  static constexpr double patience = 6;

  double damping = 1e-3 * limits::span * limits::span, growth = 2;
  double square_before = std::numeric_limits<double>::infinity();  // eight steps ago
  int taken = 0;
  phase at = phase::idle;

  int ends(phase how, int evaluations) {
    at = how;
    return evaluations;
  }
};

}  // namespace detail
}  // namespace cca
