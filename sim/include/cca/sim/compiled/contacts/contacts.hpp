// The contacts of a compiled world in one step: found in its middle (touches.hpp), solved together, added to
// the change of the velocities.
//
// A contact is a spring and a damper in SI units that acts where the step ends, and friction is a true cone.
// The speeds that impulses cause come from the factor of the step, so a contact feels the springs, servos and
// couplings of the robot; those of balls from their masses. A box goes its way whatever touches it. Impulses
// of the last step are the first guess.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <cca/sim/compiled/around/surroundings.hpp>
#include <cca/sim/compiled/contacts/contact_on_branch.hpp>
#include <cca/sim/compiled/contacts/contact_solver.hpp>
#include <cca/sim/compiled/contacts/kept_impulses.hpp>
#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/compiled/slots.hpp>
#include <cca/sim/compiled/contacts/touches.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

template <class Real>
struct contact_force {
  int shape = -1;                        // of the robot; -1: a ball's contact with something else
  Real depth{};                          // m; lanes: below 0 where there is none
  triple<Real> at{}, normal{}, force{};  // in the world: m, N
  Real speed{}, lost{};                  // along the surface: m/s after the step; J, to friction
};

template <class R, class Real>
class contacts_in_step {
public:
  using tree = compiled_tree<R>;
  using probes = probes_of<R>;
  using touches = touches_in_step<R, Real>;
  using motion = tree_motion<Real, tree::coordinates, tree::floats>;
  static constexpr std::size_t most = touches::most;
  static constexpr bool has_own = probes::touches_itself;
  using contact = contact_on_branch<R, Real>;
  using impulses = kept_impulses<Real, most>;

  // The change of the step becomes that with contacts. `last`: takes the impulses.
  void solve(tree_step<R, Real>& step,
             const motion& m,
             const surroundings_for<Real>& around,
             impulses& last,
             double h) {
    found.find(step, around.under);
    if constexpr (has_own) found.find_own(step);
    if (found.count > 0) {
      prepare(step, m, around, last, h);
      solve_contacts(laws, found.count, meeting);
      apply(step);
    }
    keep(last);
  }
  // The same, with boxes and balls; balls make their whole step. `after`: of the beat's begin, s,
  // in the middle of the step.
  void solve_with_more(tree_step<R, Real>& step,
                       const motion& m,
                       const surroundings& around,
                       motion_around<Real>& moving,
                       impulses& last,
                       double h,
                       double after,
                       double gravity) {
    moving.drift(around, h / 2);
    found.find(step, around.under);
    if constexpr (has_own) found.find_own(step);
    found.find_around(step, around, moving, after);
    const triple<Real> falls{Real(0.0), Real(0.0), Real(-gravity * h)};
    for (std::size_t i = 0; i < around.balls.count; ++i)
      moving.balls[i].velocity = moving.balls[i].velocity + falls;
    if (found.count > 0) {
      const auto see = [&](std::size_t k) { add_speeds_around(k, around, moving, after, falls); };
      prepare(step, m, around, last, h, see);
      if (around.balls.count > 0) add_balls_to_blocks(around);
      solve_contacts(laws, found.count, meeting);
      apply(step);
      if (around.balls.count > 0) apply_to_balls(around, moving);
    }
    moving.drift(around, h / 2);
    keep(last);
  }

  // After the step: what each contact did. `f(contact_force)`.
  template <class F>
  void each(double h, F f) const {
    for (std::size_t k = 0; k < found.count; ++k) {
      const contact& c = contacts[k];
      const auto& t = found.all[k];
      const auto& p = laws[k].impulse;
      contact_force<Real> made;
      made.shape = t.of->shape, made.depth = t.depth, made.at = t.at, made.normal = t.normal;
      made.force = Real(1 / h) * impulse(k);
      const auto &from = c.slip_before, &to = c.slip;
      made.speed = root(to[0] * to[0] + to[1] * to[1]);
      made.lost = Real(-0.5) * (p[1] * (from[0] + to[0]) + p[2] * (from[1] + to[1]));
      f(made);
      if constexpr (has_own) {
        if (t.own < 0) continue;
        made.shape = t.own, made.lost = Real(0.0);  // the first shape has it
        made.normal = Real(-1.0) * made.normal, made.force = Real(-1.0) * made.force;
        f(made);
      }
    }
  }

private:
  static constexpr auto no_more = [](std::size_t) {};

  // Of a contact of the robot with itself: what its first shape moves.
  contact* second_of(std::size_t k) {
    if constexpr (has_own)
      if (found.all[k].against) return &seconds[k];
    return nullptr;
  }
  // `f(a branch of the contact, its last row)`
  template <class F>
  void each_branch(std::size_t k, F f) {
    f(contacts[k], *found.all[k].of);
    if (contact* const second = second_of(k)) f(*second, *found.all[k].against);
  }

  triple<Real> impulse(std::size_t k) const {
    const auto& p = laws[k].impulse;
    const auto& axes = contacts[k].axes;
    return p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2];
  }
  void keep(impulses& last) const {
    last.count = found.count;
    for (std::size_t k = 0; k < found.count; ++k)
      last.keys[k] = found.all[k].key, last.impulses[k] = impulse(k);
  }

  // `f(ball, its arm, 1 or -1)`
  template <class F>
  void each_ball(std::size_t k, F f) const {
    const auto& t = found.all[k];
    if (t.into >= 0) f(static_cast<std::size_t>(t.into), contacts[k].arms[0], Real(1.0));
    if (t.from >= 0) f(static_cast<std::size_t>(t.from), contacts[k].arms[1], Real(-1.0));
  }

  // The speeds of boxes and balls, which the contact feels; `falls`: the change of a ball's velocity.
  void add_speeds_around(std::size_t k,
                         const surroundings& around,
                         const motion_around<Real>& moving,
                         double after,
                         const triple<Real>& falls) {
    contact& x = contacts[k];
    const auto& t = found.all[k];
    triple<Real> before, now;
    if (t.box >= 0) {
      const box_motion& b = moving.boxes[static_cast<std::size_t>(t.box)];
      if (!b.rests()) {
        const auto given = [](const triple<double>& v) {
          return triple<Real>{Real(v[0]), Real(v[1]), Real(v[2])};
        };
        now = Real(-1.0) * (given(b.velocity) + cross(given(b.turning), t.at - given(b.centre(after))));
        before = now;
      }
    }
    x.loose[0] = x.loose[1] = Real(0.0);
    if (t.into >= 0) x.arms[0] = t.at - moving.balls[static_cast<std::size_t>(t.into)].at;
    if (t.from >= 0) x.arms[1] = t.at - moving.balls[static_cast<std::size_t>(t.from)].at;
    each_ball(k, [&](std::size_t ball, const triple<Real>& arm, const Real& sign) {
      const triple<Real> v = moving.balls[ball].speed(arm);
      now = now + sign * v, before = before + sign * (v - falls);
      const auto& of = around.balls.all[ball];
      x.loose[0] = x.loose[0] + Real(1 / of.mass);
      x.loose[1] = x.loose[1] + Real(1 / of.mass) + Real(1 / of.inertia()) * dot(arm, arm);
    });
    contact_law<Real>& l = laws[k];
    for (std::size_t r = 0; r < 3; ++r) l.speed[r] = l.speed[r] + dot(x.axes[r], now);
    for (std::size_t r = 1; r < 3; ++r) x.slip_before[r - 1] = x.slip_before[r - 1] + dot(x.axes[r], before);
  }

  // What impulses at one contact of a ball do to the speed at another one of it.
  void add_balls_to_blocks(const surroundings& around) {
    for (std::size_t k = 0; k < found.count; ++k)
      for (std::size_t j = 0; j < k; ++j)
        each_ball(k, [&](std::size_t ball, const triple<Real>& arm, const Real& sign) {
          each_ball(j, [&](std::size_t same, const triple<Real>& other_arm, const Real& other_sign) {
            if (ball != same) return;
            const auto& of = around.balls.all[ball];
            const Real both = sign * other_sign, light = Real(1 / of.mass) * both,
                       turns = Real(1 / of.inertia()) * both;
            for (std::size_t r = 0; r < 3; ++r)
              for (std::size_t s = 0; s < 3; ++s) {
                const triple<Real>&a = contacts[k].axes[r], &b = contacts[j].axes[s];
                const Real more = light * dot(a, b) + turns * dot(cross(arm, a), cross(other_arm, b));
                meeting[k][j][3 * r + s] = meeting[k][j][3 * r + s] + more;
                meeting[j][k][3 * s + r] = meeting[j][k][3 * s + r] + more;
              }
          });
        });
  }
  void apply_to_balls(const surroundings& around, motion_around<Real>& moving) {
    std::array<ball_motion<Real>, balls_around::most> change{};
    for (std::size_t k = 0; k < found.count; ++k) {
      const triple<Real> p = impulse(k);
      each_ball(k, [&](std::size_t ball, const triple<Real>& arm, const Real& sign) {
        const auto& of = around.balls.all[ball];
        change[ball].velocity = change[ball].velocity + (sign * Real(1 / of.mass)) * p;
        change[ball].turning = change[ball].turning + (sign * Real(1 / of.inertia())) * cross(arm, p);
      });
    }
    for (std::size_t k = 0; k < found.count; ++k)
      each_ball(k, [&](std::size_t ball, const triple<Real>& arm, const Real& sign) {
        const triple<Real> v = change[ball].speed(arm);
        for (std::size_t r = 1; r < 3; ++r)
          contacts[k].slip[r - 1] = contacts[k].slip[r - 1] + sign * dot(contacts[k].axes[r], v);
      });
    for (std::size_t i = 0; i < around.balls.count; ++i) {
      ball_motion<Real>& b = moving.balls[i];
      b.velocity = b.velocity + change[i].velocity, b.turning = b.turning + change[i].turning;
    }
  }

  // `see(k)` adds the speeds of what else a contact touches.
  template <class See = decltype(no_more)>
  void prepare(const tree_step<R, Real>& step,
               const motion& m,
               const surroundings_for<Real>& around,
               const impulses& last,
               double h,
               See see = {}) {
    const auto& under = around.under;
    const double stiff = 0.5 * h * under.contact.stiffness, damp = under.contact.damping;
    const double give = 1 / (h * (stiff + damp)), back = under.contact.stiffness / (stiff + damp);
    typename on_links<R, Real>::vector speed = step.change;
    if constexpr (tree::floats) {
      const auto turning = along(step.base, m.angular_velocity), velocity = along(step.base, m.velocity);
      for (std::size_t k = 0; k < 3; ++k)
        speed[k] = speed[k] + turning[k], speed[3 + k] = speed[3 + k] + velocity[k];
    }
    for (std::size_t c = 0; c < m.dq.size(); ++c) {
      Real& v = speed[on_links<R, Real>::row(static_cast<int>(c))];
      v = v + m.dq[c];
    }
    for (std::size_t k = 0; k < scale.size(); ++k) scale[k] = root(step.now.mass.inverse[k]);
    constexpr bool has_more = !std::is_same_v<See, decltype(no_more)>;
    for (std::size_t k = 0; k < found.count; ++k) {
      contact& x = contacts.make(k);
      const auto& t = found.all[k];
      contact_law<Real>& l = laws.make(k);
      l.give = Real(give);
      l.friction = t.on_ground || !(has_more || has_own) ? Real(under.friction()) : Real(around.friction);
      l.bias = between(Real(0.0), Real(back) * (t.depth - Real(under.surface_layer)),
                       Real(under.correcting_speed));
      x.set_tangents(t.normal);
      x.fill(step, *t.of, t.at, l, speed, scale);
      contact* second = nullptr;
      if (has_own && t.against) {
        second = &seconds.make(k);
        second->fill_second(step, *t.against, t.at, x, l, speed, scale);
      }
      see(k);
      l.is_cone = !under.contact.pyramid;
      Real g[6]{};
      x.add_own(g);
      if (second) {
        second->add_own(g);
        contact::add_own(contact::with_common(*t.of, *t.against, x.w, second->w), g);
      }
      x.turn_tangents(l, g, second);
      if constexpr (has_more)
        for (std::size_t r = 0; r < 3; ++r) l.own[r] = l.own[r] + x.loose[r < 1 ? 0 : 1];
      // Of a point that can't move along the surface the speed is 0, and any impulse would do: none.
      for (std::size_t r = 1; r < 3; ++r) l.own[r] = l.own[r] + Real(1e-10 * give);
      const triple<Real> before = last.of(t.key, k);
      for (std::size_t r = 0; r < 3; ++r) l.impulse[r] = dot(x.axes[r], before);
      if constexpr (is_in_lanes<Real>) l.only_where(t.depth > Real(0.0));
    }
    for (std::size_t k = 0; k < found.count; ++k)
      for (std::size_t j = 0; j < k; ++j) {
        contact_block<Real>&one = meeting[k][j], &other = meeting[j][k];
        one = contact::with_common(*found.all[k].of, *found.all[j].of, contacts[k].w, contacts[j].w);
        if (has_own) add_second_branches(k, j, one);
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t s = 0; s < 3; ++s) other[3 * r + s] = one[3 * s + r];
      }
  }
  void add_second_branches(std::size_t k, std::size_t j, contact_block<Real>& to) {
    each_branch(k, [&](const contact& a, const probe& p) {
      each_branch(j, [&](const contact& b, const probe& q) {
        if (&a == &contacts[k] && &b == &contacts[j]) return;
        const contact_block<Real> more = contact::with_common(p, q, a.w, b.w);
        for (std::size_t i = 0; i < more.size(); ++i) to[i] = to[i] + more[i];
      });
    });
  }
  void apply(tree_step<R, Real>& step) {
    typename on_links<R, Real>::vector z{};
    for (std::size_t k = 0; k < found.count; ++k) {
      const auto& p = laws[k].impulse;
      each_branch(k, [&](const contact& x, const probe& of) {
        const auto& way = tree::branches.way[static_cast<std::size_t>(of.tip)];
        for (std::size_t i = 0; i < x.length; ++i) {
          Real& sum = z[static_cast<std::size_t>(way[i])];
          sum = sum + (x.w[0][i] * p[0] + x.w[1][i] * p[1] + x.w[2][i] * p[2]);
        }
      });
    }
    for (std::size_t k = 0; k < found.count; ++k) {
      auto& slip = (contacts[k].slip = {laws[k].speed[1], laws[k].speed[2]});
      each_branch(k, [&](const contact& x, const probe& of) {
        const auto& way = tree::branches.way[static_cast<std::size_t>(of.tip)];
        for (std::size_t i = 0; i < x.length; ++i) {
          const Real& change = z[static_cast<std::size_t>(way[i])];
          for (std::size_t r = 0; r < 2; ++r) slip[r] = slip[r] + x.w[r + 1][i] * change;
        }
      });
    }
    for (std::size_t k = 0; k < z.size(); ++k) z[k] = z[k] * scale[k];
    limb_solution<R, Real>::forward(step.now.mass, z);
    for (std::size_t k = 0; k < z.size(); ++k) step.change[k] = step.change[k] + z[k];
  }

  touches found;
  typename on_links<R, Real>::vector scale;  // D^-1/2, of the factor of the step
  slots<contact, most> contacts;
  slots<contact, has_own ? most : 1> seconds;  // second branches
  slots<contact_law<Real>, most> laws;
  std::array<std::array<contact_block<Real>, most>, most> meeting;
};

}  // namespace cca::sim::detail
