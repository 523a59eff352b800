// Inverse dynamics of a reduced body, for recordings: in the axes of the links.
//
// With U = [dw] + [w][w], a point r of a link has the acceleration a + U r. A link then needs the force
// m a + U h and the moment h x a + the antisymmetric part of U J, where m, h, J are its mass moments: many
// are zero (reduced_body.hpp). Source: the recursive Newton-Euler algorithm in this form, Balafoutis and
// Patel, Dynamic Analysis of Robot Manipulators, 1991, chapter 5.
#pragma once

#include <cca/robot/recorded/placed_joints.hpp>

namespace cca::detail {

template <class S>
struct link_motion {
  triple<S> w{}, dw{}, a{};

  // Column c of U.
  constexpr triple<S> column(std::size_t c) const {
    const std::size_t x = (c + 1) % 3, y = (c + 2) % 3;
    triple<S> u;
    u[c] = -(w[x] * w[x] + w[y] * w[y]);
    u[x] = w[c] * w[x] + dw[y];
    u[y] = w[c] * w[y] - dw[x];
    return u;
  }
};

template <class S>
struct link_load {
  triple<S> moment{}, force{};
};

template <class S>
constexpr link_load<S> load_for(const mass_moments& of, const link_motion<S>& m) {
  const triple<S> u[3]{m.column(0), m.column(1), m.column(2)};
  link_load<S> l;
  for (std::size_t r = 0; r < 3; ++r) {
    if (of.mass != 0) l.force[r] = S(of.mass) * m.a[r];
    for (std::size_t c = 0; c < 3; ++c)
      if (of.first[c] != 0) l.force[r] = l.force[r] + S(of.first[c]) * u[c][r];
  }
  for (std::size_t r = 0; r < 3; ++r) {
    const std::size_t y = (r + 1) % 3, z = (r + 2) % 3;
    const auto j = [&](std::size_t a, std::size_t b) { return S(a < b ? of.at(a, b) : of.at(b, a)); };
    l.moment[r] = S(of.first[y]) * m.a[z] - S(of.first[z]) * m.a[y];
    // The entry (z, y) of U J less the entry (y, z).
    l.moment[r] = l.moment[r] + (u[y][z] * j(y, y) - u[z][y] * j(z, z)) + (u[z][z] - u[y][y]) * j(y, z) +
                  (u[r][z] * j(r, y) - u[r][y] * j(r, z));
  }
  return l;
}

// The motion of a link from that of the link before. `speed`, `change`: of its joint.
template <class S>
constexpr link_motion<S> motion_behind(const placed_joint<S>& j,
                                       const link_motion<S>& before,
                                       const S& speed,
                                       const S& change) {
  const reduced_link& l = *j.link;
  const std::size_t z = l.axis, x = (z + 1) % 3, y = (z + 2) % 3;
  link_motion<S> m;
  m.w = j.down(before.w), m.dw = j.down(before.dw);
  triple<S> a = before.a;
  for (std::size_t k = 0; k < 3; ++k)
    if (!l.revolute || l.at[k] != 0) a = a + j.at[k] * before.column(k);
  m.a = j.down(a);
  if (l.revolute) {
    m.dw[x] = m.dw[x] + m.w[y] * speed;
    m.dw[y] = m.dw[y] - m.w[x] * speed;
    m.dw[z] = m.dw[z] + change;
    m.w[z] = m.w[z] + speed;
  } else {
    const S twice = S(2.0) * speed;
    m.a[x] = m.a[x] + m.w[y] * twice;
    m.a[y] = m.a[y] - m.w[x] * twice;
    m.a[z] = m.a[z] + change;
  }
  return m;
}

// Adds to `torques`; gives the load on the base about its origin. `root`: of the base, with gravity taken
// from its acceleration.
template <class S, std::size_t Count, class Vector>
constexpr link_load<S> add_newton_euler(const reduced_body<Count>& b,
                                        const std::array<placed_joint<S>, Count>& joints,
                                        const link_motion<S>& root,
                                        const Vector& dq,
                                        const Vector& ddq,
                                        Vector& torques) {
  std::array<link_motion<S>, Count> motion;
  std::array<link_load<S>, Count> loads;
  for (std::size_t i = 0; i < Count; ++i) {
    const reduced_link& l = b.links[i];
    const auto c = static_cast<std::size_t>(l.coordinate);
    const link_motion<S>& before = l.parent < 0 ? root : motion[static_cast<std::size_t>(l.parent)];
    motion[i] = motion_behind(joints[i], before, S(l.ratio) * dq[c], S(l.ratio) * ddq[c]);
    loads[i] = load_for(l.mass, motion[i]);
  }
  link_load<S> at_base = load_for(b.base, root);
  for (std::size_t i = Count; i-- > 0;) {
    const reduced_link& l = b.links[i];
    const auto c = static_cast<std::size_t>(l.coordinate);
    torques[c] = torques[c] + S(l.ratio) * (l.revolute ? loads[i].moment[l.axis] : loads[i].force[l.axis]);
    link_load<S>& below = l.parent < 0 ? at_base : loads[static_cast<std::size_t>(l.parent)];
    const triple<S> force = joints[i].up(loads[i].force);
    below.force = below.force + force;
    below.moment = below.moment + joints[i].up(loads[i].moment) + cross(joints[i].at, force);
  }
  return at_base;
}

}  // namespace cca::detail
