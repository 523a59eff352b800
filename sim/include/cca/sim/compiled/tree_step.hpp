// One physics step of a described robot that nothing touches: joints, motors, springs, gravity, pulls.
//
// Moreau's midpoint: positions follow the velocities for half a step, then the velocities change at once by
// the forces and the inertia of that posture, then positions follow for the other half. What velocities add
// to the forces (centrifugal, Coriolis) is taken in the middle, where the last changes lead: the step is of
// second order. Forces of joints and lines are straight pieces in the change of the velocities. A round
// solves the equations for the pieces that hold at a guess, first that of the last step; it repeats until the
// pieces at the result are the same. Mostly one round is enough; `most_rounds` bounds their number. Source:
// Moreau, Numerical aspects of the sweeping process, 1999; pieces: Newton's method for piecewise linear
// equations, as in Qi and Sun, A nonsmooth version of Newton's method, 1993.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include <cca/robots/joint_law.hpp>
#include <cca/sim/compiled/built/built_robot.hpp>
#include <cca/sim/compiled/limbs/limb_solution.hpp>
#include <cca/sim/compiled/line_forces.hpp>
#include <cca/sim/compiled/tree_motion.hpp>
#include <cca/sim/robot/model/cable_winch.hpp>

namespace cca::sim::detail {

// A cable's pulley (cca/sim/robot/model/cable_winch.hpp), over any scalar.
template <class Real>
struct pulley {
  Real wound{}, wanted{}, speed{}, torque{};

  constexpr void wind(const drive_numbers<number_of<Real>>& motor, double h) {
    const auto& [strong, fast, friction, dry_friction] = motor;
    const Real load = between(Real(0.0), torque, Real(strong)), free(fast);
    const Real falls(fast / (number_of<Real>(2.0) * strong));
    const Real most = select(load < Real(strong), free - falls * load, Real(0.0));
    speed = between(-free, wanted, most);
    wound = wound + Real(h) * speed;
  }
};

// What a step needs beside the motion; `torque`: of the motors, in the last step.
template <class R, class Real>
struct tree_drives {
  static constexpr auto n = static_cast<std::size_t>(compiled_tree<R>::coordinates);
  std::array<law_of<Real>, n> laws{};
  std::array<pulley<Real>, n> pulleys{};
  std::array<Real, n> torque{};
};

template <class R, class Real>
class tree_step {
public:
  using tree = compiled_tree<R>;
  using motion = tree_motion<Real, tree::coordinates, tree::floats>;
  using equations = tree_equations<R, Real>;
  using vector = typename branch_matrix<tree::branches, Real>::vector;
  using coordinates = typename equations::coordinates;

  static constexpr int most_rounds = 12;

  equations now;              // with the places of the links; `{}` would clear all of it
  placed_frame<Real> base{};  // in the world
  vector change{};            // of the velocities, along the axes of the base
  int rounds = 0;

  // The robot stays where it is while there is the step.
  constexpr tree_step(double step, const built_robot<R, Real>& as_built) : h(step), built(&as_built) {}

  // The posture in the middle of the step: M, and the forces of motion and gravity.
  constexpr void begin(motion& m, double gravity) {
    m.drift(0.5 * h);
    base = m.frame();
    now.look(m.q);
    // Where the last two changes lead. By the last one alone (half of it) what swings by gyroscopic forces
    // would gain in each step.
    const Real last(h * 2 / 3), sooner(h / 6);
    const auto &a = m.change, &b = m.change_before;
    coordinates speeds;
    for (std::size_t c = 0; c < n; ++c) speeds[c] = m.dq[c] + (last * a.joints[c] - sooner * b.joints[c]);
    const triple<Real> turning = along(base, m.angular_velocity + (last * a.turning - sooner * b.turning)),
                       up = along(base, triple<Real>{Real(0.0), Real(0.0), Real(gravity)});
    now.weigh(speeds, turning, up);
    if (built->added.exist()) built->added.weigh(now, speeds, turning, up);
  }

  // Beside those of `begin`, forces may be added to `now.forces` here.

  constexpr void solve(const motion& m, tree_drives<R, Real>& drives) {
    prepare(m, drives);
    const auto free_entries = now.mass.entry;
    vector guess{};
    for (std::size_t c = 0; c < n; ++c) guess[row(c)] = Real(h) * m.change.joints[c];
    auto done = Real(1.0) < Real(0.0);
    [[maybe_unused]] std::conditional_t<is_in_lanes<Real>, solution, none> kept;
    for (rounds = 1;; ++rounds) {
      change = now.forces;
      for (std::size_t c = 0; c < n; ++c) {
        const std::size_t r = row(c);
        const answer<Real> motor =
            rounds == 1 ? joints[c].motor.at(guess[r]) : joints[c].motor.at(guess[r], sides[c]);
        sides[c] = motor.side;
        const Real rubbed = taken[c].side;
        taken[c] = joints[c].at(guess[r], motor);
        if (built->has_dry_friction()) rub(c, guess[r], rounds == 1 ? Real(0.0) : rubbed);
        change[r] = change[r] + taken[c].force + taken[c].slope * guess[r];
        now.mass.diagonal(r) = now.mass.diagonal(r) + Real(h) * taken[c].slope;
      }
      for (std::size_t i = 0; i < tree::lines.size(); ++i) take(i, guess);
      for (Real& x : change) x = Real(h) * x;
      limb_solution<R, Real>::factor_and_solve(now.mass, change);
      const auto fits = holds(guess);
      if constexpr (is_in_lanes<Real>)  // a lane that was done stays
        if (rounds > 1) kept.give(done, change, now.mass);
      done = done | fits;
      if (rounds == most_rounds || everywhere(done)) break;
      if constexpr (is_in_lanes<Real>) kept = {change, now.mass};
      guess = change;
      now.mass.entry = free_entries;
    }
  }

  // The velocities take their change, and positions follow. `smooth`: the part of the change that goes on in
  // the next step.
  constexpr void end(motion& m, tree_drives<R, Real>& drives, const vector& smooth) {
    const Real per_second(1 / h);
    m.change_before = m.change;
    if constexpr (tree::floats) {
      m.angular_velocity = m.angular_velocity + base.direction({change[0], change[1], change[2]});
      m.velocity = m.velocity + base.direction({change[3], change[4], change[5]});
      m.change.turning = per_second * base.direction({smooth[0], smooth[1], smooth[2]});
    }
    for (std::size_t c = 0; c < n; ++c) {
      drives.torque[c] = joints[c].motor.at(change[row(c)]).force;
      m.dq[c] = m.dq[c] + change[row(c)];
      m.change.joints[c] = per_second * smooth[row(c)];
      if (R::drives[c].cable.stiffness > 0) drives.pulleys[c].torque = drives.torque[c];
      if (tree::ranges[c].exists()) m.q[c] = m.q[c] - Real(comes_back) * beyond(tree::ranges[c], m.q[c]);
    }
    m.drift(0.5 * h);
  }

  // The force that makes a spring or cable longer, at the change of the step.
  constexpr Real pull_of_line(std::size_t i) const { return lines[i].at(growth_of(i, change)).force; }

private:
  // Of a round: what lanes keep that are done.
  struct none {};
  struct solution {
    vector change{};
    branch_matrix<tree::branches, Real> mass{};
    void give(const auto& done, vector& to, branch_matrix<tree::branches, Real>& factor) const {
      for (std::size_t k = 0; k < to.size(); ++k) {
        to[k] = select(done, change[k], to[k]);
        factor.inverse[k] = select(done, mass.inverse[k], factor.inverse[k]);
      }
      for (std::size_t k = 0; k < factor.entry.size(); ++k)
        factor.entry[k] = select(done, mass.entry[k], factor.entry[k]);
    }
  };

  static constexpr auto n = static_cast<std::size_t>(tree::coordinates);
  static constexpr std::size_t row(std::size_t c) {
    return static_cast<std::size_t>(tree::branches.row[tree::base + c]);
  }

  constexpr void prepare(const motion& m, tree_drives<R, Real>& drives) {
    for (std::size_t c = 0; c < n; ++c) {
      const robots::joint_drive& d = R::drives[c];
      const auto& motor = built->drives[c];
      const law_of<Real>& law = drives.laws[c];
      joint_in_step<Real>& j = joints[c];
      j.now = {h, m.q[c], m.dq[c], now.mass.diagonal(row(c))};
      const bool winds = d.cable.stiffness > 0, holds = is_law_of_position(law);
      pulley<Real>& p = drives.pulleys[c];
      if (winds && holds) p.wind(motor, h);
      else if (winds) p.wound = m.q[c] + Real(0.5 * h) * m.dq[c], p.speed = m.dq[c];
      if (is_any(motor.torque))
        j.motor = winds && holds
                      ? motor_in_step<Real>(d, motor, p.wound - Real(0.5 * h) * p.speed, p.speed, j.now)
                      : motor_in_step<Real>(d, motor, law, j.now);
      if (is_any(motor.friction) || d.spring > 0)
        j.soft =
            soft_law<Real>{Real(d.spring_rest), Real(0.0), Real(0.0), Real(d.spring), Real(motor.friction)}
                .in(j.now);
      if (tree::ranges[c].exists()) j.way_beyond = beyond(tree::ranges[c], m.q[c]);
    }
    for (std::size_t i = 0; i < tree::lines.size(); ++i)
      lines[i] = {tree::lines[i], now.places(), m.dq, [&](std::size_t c) { return joints[c].now.inertia; },
                  h};
  }

  constexpr void rub(std::size_t c, const Real& guess, const Real& last) {
    const Real side = select(Real(built->rubs) > Real(0.0), last, Real(0.0));
    const answer<Real> a = by_dry_friction(Real(built->drives[c].dry_friction), joints[c].now, guess, side);
    taken[c] += a;
    taken[c].side = a.side;
  }

  static constexpr std::size_t coordinate_of_line(std::size_t i, int k) {
    return static_cast<std::size_t>(tree::lines[i].coordinate[static_cast<std::size_t>(k)]);
  }
  constexpr Real growth_of(std::size_t i, const vector& dv) const {
    Real sum{};
    for (int k = 0; k < tree::lines[i].count; ++k) {
      const std::size_t c = coordinate_of_line(i, k);
      sum = sum + lines[i].growth[c] * dv[row(c)];
    }
    return sum;
  }
  constexpr void take(std::size_t i, const vector& guess) {
    const Real dv = growth_of(i, guess);
    const answer<Real> a = taken[n + i] = lines[i].at(dv);
    const Real force = a.force + a.slope * dv;
    const auto& g = lines[i].growth;
    for (int k = 0; k < tree::lines[i].count; ++k) {
      const std::size_t c = coordinate_of_line(i, k);
      change[row(c)] = change[row(c)] + force * g[c];
      for (int l = 0; l < tree::lines[i].count; ++l) {
        const std::size_t d = coordinate_of_line(i, l);
        if (row(d) > row(c)) continue;
        Real& entry = now.mass.row(row(c))[tree::branches.depth[row(d)]];
        entry = entry + Real(h) * a.slope * g[c] * g[d];
      }
    }
  }

  // Whether the forces at the change are those of the pieces that were taken.
  constexpr auto holds(const vector& guess) const {
    auto all = Real(0.0) < Real(1.0);
    const auto check = [&](const answer<Real>& was, const Real& is, const Real& way) {
      const Real off = is - (was.force - was.slope * way), size = Real(1.0) + is * is;
      all = all & (off * off <= Real(1e-18) * size);
    };
    for (std::size_t c = 0; c < n; ++c) {
      const Real& dv = change[row(c)];
      Real force = joints[c].at(dv, joints[c].motor.at(dv)).force;
      if (built->has_dry_friction())
        force =
            force + by_dry_friction(Real(built->drives[c].dry_friction), joints[c].now, dv, Real(0.0)).force;
      check(taken[c], force, dv - guess[row(c)]);
    }
    for (std::size_t i = 0; i < tree::lines.size(); ++i) {
      const Real dv = growth_of(i, change);
      check(taken[n + i], lines[i].at(dv).force, dv - growth_of(i, guess));
    }
    return all;
  }

  double h;
  const built_robot<R, Real>* built;
  std::array<joint_in_step<Real>, n> joints{};
  std::array<line_in_step<R, Real>, tree::lines.size()> lines{};
  std::array<answer<Real>, n + tree::lines.size()> taken{};
  std::array<Real, n> sides{};  // of the motors, in the last round
};

}  // namespace cca::sim::detail
