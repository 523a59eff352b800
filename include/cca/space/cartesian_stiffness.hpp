// Stiffness and damping of a body at a point: how it answers a displacement and a motion, as six numbers.
//
//   cartesian_stiffness<At, In>   about x, y, z in N m/rad, then along x, y, z in N/m
//   cartesian_damping<At, In>     about x, y, z in N m s/rad, then along x, y, z in N s/m
//
// `At` is the frame at whose origin it acts; `In` is the frame whose axes are the principal axes: the numbers
// are the diagonal of a 6 x 6 matrix along them, in the order of a twist and a wrench. Along other axes the
// matrix is full, so there is no `express`. The zero is no stiffness, or no damping.
// Errors: `frame.mismatch`. Source: Hogan, Impedance Control: An Approach to Manipulation, J. Dynamic
// Systems, Measurement, and Control 107, 1985.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/twist_wrench.hpp>

namespace cca {

namespace detail {

template <class At, class In>
struct cartesian_diagonal : spatial_domain<At, In> {
  static constexpr std::array<std::string_view, 6> coordinates{"rotational_x", "rotational_y", "rotational_z",
                                                               "linear_x",     "linear_y",     "linear_z"};
  template <class Self>
  struct methods : additive<Self> {
    using vector_3 = typename spatial_types<Self>::vector;

    vector_3 rotational() const { return this->self().vector().template head<3>(); }
    vector_3 linear() const { return this->self().vector().template tail<3>(); }
  };
};

}  // namespace detail

template <class At, class In>
struct cartesian_stiffness : detail::cartesian_diagonal<At, In> {
  static constexpr std::array<std::string_view, 6> coordinate_units{"N m/rad", "N m/rad", "N m/rad",
                                                                    "N/m",     "N/m",     "N/m"};
  template <class Self>
  struct methods : detail::cartesian_diagonal<At, In>::template methods<Self> {
    // Of springs that are displaced from their rest by a rotation vector in rad and a vector in m, along the
    // axes of In: it points back.
    template <class Vector>
    auto wrench(const Eigen::MatrixBase<Vector>& displacement) const {
      using result = sample<with_domain<typename Self::space, cca::wrench<At, In>>>;
      if constexpr (detail::takes_vector<"wrench", typename Self::space, 6, Vector>())
        return result(-this->self().vector().cwiseProduct(displacement), this->self().origin());
      else return result();
    }
  };
};

namespace detail {
template <class Damping, class Twist>
struct damping_of_other_motion {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: a " << type_name<Damping>() << " meets a " << type_name<Twist>()
      << ", which acts at another point or is expressed in another frame; bring the twist there first, with "
         "`moved_to<point>(lever)` and `orientation.express(...)`";
  }
};
}  // namespace detail

template <class At, class In>
struct cartesian_damping : detail::cartesian_diagonal<At, In> {
  static constexpr std::array<std::string_view, 6> coordinate_units{"N m s/rad", "N m s/rad", "N m s/rad",
                                                                    "N s/m",     "N s/m",     "N s/m"};
  template <class Self>
  struct methods : detail::cartesian_diagonal<At, In>::template methods<Self> {
    // Against a motion of the same point, along the same axes.
    template <detail::TwistSample Twist>
    auto wrench(const Twist& motion) const {
      using of = typename Twist::space::domain;
      static_assert(detail::holds_or_tells<(SameFrame<At, typename of::at> && SameFrame<In, typename of::in>),
                                           detail::damping_of_other_motion<cartesian_damping, of>>::value);
      using result = sample<with_domain<typename Self::space, cca::wrench<At, In>>>;
      return result(-this->self().vector().cwiseProduct(motion.vector()),
                    detail::older(this->self().origin(), motion.origin()));
    }
  };
};

}  // namespace cca
