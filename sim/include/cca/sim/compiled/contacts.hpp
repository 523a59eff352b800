// The contacts of a compiled world in one step: found in its middle, solved together, added to the change of
// the velocities.
//
// Probes (probes.hpp) against the ground: a floor, or strips of a terrain. A contact is a spring and a damper
// in SI units that acts where the step ends, and friction is a true cone. The speeds that impulses cause come
// from the factor of the step, so a contact feels the springs, servos and couplings of the robot. Its memory
// is for `most` contacts; of more the deepest count. Impulses of the last step are the first guess.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/unrolled.hpp>
#include <cca/sim/compiled/contact_solver.hpp>
#include <cca/sim/compiled/ground.hpp>
#include <cca/sim/compiled/limbs/straight_loops.hpp>
#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

template <class Real>
struct contact_force {
  std::size_t probe = 0;
  triple<Real> at{}, normal{}, force{};  // in the world: m, N
  Real speed{}, lost{};                  // along the ground: m/s after the step; J, to friction
};

// Of two changes of the velocities, without and with contacts: the smaller one, or none if they go two ways.
// It is what goes on in the next step: an impact does not, and at rest nothing does.
template <class Vector>
constexpr Vector lasting(const Vector& without, const Vector& with) {
  using Real = typename Vector::value_type;
  Vector v{};
  const Real zero(0.0);
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] = smaller(larger(without[k], zero), larger(with[k], zero)) +
           larger(smaller(without[k], zero), smaller(with[k], zero));
  return v;
}

template <class R, class Real>
class contacts_in_step {
public:
  using tree = compiled_tree<R>;
  using probes = probes_of<R>;
  static constexpr std::size_t most = most_contacts<Real>(probes::count), longest = probes::longest;
  using impulses = std::array<triple<Real>, probes::count>;  // of the last step, in the world

  std::size_t count = 0;

  // The change of the step becomes that with contacts. `last`: takes the impulses.
  constexpr void solve(tree_step<R, Real>& step,
                       const tree_motion<Real, tree::coordinates, tree::floats>& m,
                       const ground& under,
                       impulses& last,
                       double h) {
    find(step, under);
    if (count > 0) {
      prepare(step, m, under, last, h);
      solve_contacts(laws, count, meeting);
    }
    for (auto& p : last) p = {};
    if (count > 0) apply(step, last);
  }

  // After the step: what each contact did. `f(contact_force)`.
  template <class F>
  constexpr void each(double h, F f) const {
    for (std::size_t k = 0; k < count; ++k) {
      const contact& c = found[k];
      const auto& p = laws[k].impulse;
      contact_force<Real> made;
      made.probe = c.probe, made.at = c.world, made.normal = c.touch.normal;
      made.force = Real(1 / h) * (p[0] * c.axes[0] + p[1] * c.axes[1] + p[2] * c.axes[2]);
      const auto &from = c.slip_before, &to = c.slip;
      made.speed = root(to[0] * to[0] + to[1] * to[1]);
      made.lost = Real(-0.5) * (p[1] * (from[0] + to[0]) + p[2] * (from[1] + to[1]));
      f(made);
    }
  }

private:
  struct contact {
    std::size_t probe = 0, length = 0;  // length: rows of its branch
    ground_touch<Real> touch{};
    triple<Real> world{}, axes[3]{};             // in the world
    std::array<std::array<Real, longest>, 3> w;  // D^-1/2 L^-T J^T, over the rows of its branch
    std::array<Real, 2> slip_before{}, slip{};   // m/s along the tangents, before and after the step
  };

  constexpr void find(const tree_step<R, Real>& step, const ground& under) {
    count = 0;
    std::size_t shallow = 0;
    const bool is_level = under.profile.is_level();
    const triple<Real> up{step.base.axes[0][2], step.base.axes[1][2], step.base.axes[2][2]};
    int link = -2;
    triple<Real> rise{};  // of the link's axes
    Real height{};        // of its origin, above the floor
    for (std::size_t i = 0; i < probes::count; ++i) {
      const probe& p = probes::all[i];
      if (is_level) {
        if (p.link != link) {
          link = p.link;
          height = step.base.at[2] - Real(under.floor), rise = up;
          if (link >= 0) {
            const auto& f = step.now.places[static_cast<std::size_t>(link)];
            height = height + dot(up, f.at), rise = along(f, up);
          }
        }
        const Real above =
            height + Real(p.at[0]) * rise[0] + Real(p.at[1]) * rise[1] + Real(p.at[2]) * rise[2];
        if (everywhere(above > Real(p.radius + 1e-9))) continue;
      }
      const triple<Real> at = on_links<R, Real>::point(step.now.places, p.link, p.at),
                         world = step.base.at + step.base.direction(at);
      const ground_touch<Real> t = touch_of(under, world, p.radius);
      if (everywhere(!(t.depth > Real(0.0)))) continue;
      std::size_t place = count;
      if (count < most) {
        ++count;
      } else {
        place = shallow;
        if (everywhere(!(t.depth > found[shallow].touch.depth))) continue;
      }
      found[place].probe = i, found[place].touch = t;
      found[place].world = world - Real(p.radius) * t.normal;
      for (std::size_t k = 0; k < count; ++k)
        if (everywhere(found[k].touch.depth < found[shallow].touch.depth)) shallow = k;
    }
  }

  constexpr void prepare(const tree_step<R, Real>& step,
                         const tree_motion<Real, tree::coordinates, tree::floats>& m,
                         const ground& under,
                         const impulses& last,
                         double h) {
    const double stiff = 0.5 * h * under.contact.stiffness, damp = under.contact.damping;
    const double give = 1 / (h * (stiff + damp)), back = under.contact.stiffness / (stiff + damp);
    typename on_links<R, Real>::vector speed = step.change, scale{};
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
    for (std::size_t k = 0; k < count; ++k) {
      contact& x = found[k];
      contact_law<Real>& l = laws[k];
      l = {};
      l.give = Real(give), l.friction = Real(under.contact.friction);
      l.bias = between(Real(0.0), Real(back) * (x.touch.depth - Real(under.surface_layer)),
                       Real(under.correcting_speed));
      set_tangents(x);
      fill(step, x, l, speed, scale);
      l.is_cone = !under.contact.pyramid;
      turn_tangents(x, l);
      // Of a point that can't move along the surface the speed is 0, and any impulse would do: none.
      for (std::size_t r = 1; r < 3; ++r) l.own[r] = l.own[r] + Real(1e-10 * give);
      for (std::size_t r = 0; r < 3; ++r) l.impulse[r] = dot(x.axes[r], last[x.probe]);
      if constexpr (is_in_lanes<Real>) l.only_where(x.touch.depth > Real(0.0));
    }
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t j = 0; j < k; ++j) {
        const std::size_t both = shared(probes::all[found[k].probe].tip, probes::all[found[j].probe].tip);
        contact_block<Real>&one = meeting[k][j], &other = meeting[j][k];
        with_common(both, found[k].w, found[j].w, one);
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t s = 0; s < 3; ++s) other[3 * r + s] = one[3 * s + r];
      }
  }
  static constexpr void with_common(std::size_t rows, const auto& a, const auto& b, contact_block<Real>& to) {
    constexpr auto base = static_cast<std::size_t>(tree::base);
    Real sums[9]{};
    const auto add = [&](std::size_t i) {
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t s = 0; s < 3; ++s) sums[3 * r + s] = sums[3 * r + s] + a[r][i] * b[s][i];
    };
    cca::detail::unrolled<tree::base>([&](auto i) { add(static_cast<std::size_t>(i())); });
    for (std::size_t i = base; i < rows; ++i) add(i);
    for (std::size_t k = 0; k < 9; ++k) to[k] = sums[k];
  }

  // Of two branches: how many rows they have in common, from the first.
  static constexpr std::size_t shared(int a, int b) {
    const auto& of = tree::branches;
    const auto &one = of.way[static_cast<std::size_t>(a)], &other = of.way[static_cast<std::size_t>(b)];
    std::size_t k = 0;
    while (k < longest && static_cast<int>(k) <= of.depth[static_cast<std::size_t>(a)] &&
           static_cast<int>(k) <= of.depth[static_cast<std::size_t>(b)] && one[k] == other[k])
      ++k;
    return k;
  }

  static constexpr void set_tangents(contact& x) {
    const triple<Real>& n = x.touch.normal;
    const auto steep = n[0] * n[0] > Real(0.5);
    const triple<Real> across{select(steep, Real(0.0), Real(1.0)), select(steep, Real(1.0), Real(0.0)),
                              Real(0.0)};
    const triple<Real> t = across - dot(across, n) * n;
    x.axes[0] = n, x.axes[1] = (Real(1.0) / root(dot(t, t))) * t, x.axes[2] = cross(n, x.axes[1]);
  }

  static constexpr void fill(const tree_step<R, Real>& step,
                             contact& x,
                             contact_law<Real>& l,
                             const typename on_links<R, Real>::vector& speed,
                             const typename on_links<R, Real>::vector& scale) {
    constexpr const auto& of = tree::branches;
    const probe& p = probes::all[x.probe];
    const auto& way = of.way[static_cast<std::size_t>(p.tip)];
    const auto length = static_cast<std::size_t>(of.depth[static_cast<std::size_t>(p.tip)] + 1);
    x.length = length;
    const triple<Real> at = along(step.base, x.world - step.base.at);
    triple<Real> d[3];
    for (std::size_t r = 0; r < 3; ++r) {
      x.w[r] = {};
      d[r] = along(step.base, x.axes[r]);
      if constexpr (tree::floats) {
        const triple<Real> moment = cross(at, d[r]);
        for (std::size_t k = 0; k < 3; ++k) x.w[r][k] = moment[k], x.w[r][3 + k] = d[r][k];
      }
    }
    on_links<R, Real>::each_joint(
        step.now.places, p.link,
        [&](std::size_t row, const triple<Real>& axis, const triple<Real>& from, bool turns) {
          const triple<Real> moves = turns ? cross(axis, at - from) : axis;
          const auto k = static_cast<std::size_t>(of.depth[row]);
          for (std::size_t r = 0; r < 3; ++r) x.w[r][k] = x.w[r][k] + dot(d[r], moves);
        });
    with_length<is_length>(length, [&](auto whole) {
      constexpr auto size = static_cast<std::size_t>(whole());
      const Real* rows[size];
      triple<Real> before, now;
      each_of<size>([&](std::size_t k) {
        const auto row = static_cast<std::size_t>(way[k]);
        rows[k] = step.now.mass.row(row);
        const Real v = speed[row], dv = step.change[row];
        for (std::size_t r = 0; r < 3; ++r) now[r] = now[r] + x.w[r][k] * v;
        for (std::size_t r = 1; r < 3; ++r) before[r] = before[r] + x.w[r][k] * dv;
      });
      for (std::size_t r = 0; r < 3; ++r) l.speed[r] = now[r];
      for (std::size_t r = 1; r < 3; ++r) x.slip_before[r - 1] = now[r] - before[r];
      eliminate<size>(rows, x);
      each_of<size>([&](std::size_t k) {
        const Real by = scale[static_cast<std::size_t>(way[k])];
        for (std::size_t r = 0; r < 3; ++r) x.w[r][k] = x.w[r][k] * by;
      });
    });
  }
  // w becomes L^-T w.
  template <std::size_t Size>
  static constexpr void eliminate(const Real* const* rows, contact& x) {
    each_of<Size>([&](auto before) {
      const std::size_t i = Size - 1 - static_cast<std::size_t>(before);
      triple<Real> own{x.w[0][i], x.w[1][i], x.w[2][i]};
      each_before<Size>(before, [&](std::size_t less) {
        const std::size_t k = Size - 1 - less;
        for (std::size_t r = 0; r < 3; ++r) own[r] = own[r] - rows[k][i] * x.w[r][k];
      });
      for (std::size_t r = 0; r < 3; ++r) x.w[r][i] = own[r];
    });
  }

  // The lengths that branches with probes have, in rows.
  static constexpr auto is_length = [] {
    std::array<bool, longest + 1> is{};
    for (const probe& p : probes::all)
      if (p.tip >= 0)
        is[static_cast<std::size_t>(tree::branches.depth[static_cast<std::size_t>(p.tip)] + 1)] = true;
    return is;
  }();

  // Turns the tangents until an impulse along one causes no speed along the other.
  static constexpr void turn_tangents(contact& x, contact_law<Real>& l) {
    Real g[6]{};
    for (std::size_t i = 0; i < x.length; ++i) {
      const Real a = x.w[0][i], b = x.w[1][i], c = x.w[2][i];
      g[0] = g[0] + a * a, g[1] = g[1] + b * b, g[2] = g[2] + c * c;
      g[3] = g[3] + a * b, g[4] = g[4] + a * c, g[5] = g[5] + b * c;
    }
    if (!l.is_cone) return l.take(g);
    const Real d = g[2] - g[1], twice = g[5] + g[5], size = larger(d, -d);
    const Real sign = select(d < Real(0.0), Real(-1.0), Real(1.0));
    const Real t = sign * twice / (size + root(larger(d * d + twice * twice, Real(1e-200))));
    const Real c = Real(1.0) / root(Real(1.0) + t * t), s = t * c;
    const auto turn = [&](auto& a, auto& b) {
      const auto before = a;
      a = c * before - s * b;
      b = s * before + c * b;
    };
    turn(x.axes[1], x.axes[2]);
    turn(l.speed[1], l.speed[2]);
    turn(x.slip_before[0], x.slip_before[1]);
    for (std::size_t i = 0; i < x.length; ++i) turn(x.w[1][i], x.w[2][i]);
    l.own = {g[0], g[1] - t * g[5], g[2] + t * g[5]};
    turn(g[3], g[4]);
    l.coupling = {g[3], g[4]};
  }

  constexpr void apply(tree_step<R, Real>& step, impulses& last) {
    typename on_links<R, Real>::vector z{};
    for (std::size_t k = 0; k < count; ++k) {
      const contact& x = found[k];
      const auto& p = laws[k].impulse;
      last[x.probe] = p[0] * x.axes[0] + p[1] * x.axes[1] + p[2] * x.axes[2];
      const auto tip = static_cast<std::size_t>(probes::all[x.probe].tip);
      for (std::size_t i = 0; i <= static_cast<std::size_t>(tree::branches.depth[tip]); ++i) {
        Real& sum = z[static_cast<std::size_t>(tree::branches.way[tip][i])];
        sum = sum + (x.w[0][i] * p[0] + x.w[1][i] * p[1] + x.w[2][i] * p[2]);
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      contact& x = found[k];
      const auto tip = static_cast<std::size_t>(probes::all[x.probe].tip);
      x.slip = {laws[k].speed[1], laws[k].speed[2]};
      for (std::size_t i = 0; i <= static_cast<std::size_t>(tree::branches.depth[tip]); ++i) {
        const Real& change = z[static_cast<std::size_t>(tree::branches.way[tip][i])];
        for (std::size_t r = 0; r < 2; ++r) x.slip[r] = x.slip[r] + x.w[r + 1][i] * change;
      }
    }
    for (std::size_t k = 0; k < z.size(); ++k) z[k] = z[k] * root(step.now.mass.inverse[k]);
    limb_solution<R, Real>::forward(step.now.mass, z);
    for (std::size_t k = 0; k < z.size(); ++k) step.change[k] = step.change[k] + z[k];
  }

  // Without values: to write them would cost more than a step without contacts.
  std::array<contact, most> found;
  std::array<contact_law<Real>, most> laws;
  std::array<std::array<contact_block<Real>, most>, most> meeting;
};

}  // namespace cca::sim::detail
