// Contacts of one step, solved together: the impulses for which each contact obeys its law.
//
//   normal     u + give p - bias >= 0, p >= 0, and one of both is 0: a spring and a damper at the end of the step
//   along      the friction takes as much from the slip as it can, at most `friction` times p: a true cone
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

#include <cca/sim/compiled/scalar.hpp>

namespace cca::sim::detail {

struct contact_rounds {
  static constexpr int most = 20, of_slip = 2, of_newton = 3;
  static constexpr double settled = 1e-6;  // m/s
};

// Of one contact: normal, then two tangents.
template <class Real>
struct contact_law {
  std::array<Real, 3> speed{};      // without any impulse
  std::array<Real, 3> own{};        // speed for its own impulses: the diagonal
  std::array<Real, 2> coupling{};   // of the normal with each tangent; the tangents don't meet
  Real give{}, bias{}, friction{};  // m/s for N s; m/s
  std::array<Real, 3> impulse{};

  // Alone, with these speeds from the others.
  constexpr std::array<Real, 3> solved(const std::array<Real, 3>& u) const {
    const Real a = own[0] + give, need = bias - u[0];
    // Sticks: [a p q; p b 0; q 0 c] x = (need, -u1, -u2).
    const Real over =
        Real(1.0) / (a - coupling[0] * coupling[0] / own[1] - coupling[1] * coupling[1] / own[2]);
    const Real n = over * (need + coupling[0] / own[1] * u[1] + coupling[1] / own[2] * u[2]);
    const Real s = -(u[1] + coupling[0] * n) / own[1], t = -(u[2] + coupling[1] * n) / own[2];
    const Real most = friction * larger(n, Real(0.0));
    const auto sticks = (n > Real(0.0)) & (s * s + t * t <= most * most);
    if (everywhere(sticks)) return {n, s, t};
    const auto slipping = slipped(u, need);
    return {select(sticks, n, slipping[0]), select(sticks, s, slipping[1]), select(sticks, t, slipping[2])};
  }

private:
  constexpr std::array<Real, 3> slipped(const std::array<Real, 3>& u, const Real& need) const {
    const Real tiny(1e-100);
    Real n{}, s = impulse[1], t = impulse[2];
    for (int round = 0; round < contact_rounds::of_slip; ++round) {
      n = larger((need - coupling[0] * s - coupling[1] * t) / (own[0] + give), Real(0.0));
      const Real cs = u[1] + coupling[0] * n, ct = u[2] + coupling[1] * n, most = friction * n;
      Real shift{};
      for (int k = 0; k < contact_rounds::of_newton; ++k) {
        const Real is = Real(1.0) / (own[1] + shift), it = Real(1.0) / (own[2] + shift);
        s = -(cs * is), t = -(ct * it);
        const Real square = s * s + t * t, falls = s * s * is + t * t * it,
                   length = root(larger(square, tiny));
        const Real next =
            shift + square / larger(falls, tiny) * ((length - most) / larger(most, Real(1e-30)));
        shift = larger(next, Real(0.0));
      }
      s = -(cs / (own[1] + shift)), t = -(ct / (own[2] + shift));
      const Real square = s * s + t * t;
      const Real keep = select(square > most * most, most / root(larger(square, tiny)), Real(1.0));
      s = s * keep, t = t * keep;
    }
    return {n, s, t};
  }
};

// `meet(k, j, r, s)`: the speed of contact k along r for a unit of impulse of contact j along s.
template <class Real, std::size_t Most, class Meet>
constexpr void solve_contacts(std::array<contact_law<Real>, Most>& all, std::size_t count, Meet meet) {
  for (int round = 1;; ++round) {
    Real change{};
    for (std::size_t k = 0; k < count; ++k) {
      contact_law<Real>& x = all[k];
      std::array<Real, 3> u = x.speed;
      for (std::size_t j = 0; j < count; ++j) {
        if (j == k) continue;
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t s = 0; s < 3; ++s) u[r] = u[r] + meet(k, j, r, s) * all[j].impulse[s];
      }
      const std::array<Real, 3> found = x.solved(u);
      for (std::size_t r = 0; r < 3; ++r) {
        const Real off = (found[r] - x.impulse[r]) * x.own[r];
        change = larger(change, larger(off, -off));
      }
      x.impulse = found;
    }
    if (round == contact_rounds::most || everywhere(change <= Real(contact_rounds::settled))) return;
  }
}

}  // namespace cca::sim::detail
