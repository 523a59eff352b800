// An energy tank: the account of the work that joint torques do, and the share of them that it can pay.
//
//   tank.start(1.0)              J
//   tank.draw(q, most)           the work of the torques since the last `hold` leaves the tank, which holds
//                                at most `most` J; work that they absorb flows in
//   tank.share(t, other, dq, solver, dt)   the largest s in 0..1 for which t s + other do no more work in the
//                                next dt than the tank holds
//   tank.hold(torques, q)        these torques act from now on
//
// Torques that stay the same between two firings do the work torques * (change of q), exactly and whatever
// else moves the joints, so the account has no error that adds up. `share` predicts the next work:
//
//   work(s) = dt v^T t(s) + dt^2 / 2 t(s)^T M^-1 t(s)
//
// An external push that comes within the step can take more than that: the tank is below 0 then, and until it
// is filled again t gets the share that absorbs most. What is missing beyond 1 J is forgotten: no push does
// that in a step, but an angle that jumped.
//
// NaN: the callers check their inputs. Sources: Hannaford and Ryu, Time-Domain Passivity Control of Haptic
// Interfaces, IEEE Trans. Robotics and Automation 18(1), 2002 (the account); Ferraguti, Secchi, Fantuzzi, A
// Tank-Based Approach to Impedance Control with Variable Stiffness, ICRA 2013 (the tank).
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/base/math/positive_matrix.hpp>

namespace cca::detail {

template <int Size>
class energy_tank {
public:
  using vector = Eigen::Matrix<double, Size, 1>;

  void start(double joule) {
    stored = joule;
    torques.setZero();
    begun = false;
  }

  void draw(const vector& q, double most) {
    if (begun) stored -= math::dot(torques, q - at);
    stored = std::max(-1.0, std::min(stored, most));
  }
  // As draw, after firings in which it was not called. What flowed in meanwhile is not known, so it doesn't
  // count.
  void draw_after_gap(const vector& q, double most) {
    if (begun) stored -= std::max(0.0, math::dot(torques, q - at));
    stored = std::max(-1.0, std::min(stored, most));
  }

  double share(const vector& t,
               const vector& other,
               const vector& dq,
               const positive_matrix<Size>& solver,
               double dt) const {
    const vector moved = dt * dt * solver.solve(t);
    const double a = 0.5 * math::dot(t, moved), b = dt * math::dot(dq, t) + math::dot(other, moved);
    const double c = dt * math::dot(dq, other) + 0.5 * dt * dt * math::dot(other, solver.solve(other));
    const auto within = [](double s) { return std::min(1.0, std::max(0.0, s)); };
    if (!(a > 0)) return 1;  // no torques
    const double lowest = -b / (2 * a), room = stored - c;
    if (stored < 0) return within(lowest);
    if (a + b <= room) return 1;
    const double square = b * b + 4 * a * room;
    return within(square > 0 ? lowest + math::sqrt(square) / (2 * a) : lowest);
  }

  void hold(const vector& from_now_on, const vector& q) {
    torques = from_now_on;
    at = q;
    begun = true;
  }

  double joule() const { return stored; }

private:
  vector torques = vector::Zero(), at = vector::Zero();
  double stored = 0;
  bool begun = false;
};

}  // namespace cca::detail
