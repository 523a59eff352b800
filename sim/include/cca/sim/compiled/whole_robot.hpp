// A robot in a compiled world as it is: its places, its centre of mass, its energies.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/built/added_masses.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/tree_equations.hpp>
#include <cca/sim/engine/moving_frame.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct whole_robot {
  using tree = compiled_tree<R>;
  using motion = tree_motion<Real, tree::coordinates, tree::floats>;
  using links = on_links<R, Real>;

  static constexpr tree_equations<R, Real> at(const motion& m) {
    tree_equations<R, Real> now;
    now.look(m.q);
    return now;
  }

  static Eigen::Vector3d vector_of(const triple<Real>& v) { return {v[0], v[1], v[2]}; }

  // Of a place on a link, in the world.
  static moving_frame frame_of(const motion& m, const place_on_link& p) {
    const auto base = m.frame();
    typename tree_equations<R, Real>::frames places;
    if (p.link >= 0) places = at(m).only_places();
    const auto f = links::end_frame(places, p);
    const auto t =
        links::motion(places, p.link, f.at, {along(base, m.angular_velocity), along(base, m.velocity)}, m.dq);
    const auto given = [&](const triple<Real>& v) { return vector_of(base.direction(v)); };
    moving_frame r;
    for (Eigen::Index k = 0; k < 3; ++k) r.where.turn.col(k) = given(f.axes[static_cast<std::size_t>(k)]);
    r.where.at = given(f.at) + vector_of(base.at);
    r.angular_velocity = given(t.turning), r.velocity = given(t.velocity);
    return r;
  }

  static triple<Real> centre_of_mass(const motion& m, const added_masses<R, number_of<Real>>& added) {
    const auto places = at(m).only_places();
    const auto given = [](const auto& v) { return triple<Real>{Real(v[0]), Real(v[1]), Real(v[2])}; };
    triple<Real> sum = given(tree::reduced.base.first) - Real(tree::held.mass) * given(tree::held.centre);
    for (std::size_t i = 0; i < tree::links; ++i) {
      const auto& of = tree::reduced.links[i].mass;
      sum = sum + Real(of.mass) * places[i].at + places[i].direction(given(of.first));
    }
    if (added.exist()) sum = sum + added.first(places);
    const auto frame = m.frame();
    return frame.at + frame.direction(Real(1 / (tree::mass + added.mass())) * sum);
  }

  // Kinetic, and potential from the height of the world's origin.
  static Real energy(const motion& m, double gravity, const added_masses<R, number_of<Real>>& added) {
    auto now = at(m);
    now.weigh({}, {}, {});
    if (added.exist())
      added.weigh(now, typename tree_equations<R, Real>::coordinates{}, triple<Real>{}, triple<Real>{});
    typename links::vector v{};
    if constexpr (tree::floats) {
      const auto base = m.frame();
      const triple<Real> w = along(base, m.angular_velocity), u = along(base, m.velocity);
      for (std::size_t k = 0; k < 3; ++k) v[k] = w[k], v[3 + k] = u[k];
    }
    for (std::size_t c = 0; c < m.dq.size(); ++c) v[links::row(static_cast<int>(c))] = m.dq[c];
    return Real(0.5) * now.mass.form(v) +
           Real(gravity * (tree::mass + added.mass())) * centre_of_mass(m, added)[2];
  }

  static constexpr Real spring_energy(const motion& m) {
    const auto places = at(m).only_places();
    Real sum{};
    for (const auto& l : tree::lines) {
      const triple<Real> line = line_of(places, l);
      const Real stretch = root(dot(line, line)) - Real(l.rest);
      const Real felt = l.only_pulls ? larger(stretch, Real(0.0)) : stretch;
      sum = sum + Real(0.5 * l.stiffness) * felt * felt;
    }
    for (std::size_t c = 0; c < m.q.size(); ++c) {
      const Real stretch = m.q[c] - Real(R::drives[c].spring_rest);
      sum = sum + Real(0.5 * R::drives[c].spring) * stretch * stretch;
    }
    return sum;
  }

  static constexpr Real tension(const motion& m, std::size_t i) {
    const auto& l = tree::lines[i];
    const auto places = at(m).only_places();
    const triple<Real> line = line_of(places, l);
    const Real length = root(dot(line, line));
    const auto velocity = [&](int link, const std::array<double, 3>& p) {
      return links::motion(places, link, links::point(places, link, p), {}, m.dq).velocity;
    };
    const Real speed = dot(line, velocity(l.to, l.to_at) - velocity(l.from, l.from_at)) /
                       select(length > Real(0.0), length, Real(1.0));
    const Real pull = Real(l.stiffness) * (length - Real(l.rest)) + Real(l.damping) * speed;
    if (!l.only_pulls) return pull;
    return select(length > Real(l.rest), larger(pull, Real(0.0)), Real(0.0));
  }

private:
  template <class Line>
  static constexpr triple<Real> line_of(const typename links::frames& places, const Line& l) {
    return links::point(places, l.to, l.to_at) - links::point(places, l.from, l.from_at);
  }
};

}  // namespace cca::sim::detail
