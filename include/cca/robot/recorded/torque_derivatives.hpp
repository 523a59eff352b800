// The derivatives of inverse dynamics of a reduced body, for recordings: in the axes of the links.
//
// A small turn of joint j moves all particles behind it by one field of velocities, S_j; that field itself
// turns with the body before the joint: its first and second derivatives in time are P = v x S and Q = a x S
// + v x P. With the composite bodies behind j - their inertia I, twice their Coriolis factor B, their load f
// - a joint i before j, or j itself, has
//   d tau_i / dq_j  = S_i (B P_j + I Q_j + S_j x f_j)       d tau_j / dq_i  = S_j (B P_i + I Q_i)
//   d tau_i / d dq_j = S_i (B S_j + 2 I P_j)                d tau_j / d dq_i = S_j (B S_i + 2 I P_i)
// where I, B are those of j. v has the velocity of the base's origin subtracted.
// Source: Singh, Russell, Wensing, Efficient Analytical Derivatives of Rigid-Body Dynamics Using Spatial
// Vector Algebra, IEEE Robotics and Automation Letters 7(2), 2022. Here B is the integral of P^T dP/dt over
// the mass, as in coriolis_matrix.hpp.
#pragma once

#include <cca/robot/recorded/quantities.hpp>

namespace cca::detail {

// Of a rigid body that moves: angular velocity, and velocity of the origin. Or its derivatives.
template <class S>
struct field_of_velocities {
  triple<S> angular{}, linear{};
};

// The sum of velocity times place, and of velocity, over the mass of a body; both twice.
template <class S>
struct moving_mass {
  triple<S> rows[3]{}, momentum{};

  constexpr moving_mass() = default;
  constexpr moving_mass(const mass_moments& of, const triple<S>& w, const triple<S>& u) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto j = [&](std::size_t r) { return S(2 * (r < c ? of.at(r, c) : of.at(c, r))); };
      const triple<S> column = cross(w, triple<S>{j(0), j(1), j(2)}) + S(2 * of.first[c]) * u;
      for (std::size_t r = 0; r < 3; ++r) rows[r][c] = column[r];
    }
    momentum = cross(w, {2 * of.first[0], 2 * of.first[1], 2 * of.first[2]}) + S(2 * of.mass) * u;
  }

  // The load of a field of accelerations a x velocity. Transposed, for a = the axis z.
  constexpr link_load<S> load_of(const triple<S>& a) const {
    link_load<S> l;
    for (std::size_t r = 0; r < 3; ++r) {
      const std::size_t x = (r + 1) % 3, y = (r + 2) % 3;
      l.moment[r] = (rows[x][x] + rows[y][y]) * a[r] - rows[r][x] * a[x] - rows[r][y] * a[y];
    }
    l.force = cross(a, momentum);
    return l;
  }
  constexpr triple<S> moment_back(const reduced_link& joint) const {
    const std::size_t z = joint.axis, x = (z + 1) % 3, y = (z + 2) % 3;
    triple<S> m;
    if (joint.revolute) m[x] = -rows[z][x], m[y] = -rows[z][y], m[z] = rows[x][x] + rows[y][y];
    else m[x] = momentum[y], m[y] = -momentum[x];
    return m;
  }

  // Adds a body that moves in this one by a joint.
  constexpr void add(moving_mass b, const placed_joint<S>& j) {
    b.turn(j);
    const triple<S> k = j.up(b.momentum);
    for (std::size_t r = 0; r < 3; ++r) rows[r] = rows[r] + b.rows[r] + k[r] * j.at;
    momentum = momentum + k;
  }

private:
  constexpr void turn(const placed_joint<S>& j) {
    if (j.link->revolute) {
      const std::size_t z = j.link->axis, x = (z + 1) % 3, y = (z + 2) % 3;
      const S t = j.cosine * (rows[x][x] - rows[y][y]) - j.sine * (rows[x][y] + rows[y][x]), xx = rows[x][x],
              xz = rows[x][z], yz = rows[y][z], zx = rows[z][x], zy = rows[z][y];
      rows[x][x] = rows[y][y] + j.cosine * t;
      rows[y][y] = xx - j.cosine * t;
      rows[x][y] = rows[x][y] + j.sine * t;
      rows[y][x] = rows[y][x] + j.sine * t;
      rows[x][z] = j.cosine * xz - j.sine * yz;
      rows[y][z] = j.sine * xz + j.cosine * yz;
      rows[z][x] = j.cosine * zx - j.sine * zy;
      rows[z][y] = j.sine * zx + j.cosine * zy;
    }
    if (j.link->straight) return;
    for (triple<S>& row : rows) row = j.fixed_up(row);
    for (std::size_t c = 0; c < 3; ++c) {
      const triple<S> column = j.fixed_up({rows[0][c], rows[1][c], rows[2][c]});
      for (std::size_t r = 0; r < 3; ++r) rows[r][c] = column[r];
    }
  }
};

// The load that gives a composite body these accelerations.
template <class S>
constexpr link_load<S> load_of(const composite<S>& b, const field_of_velocities<S>& a) {
  link_load<S> l;
  l.force = cross(a.angular, b.first) + b.mass * a.linear;
  l.moment = cross(b.first, a.linear);
  for (std::size_t r = 0; r < 3; ++r) {
    const std::size_t x = (r + 1) % 3, y = (r + 2) % 3;
    l.moment[r] = l.moment[r] + ((b.at(x, x) + b.at(y, y)) * a.angular[r] - b.at(r, x) * a.angular[x] -
                                 b.at(r, y) * a.angular[y]);
  }
  return l;
}

template <class S>
constexpr link_load<S> operator+(const link_load<S>& a, const link_load<S>& b) {
  return {a.moment + b.moment, a.force + b.force};
}
template <class S>
constexpr S product(const link_load<S>& l, const field_of_velocities<S>& t) {
  const triple<S>&m = l.moment, &f = l.force, &w = t.angular, &u = t.linear;
  return m[0] * w[0] + m[1] * w[1] + m[2] * w[2] + (f[0] * u[0] + f[1] * u[1] + f[2] * u[2]);
}

// The velocity of a link's origin from the motion of the link before.
template <class S>
constexpr triple<S> velocity_behind(const placed_joint<S>& j,
                                    const triple<S>& w,
                                    const triple<S>& before,
                                    const S& speed) {
  triple<S> u = j.down(before + cross(w, j.at));
  if (!j.link->revolute) u[j.link->axis] = u[j.link->axis] + speed;
  return u;
}

template <class S, int Size>
struct torque_derivatives {
  std::array<S, static_cast<std::size_t>(Size)> torques{};
  square<S, Size> by_angles{}, by_velocities{}, mass{};
};

// A joint in motion, per unit of its coordinate: P and Q above.
template <class S>
struct joint_field {
  field_of_velocities<S> first, second;

  constexpr joint_field() = default;
  constexpr joint_field(const reduced_link& l, const link_motion<S>& m, const triple<S>& u) {
    const std::size_t z = l.axis, x = (z + 1) % 3, y = (z + 2) % 3;
    const S ratio = l.ratio;
    triple<S> turn, change = m.column(z);
    turn[x] = m.w[y], turn[y] = -m.w[x];
    if (l.revolute) {
      const triple<S> w2{S(2.0) * turn[0], S(2.0) * turn[1], S(2.0) * turn[2]};
      triple<S> along = cross(u, w2);
      along[x] = along[x] + m.a[y], along[y] = along[y] - m.a[x];
      first.angular = ratio * turn, first.linear[x] = ratio * u[y], first.linear[y] = -(ratio * u[x]);
      second = {ratio * change, ratio * along};
    } else {
      first.linear = ratio * turn, second.linear = ratio * change;
    }
  }
};

// `root`: of the base, with gravity taken from its acceleration. Without `Angles` only the derivatives by the
// velocities and the mass matrix. The loads are then not set, and not read either (docs/compilers.md).
template <int Size, bool Angles = true, class S, std::size_t Count, class Vector>
constexpr torque_derivatives<S, Size> differentiated_torques(const reduced_body<Count>& b,
                                                             const std::array<placed_joint<S>, Count>& joints,
                                                             const link_motion<S>& root,
                                                             const Vector& dq,
                                                             const Vector& ddq) {
  torque_derivatives<S, Size> d;
  std::array<link_motion<S>, Count> motion;
  std::array<triple<S>, Count> velocity;
  std::array<joint_field<S>, Count> field;
  std::array<link_load<S>, Count> loads;
  std::array<composite<S>, Count> bodies;
  std::array<moving_mass<S>, Count> moving;
  for (std::size_t i = 0; i < Count; ++i) {
    const reduced_link& l = b.links[i];
    const auto c = static_cast<std::size_t>(l.coordinate), p = static_cast<std::size_t>(l.parent);
    const link_motion<S>& before = l.parent < 0 ? root : motion[p];
    const S speed = S(l.ratio) * dq[c];
    velocity[i] = velocity_behind(joints[i], before.w, l.parent < 0 ? triple<S>{} : velocity[p], speed);
    motion[i] = motion_behind(joints[i], before, speed, S(l.ratio) * ddq[c]);
    field[i] = {l, motion[i], velocity[i]};
    if (Angles) loads[i] = load_for(l.mass, motion[i]);
    bodies[i] = composite<S>(l.mass);
    moving[i] = {l.mass, motion[i].w, velocity[i]};
  }
  for (std::size_t i = Count; i-- > 0;) {
    const reduced_link& own = b.links[i];
    const S ratio = own.ratio;
    const std::size_t z = own.axis, x = (z + 1) % 3, y = (z + 2) % 3;
    const auto c = static_cast<std::size_t>(own.coordinate);
    const triple<S>&f = loads[i].force, &n = loads[i].moment;
    if (Angles) d.torques[c] = d.torques[c] + ratio * (own.revolute ? n[z] : f[z]);

    const joint_field<S>& at_joint = field[i];
    link_load<S> inertia = own.revolute ? bodies[i].load_about(z) : bodies[i].load_along(z);
    inertia = {ratio * inertia.moment, ratio * inertia.force};
    triple<S> back = ratio * moving[i].moment_back(own);
    link_load<S> by_angle;
    if (Angles) by_angle = load_of(bodies[i], at_joint.second) + moving[i].load_of(at_joint.first.angular);
    link_load<S> by_speed = load_of(
        bodies[i], field_of_velocities<S>{S(2.0) * at_joint.first.angular, S(2.0) * at_joint.first.linear});
    link_load<S> turned;  // S x f
    if (own.revolute) {
      triple<S> axis;
      axis[z] = ratio;
      by_speed = by_speed + moving[i].load_of(axis);
      if (Angles) turned = {cross(axis, n), cross(axis, f)};
    } else if (Angles) {
      turned.moment[x] = -(ratio * f[y]), turned.moment[y] = ratio * f[x];
    }
    const auto along = [](const reduced_link& l, const link_load<S>& load) {
      return S(l.ratio) * (l.revolute ? load.moment[l.axis] : load.force[l.axis]);
    };
    const auto add = [](square<S, Size>& m, int row, int column, const S& value) {
      m(row, column) = m(row, column) + value;
    };
    const int k = own.coordinate;
    add(d.by_angles, k, k, along(own, by_angle));
    add(d.by_velocities, k, k, along(own, by_speed));
    add(d.mass, k, k, along(own, inertia));
    by_angle = by_angle + turned;
    for (std::size_t at = i;;) {
      const placed_joint<S>& j = joints[at];
      for (link_load<S>* load : {&inertia, &by_angle, &by_speed}) {
        load->force = j.up(load->force);
        load->moment = j.up(load->moment) + cross(j.at, load->force);
      }
      back = j.up(back);
      if (j.link->parent < 0) break;
      at = static_cast<std::size_t>(j.link->parent);
      const reduced_link& l = b.links[at];
      const field_of_velocities<S>&first = field[at].first, &second = field[at].second;
      const link_load<S> turns{back, {}};
      const S both = along(l, inertia), of_inertia = product(inertia, first);
      add(d.by_angles, l.coordinate, k, along(l, by_angle));
      if (Angles) add(d.by_angles, k, l.coordinate, product(turns, first) + product(inertia, second));
      add(d.by_velocities, l.coordinate, k, along(l, by_speed));
      add(d.by_velocities, k, l.coordinate, along(l, turns) + S(2.0) * of_inertia);
      add(d.mass, l.coordinate, k, both);
      add(d.mass, k, l.coordinate, both);
    }
    if (own.parent < 0) continue;
    const auto p = static_cast<std::size_t>(own.parent);
    if (Angles) {
      const triple<S> force = joints[i].up(f);
      loads[p] = loads[p] + link_load<S>{joints[i].up(n) + cross(joints[i].at, force), force};
    }
    bodies[p].add(bodies[i], joints[i]);
    moving[p].add(moving[i], joints[i]);
  }
  return d;
}

// Velocities, accelerations; gravity, angular velocity, angular acceleration, acceleration.
// Gives torques, then their derivatives by columns.
template <class Body, bool Moving>
struct recorded_torque_derivatives : recorded_quantity<Body, 2, Moving ? 4 : 0> {
  using q = recorded_quantity<Body, 2, Moving ? 4 : 0>;
  static constexpr int n = q::n;
  static constexpr bool is_small = q::is_small && n + 3 * n * n <= static_cast<int>(recorder::most_outputs);
  static constexpr std::array results{n, n* n, n* n, n* n};
  // The base owns a bit, too: the mass matrix does not depend on it.
  static constexpr int owner(int group) {
    const int coordinate = q::owner(group);
    return coordinate < 0 ? n : coordinate;
  }
  static constexpr void record(recorder& r) {
    typename q::reader in{r};
    const auto dq = in.coordinates(), ddq = in.coordinates();
    const auto root = in.template base<Moving>();
    auto d = differentiated_torques<n>(q::body, in.joints(), root, dq, ddq);
    for (std::size_t c = 0; c < d.torques.size(); ++c)
      r.output(d.torques[c], q::sets.branches[c] | 1ull << n);
    for (square<recorded, n>* m : {&d.by_angles, &d.by_velocities, &d.mass})
      for (int column = 0; column < n; ++column)
        for (int row = 0; row < n; ++row) r.output((*m)(row, column), owners(row, column, m != &d.mass));
  }
  static constexpr std::uint64_t owners(int row, int column, bool of_base) {
    const auto of_row = q::sets.branches[static_cast<std::size_t>(row)],
               of_column = q::sets.branches[static_cast<std::size_t>(column)];
    if ((of_row >> column & 1) == 0) return 0;
    return (of_row & of_column) | (of_base ? std::uint64_t{1} << n : 0);
  }
};

// Velocities. Gives the matrix by columns: half of what the torques of a base that stands change with them.
template <class Body>
struct recorded_coriolis_matrix : recorded_quantity<Body, 1, 0> {
  using q = recorded_quantity<Body, 1, 0>;
  static constexpr int n = q::n;
  static constexpr bool is_small = q::is_small && n * n <= static_cast<int>(recorder::most_outputs);
  static constexpr std::array results{n * n};
  static constexpr void record(recorder& r) {
    typename q::reader in{r};
    const auto dq = in.coordinates();
    auto d = differentiated_torques<n, false>(q::body, in.joints(), link_motion<recorded>{}, dq,
                                              typename q::vector{});
    for (int column = 0; column < n; ++column)
      for (int row = 0; row < n; ++row)
        r.output(recorded(0.5) * d.by_velocities(row, column),
                 recorded_torque_derivatives<Body, false>::owners(row, column, false));
  }
};

}  // namespace cca::detail
