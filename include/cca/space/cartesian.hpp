// Positions and forces along the axes of a frame.
//
//   struct foot_in_hip : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};
//   struct push : cca::space<cca::cartesian_force<hip_frame>, cca::axes<cca::z>> {};
//
//   cartesian_position<Frame>   a point by its coordinates, in m; the zero is the frame's origin
//   cartesian_force<Frame>      in N, along the axes of the frame; it says nothing about where it acts
//
// Points can't be added: the difference of two points is a vector, and a point plus a vector is a point.
// Forces can. A force with its moment about a point is a `wrench`. Errors: `frame.mismatch`.
#pragma once

#include <cmath>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/methods/linear.hpp>

namespace cca {

template <class Frame>
struct cartesian_position : detail::linear_domain {
  using quantity = length;
  using frame = Frame;
  using frames = detail::frame_list<Frame>;

  template <class Self>
  struct methods : detail::moved_by_vectors<Self> {
    // The vector from the other point to this one, in m along the frame's axes.
    template <Sample Other>
    constexpr auto difference(const Other& from) const {
      auto v = this->self().vector();
      if constexpr (detail::combinable<Self, Other>()) v -= from.vector();
      return v;
    }

    // In m.
    template <Sample Other>
    double distance(const Other& to) const {
      const auto v = difference(to);
      return math::sqrt(math::dot(v, v));
    }
  };
};

template <class Frame>
struct cartesian_force : detail::linear_domain {
  using quantity = force;
  using frame = Frame;
  using frames = detail::frame_list<Frame>;

  template <class Self>
  struct methods : detail::additive<Self> {
    // In N.
    double magnitude() const {
      const auto v = this->self().vector();
      return math::sqrt(math::dot(v, v));
    }
  };
};

namespace detail {

template <class Domain>
constexpr bool is_position = false;
template <class Frame>
constexpr bool is_position<cartesian_position<Frame>> = true;

template <class Type> concept PositionSample = Sample<Type> && is_position<typename Type::space::domain>;

template <class Space>
struct not_spatial {
  static constexpr void tell(text& m) {
    m << "space.mismatch: a rotation moves samples over three axes, axes<x, y, z>, that are positions, "
         "forces, twists or wrenches, and this one is of "
      << space_in_words<Space>();
  }
};

// A rigid motion moves only positions over three axes, which are x, y and z in this order.
template <class Position>
constexpr bool spatial() {
  static_assert(holds_or_tells<(Position::space::size == 3), not_spatial<typename Position::space>>::value);
  return Position::space::size == 3;
}

}  // namespace detail
}  // namespace cca
