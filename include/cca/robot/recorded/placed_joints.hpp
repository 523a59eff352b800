// Vectors over any scalar, and the joints of a reduced body at some angles: what the recorded algorithms
// share.
//
// A scalar is `recorded`, or a number: double, a dual number.
#pragma once

#include <cca/base/recording/recorder.hpp>
#include <cca/robot/recorded/reduced_body.hpp>

namespace cca::detail {

template <class S>
struct triple {
  S e[3]{};

  constexpr S& operator[](std::size_t k) { return e[k]; }
  constexpr const S& operator[](std::size_t k) const { return e[k]; }

  friend constexpr triple operator+(const triple& a, const triple& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }
  friend constexpr triple operator-(const triple& a, const triple& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  friend constexpr triple operator*(const S& k, const triple& a) { return {k * a[0], k * a[1], k * a[2]}; }
  friend constexpr triple cross(const triple& a, const triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
};

// A joint at some angle: from the axes of its link to those of the link before (`up`) and back (`down`).
template <class S>
struct placed_joint {
  const reduced_link* link = nullptr;
  S cosine{}, sine{};
  triple<S> at{};  // the origin of the link, in the link before

  constexpr placed_joint() = default;
  constexpr placed_joint(const reduced_link& l, const S& first, const S& second) : link(&l) {
    if (l.revolute) cosine = first, sine = l.back ? -second : second;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = S(l.at[k]);
      if (!l.revolute) at[k] = at[k] + S(l.turn[k + 3 * l.axis]) * first;
    }
  }

  constexpr triple<S> up(const triple<S>& v) const { return fixed_up(turned(v, false)); }
  constexpr triple<S> down(const triple<S>& v) const { return turned(fixed_down(v), true); }

  // By the joint alone, and by the constant rotation before it.
  constexpr triple<S> turned(triple<S> v, bool back) const {
    if (link->revolute) {
      const std::size_t i = (link->axis + 1) % 3, j = (link->axis + 2) % 3;
      const S a = v[i], b = v[j], s = back ? -sine : sine;
      v[i] = cosine * a - s * b, v[j] = s * a + cosine * b;
    }
    return v;
  }
  constexpr triple<S> fixed_up(const triple<S>& v) const {
    if (link->straight) return v;
    triple<S> u;
    for (std::size_t r = 0; r < 3; ++r)
      u[r] = S(entry(r, 0)) * v[0] + S(entry(r, 1)) * v[1] + S(entry(r, 2)) * v[2];
    return u;
  }
  constexpr triple<S> fixed_down(const triple<S>& v) const {
    if (link->straight) return v;
    triple<S> u;
    for (std::size_t r = 0; r < 3; ++r)
      u[r] = S(entry(0, r)) * v[0] + S(entry(1, r)) * v[1] + S(entry(2, r)) * v[2];
    return u;
  }

private:
  constexpr double entry(std::size_t r, std::size_t c) const { return link->turn[r + 3 * c]; }
};

// The cosines of all joint values, then the sines; of a prismatic joint the cosine is its way.
template <class S, std::size_t Count, class Values>
constexpr std::array<placed_joint<S>, Count> placed_joints(const reduced_body<Count>& b,
                                                           const Values& values) {
  std::array<placed_joint<S>, Count> joints;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto k = static_cast<std::size_t>(b.links[i].value);
    joints[i] = {b.links[i], values[k], values[k + static_cast<std::size_t>(b.value_count)]};
  }
  return joints;
}

}  // namespace cca::detail
