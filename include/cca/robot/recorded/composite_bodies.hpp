// The mass matrix of a reduced body, and the solution of a system with it, for recordings.
//
// Composite rigid body algorithm in the axes of the links, with second moments instead of inertia:
// Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.2; floating base: section 9.3. Solution: L^T
// D L, section 8.4, the coordinates in the order of the links, so that zeros between branches stay zeros.
#pragma once

#include <cca/robot/recorded/newton_euler.hpp>

namespace cca::detail {

template <class S>
struct composite {
  S mass{};
  triple<S> first{};
  std::array<S, 6> second{};

  constexpr composite() = default;
  constexpr explicit composite(const mass_moments& of) : mass(of.mass) {
    for (std::size_t k = 0; k < 3; ++k) first[k] = S(of.first[k]);
    for (std::size_t k = 0; k < 6; ++k) second[k] = S(of.second[k]);
  }
  constexpr S& at(std::size_t r, std::size_t c) {
    return second[r < c ? mass_moments::index(r, c) : mass_moments::index(c, r)];
  }
  constexpr const S& at(std::size_t r, std::size_t c) const {
    return second[r < c ? mass_moments::index(r, c) : mass_moments::index(c, r)];
  }

  // The load of a unit of acceleration along, or about, an axis at the origin.
  constexpr link_load<S> load_along(std::size_t z) const {
    const std::size_t x = (z + 1) % 3, y = (z + 2) % 3;
    link_load<S> l;
    l.force[z] = mass;
    l.moment[x] = first[y], l.moment[y] = -first[x];
    return l;
  }
  constexpr link_load<S> load_about(std::size_t z) const {
    const std::size_t x = (z + 1) % 3, y = (z + 2) % 3;
    link_load<S> l;
    l.force[x] = -first[y], l.force[y] = first[x];
    l.moment[x] = -at(x, z), l.moment[y] = -at(y, z), l.moment[z] = at(x, x) + at(y, y);
    return l;
  }

  // Adds a body that moves in this one by a joint.
  constexpr void add(composite b, const placed_joint<S>& j) {
    b.turn(j);
    const triple<S> h = j.up(b.first), &r = j.at;
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t c = a; c < 3; ++c)
        at(a, c) = at(a, c) + b.at(a, c) + (r[a] * h[c] + h[a] * r[c] + b.mass * (r[a] * r[c]));
      first[a] = first[a] + h[a] + b.mass * r[a];
    }
    mass = mass + b.mass;
  }

private:
  // The second moments, to the axes of the link before.
  constexpr void turn(const placed_joint<S>& j) {
    if (j.link->revolute) {
      const std::size_t z = j.link->axis, x = (z + 1) % 3, y = (z + 2) % 3;
      const S t = j.cosine * (at(x, x) - at(y, y)) - j.sine * (S(2.0) * at(x, y)), xx = at(x, x),
              xz = at(x, z), yz = at(y, z);
      at(x, x) = at(y, y) + j.cosine * t;
      at(y, y) = xx - j.cosine * t;
      at(x, y) = at(x, y) + j.sine * t;
      at(x, z) = j.cosine * xz - j.sine * yz;
      at(y, z) = j.sine * xz + j.cosine * yz;
    }
    if (j.link->straight) return;
    triple<S> rows[3];
    for (std::size_t r = 0; r < 3; ++r) rows[r] = j.fixed_up({at(r, 0), at(r, 1), at(r, 2)});
    for (std::size_t c = 0; c < 3; ++c) {
      const triple<S> column = j.fixed_up({rows[0][c], rows[1][c], rows[2][c]});
      for (std::size_t r = 0; r <= c; ++r) at(r, c) = column[r];
    }
  }
};

template <class S, int Size>
struct square {
  std::array<S, static_cast<std::size_t>(Size* Size)> e{};
  constexpr S& operator()(int r, int c) { return e[static_cast<std::size_t>(r + Size * c)]; }
};

// The coordinates begin at `Size - n`: the base, if it floats, has the first six.
template <bool Floating, class S, std::size_t Count, int Size>
constexpr void add_mass_matrix(const reduced_body<Count>& b,
                               const std::array<placed_joint<S>, Count>& joints,
                               square<S, Size>& m) {
  constexpr int first = Floating ? 6 : 0;
  std::array<composite<S>, Count> bodies;
  composite<S> all(b.base);
  for (std::size_t i = 0; i < Count; ++i) bodies[i] = composite<S>(b.links[i].mass);
  for (std::size_t i = Count; i-- > 0;) {
    const reduced_link& own = b.links[i];
    const S ratio = own.ratio;
    link_load<S> load = own.revolute ? bodies[i].load_about(own.axis) : bodies[i].load_along(own.axis);
    load.moment = ratio * load.moment, load.force = ratio * load.force;
    const int row = first + own.coordinate;
    m(row, row) = m(row, row) + ratio * (own.revolute ? load.moment[own.axis] : load.force[own.axis]);
    for (auto at = static_cast<int>(i);;) {
      const placed_joint<S>& j = joints[static_cast<std::size_t>(at)];
      load.force = j.up(load.force);
      load.moment = j.up(load.moment) + cross(j.at, load.force);
      at = j.link->parent;
      if (at < 0) break;
      const reduced_link& l = b.links[static_cast<std::size_t>(at)];
      const S both = S(l.ratio) * (l.revolute ? load.moment[l.axis] : load.force[l.axis]);
      const int column = first + l.coordinate;
      m(row, column) = m(row, column) + both;
      m(column, row) = m(column, row) + both;
    }
    if constexpr (Floating)
      for (int k = 0; k < 3; ++k) {
        m(row, k) = m(k, row) = m(k, row) + load.moment[static_cast<std::size_t>(k)];
        m(row, k + 3) = m(k + 3, row) = m(k + 3, row) + load.force[static_cast<std::size_t>(k)];
      }
    if (own.parent >= 0) bodies[static_cast<std::size_t>(own.parent)].add(bodies[i], joints[i]);
    else if (Floating) all.add(bodies[i], joints[i]);
  }
  if constexpr (Floating)
    for (std::size_t z = 0; z < 3; ++z) {
      const link_load<S> about = all.load_about(z), along = all.load_along(z);
      const int c = static_cast<int>(z);
      for (std::size_t k = 0; k < 3; ++k) {
        const int r = static_cast<int>(k);
        m(r, c) = about.moment[k], m(r + 3, c) = about.force[k];
        m(r, c + 3) = along.moment[k], m(r + 3, c + 3) = along.force[k];
      }
    }
}

// The base, then the coordinates in the order of the links: each after those before it on its branch.
template <bool Floating, int Size, std::size_t Count>
constexpr std::array<int, static_cast<std::size_t>(Size)> order_of_solution(const reduced_body<Count>& b) {
  std::array<int, static_cast<std::size_t>(Size)> order{};
  std::array<bool, static_cast<std::size_t>(Size)> done{};
  std::size_t used = 0;
  const auto add = [&](int k) {
    if (!done[static_cast<std::size_t>(k)]) order[used++] = k;
    done[static_cast<std::size_t>(k)] = true;
  };
  if (Floating)
    for (int k = 0; k < 6; ++k) add(k);
  for (const reduced_link& l : b.links) add((Floating ? 6 : 0) + l.coordinate);
  for (int k = 0; k < Size; ++k) add(k);
  return order;
}

constexpr bool is_zero(const recorded& x) { return x.is_constant() && x.constant == 0; }
constexpr bool is_zero(double) { return false; }

// m x = v; x replaces v, and m is used up. False: a coordinate moves no mass.
template <class S, int Size>
constexpr bool solve(square<S, Size>& m,
                     std::array<S, static_cast<std::size_t>(Size)>& v,
                     const std::array<int, static_cast<std::size_t>(Size)>& order) {
  const auto at = [&](int r, int c) -> S& {
    return m(order[static_cast<std::size_t>(r)], order[static_cast<std::size_t>(c)]);
  };
  const auto x = [&](int k) -> S& { return v[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])]; };
  std::array<S, static_cast<std::size_t>(Size)> inverse;
  for (int k = Size; k-- > 0;) {
    if (is_zero(at(k, k))) return false;
    inverse[static_cast<std::size_t>(k)] = S(1.0) / at(k, k);
    for (int i = k; i-- > 0;) {
      if (is_zero(at(k, i))) continue;
      const S a = at(k, i) * inverse[static_cast<std::size_t>(k)];
      for (int j = 0; j <= i; ++j) at(i, j) = at(i, j) - a * at(k, j);
      x(i) = x(i) - a * x(k);
      at(k, i) = a;
    }
  }
  for (int k = 0; k < Size; ++k) {
    x(k) = x(k) * inverse[static_cast<std::size_t>(k)];
    for (int i = 0; i < k; ++i) x(k) = x(k) - at(k, i) * x(i);
  }
  return true;
}

}  // namespace cca::detail
