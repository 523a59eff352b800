// Twists and wrenches: the velocity of a body and the load on it, in six numbers. Source of all equations:
// Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 2 (spatial vectors in Pluecker coordinates,
// angular part first).
//
//   twist<At, In>    angular velocity x, y, z in rad/s, then the velocity of the point at At's origin, m/s
//   wrench<At, In>   torque about At's origin x, y, z in N m, then force, in N
//
// `At` is the frame at whose origin it acts; `In` is the frame along whose axes the numbers are.
// `orientation.express(t)` changes In; `moved_to<Point>(lever)` changes At. The zero is rest, or no load.
// Errors: `frame.mismatch`, where two differ in At or In.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/math/reductions.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/orientation.hpp>

namespace cca {

namespace detail {

template <class At, class In>
struct spatial_domain {
  using quantity = void;  // the angular and the linear numbers have different ones
  static constexpr std::array<std::string_view, 6> coordinates{"angular_x", "angular_y", "angular_z",
                                                               "linear_x",  "linear_y",  "linear_z"};
  using at = At;
  using in = In;
  using frames = frame_list<At, In>;
  static constexpr bool actuated = false;
  static constexpr int axis_count = 3;
  static constexpr int width(int) { return 6; }
  static constexpr double zero(int, int) { return 0; }
};

template <class In, class Lever>
struct lever_in_other_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: the lever arm is expressed in " << type_name<Lever>()
      << ", but the twist or wrench in " << type_name<In>()
      << "; bring one into the frame of the other first, with `express(...)` of an orientation";
  }
};
template <class At, class Other>
struct power_at_other_point {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: the power of a wrench at " << type_name<At>()
      << " with a twist that acts at another point, " << type_name<Other>()
      << "; move one to the point of the other first, with `moved_to<point>(lever)`";
  }
};
template <class In, class Other>
struct power_in_other_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: the power of a wrench in " << type_name<In>()
      << " with a twist that is expressed in another frame, " << type_name<Other>()
      << "; express one in the frame of the other first, with `orientation.express(...)`";
  }
};

// The vector from the old point to the new one, along the axes of In.
template <class In, class Space, class Lever>
typename spatial_types<Lever>::vector lever_along(const Lever& lever) {
  if constexpr (Sample<Lever>) {
    using other = typename Lever::space::domain::frame;
    static_assert(holds_or_tells<SameFrame<In, other>, lever_in_other_frame<In, other>>::value);
    return lever.vector();
  } else if constexpr (requires { Lever::SizeAtCompileTime; }) {
    if constexpr (takes_vector<"moved_to", Space, 3, Lever>()) return lever;
    else return {};
  } else {
    return lever;
  }
}

template <class Domain>
constexpr bool is_twist = false;
template <class At, class In>
constexpr bool is_twist<twist<At, In>> = true;

template <class Type> concept TwistSample = Sample<Type> && is_twist<typename Type::space::domain>;

}  // namespace detail

template <class At, class In>
struct twist : detail::spatial_domain<At, In> {
  static constexpr std::array<std::string_view, 6> coordinate_units{"rad/s", "rad/s", "rad/s",
                                                                    "m/s",   "m/s",   "m/s"};
  template <class Self>
  struct methods : detail::additive<Self> {
    using vector_3 = typename detail::spatial_types<Self>::vector;

    vector_3 angular() const { return this->self().vector().template head<3>(); }
    vector_3 linear() const { return this->self().vector().template tail<3>(); }

    // The same motion at another point: v_P = v_O + w x OP. `lever` is OP: a position in In, or a vector.
    template <class Point, class Lever>
    auto moved_to(const Lever& lever) const {
      using result = sample<with_domain<typename Self::space, twist<Point, In>>>;
      typename Self::space::vector_type v = this->self().vector();
      v.template tail<3>() +=
          rotation::cross(angular(), detail::lever_along<In, typename Self::space>(lever));
      return result(v, this->self().origin());
    }
  };
};

template <class At, class In>
struct wrench : detail::spatial_domain<At, In> {
  static constexpr std::array<std::string_view, 6> coordinate_units{"N m", "N m", "N m", "N", "N", "N"};
  template <class Self>
  struct methods : detail::additive<Self> {
    using vector_3 = typename detail::spatial_types<Self>::vector;

    vector_3 torque() const { return this->self().vector().template head<3>(); }
    vector_3 force() const { return this->self().vector().template tail<3>(); }

    // The same load about another point: n_P = n_O - OP x f. `lever` is OP: a position in In, or a vector.
    template <class Point, class Lever>
    auto moved_to(const Lever& lever) const {
      using result = sample<with_domain<typename Self::space, wrench<Point, In>>>;
      typename Self::space::vector_type v = this->self().vector();
      v.template head<3>() -= rotation::cross(detail::lever_along<In, typename Self::space>(lever), force());
      return result(v, this->self().origin());
    }

    // In W, of this load on a body with this motion.
    template <detail::TwistSample Twist>
    double power(const Twist& motion) const {
      using of = typename Twist::space::domain;
      using other_at = typename of::at;
      using other_in = typename of::in;
      static_assert(
          detail::holds_or_tells<SameFrame<At, other_at>, detail::power_at_other_point<At, other_at>>::value);
      static_assert(detail::holds_or_tells<(!SameFrame<At, other_at> || SameFrame<In, other_in>),
                                           detail::power_in_other_frame<In, other_in>>::value);
      return math::dot(this->self().vector(), motion.vector());
    }
  };
};

}  // namespace cca
