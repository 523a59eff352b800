// What domain types with one real number per axis share: limits, interpolation on a straight line, sums.
//
// Each part is a mixin: `sample` inherits it through the `methods` of its domain type. No method changes a
// sample; each returns a new one of the same space, with the older origin of the two.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <cca/base/eigen.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/frame.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/origin.hpp>
#include <cca/space/quantity.hpp>

namespace cca {

// A sample, an input or an output.
template <class Type> concept Sample = requires(const Type& s) {
  typename Type::space;
  s.vector();
  { s.origin() } -> std::same_as<std::int64_t>;
};

namespace detail {

template <class SpaceA, class SpaceB>
constexpr bool same_coordinates = std::is_same_v<typename SpaceA::domain, typename SpaceB::domain> &&
                                  std::is_same_v<typename SpaceA::axes, typename SpaceB::axes>;

// Two samples, or what they are samples of, that an operation can't combine.
template <class SpaceA, class SpaceB>
struct other_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: samples of " << space_in_words<SpaceA>() << " and of " << space_in_words<SpaceB>()
      << " are of different frames (expressed in, or acting at), so their numbers cannot be combined; bring "
         "one into the frame of the other first, with `express(...)` or `moved_to<...>(...)`";
  }
};
template <class SpaceA, class SpaceB>
struct other_coordinates {
  static constexpr void tell(text& m) {
    m << "space.mismatch: samples of " << space_in_words<SpaceA>() << " and of " << space_in_words<SpaceB>()
      << " cannot be combined: " << difference_in_words<SpaceA, SpaceB>()
      << "; take the part that they share with `on<...>()`, or use `vector()` if you mean the bare numbers";
  }
};

// True if an operation may combine the two samples: they need the same domain type, frame and axes.
template <class A, class B>
constexpr bool combinable() {
  using domain_a = typename A::space::domain;
  using domain_b = typename B::space::domain;
  constexpr bool one_frame = SameFrames<domain_a, domain_b>;
  static_assert(holds_or_tells<one_frame, other_frame<typename A::space, typename B::space>>::value);
  static_assert(holds_or_tells<(!one_frame || same_coordinates<typename A::space, typename B::space>),
                               other_coordinates<typename A::space, typename B::space>>::value);
  return same_coordinates<typename A::space, typename B::space>;
}

template <class Self>
struct mixin {
protected:
  constexpr const Self& self() const { return static_cast<const Self&>(*this); }
};

// For domain types with one number per axis. The limits are those that the axes state for the domain type's
// quantity. A twist has no number per axis, so it can't use these.
template <class Self>
struct per_axis : mixin<Self> {
  // False if a number is NaN.
  constexpr bool within_limits() const {
    using space = typename Self::space;
    using quantity = typename space::domain::quantity;
    static_assert(holds_or_tells<(space::size == space::axes::count), no_number_per_axis<space>>::value);
    bool within = true;
    for (int i = 0; i < space::size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double v = this->self().vector().coeff(i);
      within = within && v >= lower_limits<space, quantity>[at] && v <= upper_limits<space, quantity>[at];
    }
    return within;
  }

  // Moves each number to the nearest one within its limits. NaN stays NaN.
  constexpr Self clamped() const {
    using space = typename Self::space;
    using quantity = typename space::domain::quantity;
    static_assert(holds_or_tells<(space::size == space::axes::count), no_number_per_axis<space>>::value);
    typename space::vector_type v;
    for (int i = 0; i < space::size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double from = this->self().vector().coeff(i);
      const double low = lower_limits<space, quantity>[at], high = upper_limits<space, quantity>[at];
      v.coeffRef(i) = from < low ? low : from > high ? high : from;
    }
    return Self(v, this->self().origin());
  }
};

// Interpolation on the straight line: exactly this sample at t = 0, exactly `to` at t = 1. Beyond, it
// extrapolates.
template <class Self>
struct on_a_line : per_axis<Self> {
  template <Sample To>
  constexpr Self interpolated(const To& to, double t) const {
    const Self& from = this->self();
    if constexpr (combinable<Self, To>())
      return Self(((1 - t) * from.vector() + t * to.vector()).eval(), older(from.origin(), to.origin()));
    else return from;
  }
};

// What can be moved by a vector, in the unit of its numbers.
template <class Self>
struct moved_by_vectors : on_a_line<Self> {
  template <class Vector>
  constexpr Self plus(const Eigen::MatrixBase<Vector>& by) const {
    using space = typename Self::space;
    if constexpr (takes_vector<"plus", space, space::size, Vector>())
      return Self((this->self().vector() + by).eval(), this->self().origin());
    else return this->self();
  }
};

// Sums and multiples.
template <class Self>
struct additive : on_a_line<Self> {
  template <Sample Other>
  constexpr Self operator+(const Other& b) const {
    const Self& a = this->self();
    if constexpr (combinable<Self, Other>())
      return Self((a.vector() + b.vector()).eval(), older(a.origin(), b.origin()));
    else return a;
  }
  template <Sample Other>
  constexpr Self operator-(const Other& b) const {
    const Self& a = this->self();
    if constexpr (combinable<Self, Other>())
      return Self((a.vector() - b.vector()).eval(), older(a.origin(), b.origin()));
    else return a;
  }
  constexpr Self operator-() const { return Self((-this->self().vector()).eval(), this->self().origin()); }
  constexpr Self operator*(double factor) const {
    return Self((factor * this->self().vector()).eval(), this->self().origin());
  }
  friend constexpr Self operator*(double factor, const Self& a) { return a * factor; }
};

struct linear_domain {
  using quantity = value;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
};

}  // namespace detail
}  // namespace cca
