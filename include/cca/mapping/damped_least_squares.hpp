// Inverse kinematics of any serial chain: damped least squares within the joint limits.
//
// It searches the angles with the least distance to the wanted position (orientation, pose). A step solves (J
// J^T + m I) y = e, dq = J^T y, over the joints that no limit blocks. It is taken if it reduces the distance;
// the damping m follows the ratio of actual to predicted gain (Nielsen 1999). The search begins at the given
// angles. If that does not reach the target, it begins again from other angles, up to `starts` times: a chain
// stretched towards its target has no direction to start in, and there are local minima. Out of reach the
// result is the nearest point that these starts find; with joint limits there may be a nearer one.
// Cost: at most `starts` times `iterations` steps.
//
// Sources: Wampler, Manipulator inverse kinematic solutions based on vector formulations and damped
// least-squares methods, IEEE Trans. SMC 16(1), 1986; Nielsen, Damping parameter in Marquardt's method,
// report IMM-REP-1999-05, Technical University of Denmark. Checked: reachable targets are reached, and the
// nearest point where it is known (tests/runtime/mapping/kinematics.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <cca/mapping/forward_kinematics.hpp>
#include <cca/mapping/reaching.hpp>
#include <cca/space/limits.hpp>

namespace cca {

// The settings, at compile time: derive from this struct and hide a number with another one.
struct damped_least_squares {
  static constexpr int iterations = 100;  // per start
  static constexpr int starts = 4;
  static constexpr double tolerance = 1e-9;  // m: a smaller distance counts as reached
  static constexpr double lever = 0.1;       // m: an error of 1 rad counts as this distance
};

namespace detail {

// Solves A x = b for a positive definite A by Cholesky's decomposition. (The core does not include Eigen's
// own.)
template <int Size>
Eigen::Matrix<double, Size, 1> solve_positive(Eigen::Matrix<double, Size, Size> a,
                                              Eigen::Matrix<double, Size, 1> b) {
  for (int j = 0; j < Size; ++j) {
    for (int k = 0; k < j; ++k) a(j, j) -= a(j, k) * a(j, k);
    a(j, j) = std::sqrt(a(j, j) > 0 ? a(j, j) : std::numeric_limits<double>::min());
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

// The task of the tip: the rows of the Jacobian that count, and the error along them.
template <class Space, class Settings>
struct tip_task {
  static constexpr bool of_position = same_kind<typename Space::domain, cartesian_position<void>>;
  static constexpr bool of_pose = same_kind<typename Space::domain, pose<void>>;
  static constexpr int rows = of_position ? Space::size : of_pose ? 6 : 3;
  using vector = Eigen::Matrix<double, rows, 1>;

  static vector error(const typename Space::vector_type& wanted, const rigid& tip) {
    vector e;
    if constexpr (of_position) {
      e = wanted - tip_in<Space>(tip);
    } else {
      const vector4 q = wanted.template tail<4>();
      e.template tail<3>() =
          Settings::lever * rotation::log(rotation::product(q, rotation::inverse(quaternion_of(tip.turn))));
      if constexpr (of_pose) e.template head<3>() = wanted.template head<3>() - tip.at;
    }
    return e;
  }

  template <class Jacobian>
  static auto rows_of(const Jacobian& j) {
    Eigen::Matrix<double, rows, Jacobian::ColsAtCompileTime> r;
    if constexpr (of_position) {
      using part = cartesian_part<typename Space::axes>;
      for (int i = 0; i < rows; ++i) r.row(i) = j.row(3 + part::of[static_cast<std::size_t>(i)]);
    } else {
      r.template bottomRows<3>() = Settings::lever * j.template topRows<3>();
      if constexpr (of_pose) r.template topRows<3>() = j.template bottomRows<3>();
    }
    return r;
  }
};

// False if the target is not finite. Moves a target beyond a million spans of the chain to that distance:
// only its direction counts there. Normalises quaternions.
template <class Space>
inline bool readable(typename Space::vector_type& wanted, double span) {
  double largest = 0;
  for (int i = 0; i < Space::size; ++i) {
    if (!std::isfinite(wanted[i])) return false;
    if (i < 3) largest = std::max(largest, std::abs(wanted[i]));
  }
  constexpr bool turned = !same_kind<typename Space::domain, cartesian_position<void>>;
  constexpr bool placed = !same_kind<typename Space::domain, orientation<void>>;
  if constexpr (placed) {
    const double farthest = 1e6 * span;
    constexpr int part = turned ? 3 : Space::size;
    if (largest > farthest) wanted.template head<part>() *= farthest / largest;
  }
  if constexpr (turned) {
    const vector4 q = wanted.template tail<4>();
    wanted.template tail<4>() = rotation::normalised(vector4(q / std::max(1e-300, q.cwiseAbs().maxCoeff())));
  }
  return true;
}

// The limits of the coordinates of a chain: angles; of prismatic joints lengths.
template <class Chain, class Joints>
struct chain_limits {
  static constexpr int size = Chain::axes::count;
  using vector = Eigen::Matrix<double, size, 1>;

  static constexpr std::array<double, 2 * size + 1> bounds = []<class... Axes>(axes<Axes...>) {
    std::array<double, 2 * size + 1> all{};
    std::size_t i = 0;
    const auto add = [&](double angle_low, double angle_high, double length_low, double length_high) {
      bool slides = false;
      for (const auto& l : chain_links<Chain>)
        if (l.coordinate == static_cast<int>(i / 2)) slides = l.kind == joint_kind::prismatic;
      all[i++] = slides ? length_low : angle_low;
      all[i++] = slides ? length_high : angle_high;
    };
    (add(lower_limit_of<Axes, angle>, upper_limit_of<Axes, angle>, lower_limit_of<Axes, length>,
         upper_limit_of<Axes, length>),
     ...);
    return all;
  }(typename Chain::axes());

  static constexpr double lower(int i) { return bounds[static_cast<std::size_t>(2 * i)]; }
  static constexpr double upper(int i) { return bounds[static_cast<std::size_t>(2 * i + 1)]; }
  static double clamped(int i, double q) { return q < lower(i) ? lower(i) : q > upper(i) ? upper(i) : q; }
  static vector clamped(vector q) {
    for (int i = 0; i < size; ++i) q[i] = clamped(i, q[i]);
    return q;
  }
  // The point at the fraction `part` between the limits; without limits between -3 and 3 rad.
  static double between(int i, double part) {
    const double low = std::isfinite(lower(i)) ? lower(i) : std::isfinite(upper(i)) ? upper(i) - 3 : -3;
    const double high = std::isfinite(upper(i)) ? upper(i) : low + 6;
    return low + part * (high - low);
  }

  // m: the length of the stretched chain, with its prismatic joints at their limits.
  static constexpr double span = [] {
    double sum = 0;
    const auto add = [&](const std::array<double, 3>& v) {
      sum += constant_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    };
    for (const auto& l : chain_links<Chain>) {
      add(l.at);
      const double high = upper(l.coordinate), low = lower(l.coordinate), far = high > -low ? high : -low;
      if (l.kind == joint_kind::prismatic) sum += far < 1e3 ? far : 1.0;
    }
    add(Chain::tip.translation);
    return sum > 0 ? sum : 1.0;
  }();
};

template <class Chain, class Joints, class Tip, class Settings>
class least_squares_solver {
  using task = tip_task<Tip, Settings>;
  using limits = chain_limits<Chain, Joints>;
  using wanted_type = typename Tip::vector_type;

public:
  using vector = typename limits::vector;
  struct answer {
    vector q;
    double distance;
    reaching status;
  };

  // Preconditions: `wanted` passed readable(), `near` lies within the limits.
  static answer solve(const wanted_type& wanted, const vector& near) {
    answer best = descend(wanted, near);
    for (int start = 1; start < Settings::starts && best.status != reaching::reached; ++start) {
      const answer other = descend(wanted, other_start(start));
      if (other.status == reaching::reached || other.distance < best.distance - 1e-6 * limits::span)
        best = other;
    }
    return best;
  }

private:
  // First the middle of the range, then points spread over it: multiples of the golden ratio, which differ
  // per joint.
  static vector other_start(int start) {
    vector q;
    for (int i = 0; i < limits::size; ++i) {
      const double part = 0.5 + 0.6180339887498949 * (start - 1) * (i + 1);
      q[i] = limits::between(i, part - std::floor(part));
    }
    return q;
  }

  static answer descend(const wanted_type& wanted, vector q) {
    constexpr double span = limits::span;
    double damping = 1e-3 * span * span, growth = 2;
    chain_pose<Chain> now(q);
    auto e = task::error(wanted, now.tip());
    double cost = e.dot(e);
    for (int i = 0; i < Settings::iterations; ++i) {
      if (cost <= Settings::tolerance * Settings::tolerance) break;
      auto j = task::rows_of(now.jacobian());
      vector gradient = j.transpose() * e;
      for (int k = 0; k < limits::size; ++k)
        if ((q[k] <= limits::lower(k) && gradient[k] < 0) || (q[k] >= limits::upper(k) && gradient[k] > 0)) {
          j.col(k).setZero();
          gradient[k] = 0;
        }
      // Within 1e-7 of the span of the nearest point the distance is exact to rounding.
      if (gradient.dot(gradient) <= 1e-12 * span * span * cost)
        return {q, std::sqrt(cost), reaching::nearest};

      Eigen::Matrix<double, task::rows, task::rows> a = j * j.transpose();
      a.diagonal().array() += damping;
      const vector step = j.transpose() * solve_positive<task::rows>(a, e);
      const vector next = limits::clamped(q + step);
      const chain_pose<Chain> there(next);
      const auto error = task::error(wanted, there.tip());
      const double predicted = step.dot(damping * step + gradient), cost_there = error.dot(error);
      if (cost_there < cost) {
        const double gain =
            2 * (cost - cost_there) / std::max(predicted, std::numeric_limits<double>::min()) - 1;
        damping = std::max(1e-12 * span * span, damping * std::clamp(1 - gain * gain * gain, 1.0 / 3, 2.0));
        growth = 2;
        q = next, now = there, e = error, cost = cost_there;
      } else {
        // The step is below rounding: this is the nearest point.
        if (step.dot(step) < 1e-20) return {q, std::sqrt(cost), reaching::nearest};
        damping *= growth;
        growth *= 2;
      }
    }
    return {q, std::sqrt(cost),
            cost <= Settings::tolerance * Settings::tolerance ? reaching::reached : reaching::unfinished};
  }
};

}  // namespace detail
}  // namespace cca
