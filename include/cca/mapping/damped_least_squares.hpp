// Inverse kinematics of any serial chain: damped least squares within the joints' limits.
//
// It seeks the angles at which the distance to the wanted position (orientation, pose) is least. A step
// solves (J J^T + m I) y = e, dq = J^T y, on the joints that no limit holds back; it's taken if it leads
// nearer, and the damping m follows how well the step was foretold (Nielsen 1999). It starts from the angles
// given, and where that doesn't reach, once more from other ones: a chain stretched towards its target has no
// direction to start in, and there are local minima. So out of reach it gives the nearest point that these
// starts lead to; of a chain with limits that need not be the nearest of all. Never more than `starts` times
// `iterations` steps.
//
// Sources: Wampler, Manipulator inverse kinematic solutions based on vector formulations and damped
// least-squares methods, IEEE Trans. SMC 16(1), 1986; Nielsen, Damping parameter in Marquardt's method,
// report IMM-REP-1999-05, Technical University of Denmark. Checked: what can be reached is, and the nearest
// point where it is known (tests/runtime/mapping/kinematics.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <cca/mapping/forward_kinematics.hpp>
#include <cca/mapping/reaching.hpp>
#include <cca/space/limits.hpp>

namespace cca {

// What may be set of it, at compile time: derive from this and give another number.
struct damped_least_squares {
  static constexpr int iterations = 100;  // of a start
  static constexpr int starts = 4;
  static constexpr double tolerance = 1e-9;  // m, to have reached; of orientations: this many m of the lever
  static constexpr double lever = 0.1;       // m: an error of 1 rad counts as so many m
};

namespace detail {

// x of A x = b, A positive definite, by Cholesky's decomposition. (Eigen's own isn't part of what the core
// includes.)
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

// What is wanted of the tip, as rows: which of the Jacobian's, and the error along them.
template <class Space, class Settings>
struct tip_task {
  static constexpr bool of_position = one_kind<typename Space::domain, cartesian_position<void>>;
  static constexpr bool of_pose = one_kind<typename Space::domain, pose<void>>;
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

// A finite target, and not farther than a million times what the chain spans: the direction is all that
// counts there.
template <class Space>
inline bool readable(typename Space::vector_type& wanted, double span) {
  double largest = 0;
  for (int i = 0; i < Space::size; ++i) {
    if (!std::isfinite(wanted[i])) return false;
    if (i < 3) largest = std::max(largest, std::abs(wanted[i]));
  }
  constexpr bool turned = !one_kind<typename Space::domain, cartesian_position<void>>;
  constexpr bool placed = !one_kind<typename Space::domain, orientation<void>>;
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

// The limits of a chain's coordinates: angles or, of prismatic joints, lengths.
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
  // A part of the way from the lower to the upper limit; where there is none, of three rad to both sides.
  static double between(int i, double part) {
    const double low = std::isfinite(lower(i)) ? lower(i) : std::isfinite(upper(i)) ? upper(i) - 3 : -3;
    const double high = std::isfinite(upper(i)) ? upper(i) : low + 6;
    return low + part * (high - low);
  }

  // m: the chain stretched out, its sliding joints as far as their limits let them.
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

  // `wanted` has been found readable, `near` lies within the limits.
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
  // The middle, then points that spread over the range (the golden ratio's multiples, others for each joint).
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
      // At a tenth of a millionth of the span from the nearest point the distance is exact to the digits of a
      // double.
      if (gradient.dot(gradient) <= 1e-12 * span * span * cost)
        return {q, std::sqrt(cost), reaching::nearest};

      Eigen::Matrix<double, task::rows, task::rows> a = j * j.transpose();
      a.diagonal().array() += damping;
      const vector step = j.transpose() * solve_positive<task::rows>(a, e);
      const vector next = limits::clamped(q + step);
      const chain_pose<Chain> there(next);
      const auto error = task::error(wanted, there.tip());
      const double foretold = step.dot(damping * step + gradient), cost_there = error.dot(error);
      if (cost_there < cost) {
        const double gain =
            2 * (cost - cost_there) / std::max(foretold, std::numeric_limits<double>::min()) - 1;
        damping = std::max(1e-12 * span * span, damping * std::clamp(1 - gain * gain * gain, 1.0 / 3, 2.0));
        growth = 2;
        q = next, now = there, e = error, cost = cost_there;
      } else {
        // Nothing nearer within the digits of a double: this is the nearest.
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
