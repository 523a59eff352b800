// Contacts of one step, solved together: the impulses for which each contact obeys its law.
//
//   normal     u + give p - bias >= 0, p >= 0, and one of both is 0: a spring and a damper at the end of the step
//   along      the friction takes as much from the slip as it can, at most `friction` times p: a true cone, or
//              along each tangent for itself: a pyramid
//
// u: the speed of the contact after the step. Block Gauss-Seidel: each contact in turn, the others given.
// Alone it is solved exactly if it sticks; if it slips, the normal, then the two tangents, which are turned
// so that their block is diagonal, by Newton's method on the circle. It ends when no speed changes by more
// than `settled`, or after `most_rounds`. Sources: Jourdan, Alart and Jean, A Gauss-Seidel like algorithm to
// solve frictional contact problems, 1998; the circle: Moré and Sorensen, Computing a trust region step,
// 1983.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/slots.hpp>
#include <cca/sim/compiled/scalar.hpp>

namespace cca::sim::detail {

struct contact_rounds {
  static constexpr int most = 20, of_slip = 2, of_newton = 3;
  static constexpr double settled = 1e-6;  // m/s
  static constexpr double round = 1e-20;   // of the circle: how far from it, squared
  static constexpr int of_pyramid = 50;
  static constexpr double flat = 1e-13;  // of the pyramid: what its last round changes
};

// The deepest count. Lanes have different ones, so they have more room, if there are as many.
template <class Real>
constexpr std::size_t most_contacts(std::size_t possible) {
  constexpr std::size_t room = is_in_lanes<Real> ? 64 : 32;
  return is_in_lanes<Real> && possible < room ? possible : room;
}

// Of one contact: normal, then two tangents.
template <class Real>
struct contact_law {
  std::array<Real, 3> speed{};     // without any impulse
  std::array<Real, 3> own{};       // speed for its own impulses: the diagonal
  std::array<Real, 2> coupling{};  // of the normal with each tangent
  Real across{};                   // of the tangents: 0 for a cone
  bool is_cone = true;
  Real give{}, bias{}, friction{};  // m/s for N s; m/s
  std::array<Real, 3> impulse{};

  // Of a pyramid: normal, tangents, normal with each tangent, both tangents.
  constexpr void take(const Real (&g)[6]) {
    own = {g[0], g[1], g[2]}, coupling = {g[3], g[4]}, across = g[5];
  }
  // A contact in some lanes gives no impulse in the others.
  template <class Condition>
  constexpr void only_where(const Condition& touches) {
    bias = select(touches, bias, Real(nowhere));
    for (Real& p : impulse) p = select(touches, p, Real(0.0));
  }

  // Once for a step.
  constexpr void begin() {
    const Real one(1.0);
    ease = {one / (own[0] + give), one / own[1], one / own[2]};
    tied = {coupling[0] * ease[1], coupling[1] * ease[2]};
    over = one / (own[0] + give - coupling[0] * tied[0] - coupling[1] * tied[1]);
  }
  // Alone, with these speeds from the others. `done`: in lanes, those that do not need it any more.
  template <class Condition>
  constexpr std::array<Real, 3> solved(const std::array<Real, 3>& u, const Condition& done) {
    const Real need = bias - u[0];
    if (!is_cone) return on_pyramid(u, need);
    // Sticks: [a p q; p b 0; q 0 c] x = (need, -u1, -u2).
    const Real n = over * (need + tied[0] * u[1] + tied[1] * u[2]);
    const Real s = -(ease[1] * u[1] + tied[0] * n), t = -(ease[2] * u[2] + tied[1] * n);
    const Real most = friction * larger(n, Real(0.0));
    const auto presses = n > Real(0.0), holds = s * s + t * t <= most * most;
    const auto sticks = presses & holds;
    auto is_found = sticks;
    // A lane without the contact would pass for one that slips, and never come near its circle.
    if constexpr (is_in_lanes<Real>) is_found = sticks | done | (bias < Real(nowhere / 2));
    const Real none(0.0);
    if (everywhere(is_found))
      return {select(sticks, n, none), select(sticks, s, none), select(sticks, t, none)};
    const auto slipping = slipped(u, need, is_found);
    return {select(sticks, n, slipping[0]), select(sticks, s, slipping[1]), select(sticks, t, slipping[2])};
  }

private:
  static constexpr double nowhere = -1e30;  // m/s, the bias of a contact that is none

  // One number after the other, each within its bounds.
  constexpr std::array<Real, 3> on_pyramid(const std::array<Real, 3>& u, const Real& need) const {
    auto [n, s, t] = impulse;
    auto done = n < n;
    for (int round = 0; round < contact_rounds::of_pyramid; ++round) {
      const Real a = n, b = s, c = t;
      n = select(done, n, larger((need - coupling[0] * s - coupling[1] * t) * ease[0], Real(0.0)));
      const Real most = friction * n;
      s = select(done, s, between(-most, -((u[1] + coupling[0] * n + across * t) * ease[1]), most));
      t = select(done, t, between(-most, -((u[2] + coupling[1] * n + across * s) * ease[2]), most));
      const Real off = larger(larger(n - a, a - n), larger(larger(s - b, b - s), larger(t - c, c - t)));
      done = done | (off <= Real(contact_rounds::flat) * n);
      if (everywhere(done)) break;
    }
    return {n, s, t};
  }

  std::array<Real, 3> ease{};  // 1 / own
  std::array<Real, 2> tied{};  // coupling / own
  Real over{}, shift{};        // shift: of the circle, in the last round

  // `is_found`: where it is not asked for, and leaves nothing.
  template <class Condition>
  constexpr std::array<Real, 3> slipped(const std::array<Real, 3>& u,
                                        const Real& need,
                                        const Condition& is_found) {
    const Real tiny(1e-100);
    Real n{}, s = impulse[1], t = impulse[2];
    for (int round = 0; round < contact_rounds::of_slip; ++round) {
      n = larger((need - coupling[0] * s - coupling[1] * t) * ease[0], Real(0.0));
      const Real cs = u[1] + coupling[0] * n, ct = u[2] + coupling[1] * n, most = friction * n;
      Real size{};
      Condition done = is_found;
      for (int k = 0;; ++k) {
        const Real is = Real(1.0) / (own[1] + shift), it = Real(1.0) / (own[2] + shift);
        s = select(done, s, -(cs * is)), t = select(done, t, -(ct * it));
        const Real square = s * s + t * t;
        size = select(done, size, root(larger(square, tiny)));
        const Real off = size - most;
        if (k > 0) done = done | (off * off <= Real(contact_rounds::round) * most * most);
        if (everywhere(done) || k == contact_rounds::of_newton) break;
        const Real falls = s * s * is + t * t * it;
        const Real next = shift + square / larger(falls, tiny) * (off / larger(most, Real(1e-30)));
        shift = select(done, shift, larger(next, Real(0.0)));
      }
      const Real keep = select(size > most, most / size, Real(1.0));
      s = s * keep, t = t * keep;
    }
    return {n, s, t};
  }
};

// The speed of a contact along r for a unit of impulse of another one along s: [3 r + s].
template <class Real>
using contact_block = std::array<Real, 9>;

// `meeting[k][j]`: of contact k for contact j.
template <class Real, std::size_t Most>
constexpr void solve_contacts(slots<contact_law<Real>, Most>& all,
                              std::size_t count,
                              const std::array<std::array<contact_block<Real>, Most>, Most>& meeting) {
  for (std::size_t k = 0; k < count; ++k) all[k].begin();
  auto done = Real(1.0) < Real(0.0);
  for (int round = 1;; ++round) {
    Real change{};
    for (std::size_t k = 0; k < count; ++k) {
      contact_law<Real>& x = all[k];
      Real u = x.speed[0], v = x.speed[1], w = x.speed[2];
      const auto& row = meeting[k];
      for (std::size_t j = 0; j < count; ++j) {
        if (j == k) continue;
        const contact_block<Real>& b = row[j];
        const auto& [p, q, r] = all[j].impulse;
        u = u + b[0] * p + b[1] * q + b[2] * r;
        v = v + b[3] * p + b[4] * q + b[5] * r;
        w = w + b[6] * p + b[7] * q + b[8] * r;
      }
      const std::array<Real, 3> found = x.solved({u, v, w}, done);
      for (std::size_t r = 0; r < 3; ++r) {
        const Real off = (found[r] - x.impulse[r]) * x.own[r];
        change = larger(change, larger(off, -off));
      }
      for (std::size_t r = 0; r < 3; ++r) x.impulse[r] = select(done, x.impulse[r], found[r]);
    }
    done = done | (change <= Real(contact_rounds::settled));
    if (round == contact_rounds::most || everywhere(done)) return;
  }
}

}  // namespace cca::sim::detail
