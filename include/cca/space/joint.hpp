// Domain types at joint level, one number per axis. All are actuated: the axes of a command must state
// limits.
//
//   domain type           unit      zero   methods
//   joint_angles          rad       0      normalised, difference, plus, interpolated, within_limits, clamped
//   joint_velocities      rad/s     0      sums, displacement(dt), interpolated, within_limits, clamped
//   joint_accelerations   rad/s^2   0      sums, interpolated, within_limits, clamped
//   joint_torques         N m       0      sums, power(velocities), interpolated, within_limits, clamped
//   joint_stiffness       N m/rad   0      sums, torque(deflection), interpolated, within_limits, clamped
//   joint_damping         N m s/rad 0      sums, torque(velocities), interpolated, within_limits, clamped
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/methods/circle.hpp>
#include <cca/space/methods/linear.hpp>

namespace cca {

namespace detail {

struct joint_domain : linear_domain {
  static constexpr bool actuated = true;
};

}  // namespace detail

// Interpolation follows the straight line between the two numbers, never the short way around: between two
// angles within the limits it stays within them. Along a continuous axis it takes the short way.
struct joint_angles : detail::joint_domain {
  using quantity = angle;

  template <class Self>
  struct methods : detail::moved_by_vectors<Self> {
    // Into (-pi, pi].
    constexpr Self normalised() const {
      auto v = this->self().vector();
      for (int i = 0; i < Self::space::size; ++i) v.coeffRef(i) = wrap_signed(v.coeff(i));
      return Self(v, this->self().origin());
    }

    // From the other sample to this one the short way, each in (-pi, pi].
    template <Sample Other>
    constexpr auto difference(const Other& from) const {
      auto v = this->self().vector();
      if constexpr (detail::combinable<Self, Other>())
        for (int i = 0; i < Self::space::size; ++i)
          v.coeffRef(i) = wrap_signed(v.coeff(i) - from.vector().coeff(i));
      return v;
    }

    template <Sample To>
    constexpr Self interpolated(const To& to, double t) const {
      if constexpr (detail::has_continuous_angles<typename Self::space> && detail::combinable<Self, To>()) {
        const auto& from = this->self().vector();
        auto v = ((1 - t) * from + t * to.vector()).eval();
        for (int i = 0; i < Self::space::size; ++i)
          if (detail::continuous_along<typename Self::space>[static_cast<std::size_t>(i)])
            v[i] = (1 - t) * from[i] + t * detail::same_turn(to.vector()[i], from[i]);
        return Self(v, detail::older(this->self().origin(), to.origin()));
      } else {
        return detail::on_a_line<Self>::interpolated(to, t);
      }
    }
  };
};

struct joint_velocities : detail::joint_domain {
  using quantity = velocity;

  template <class Self>
  struct methods : detail::additive<Self> {
    // In rad, over dt in s; the argument of `angles.plus(...)`.
    constexpr auto displacement(double dt) const {
      using vector = typename Self::space::vector_type;
      return vector(dt * this->self().vector());
    }
  };
};

struct joint_accelerations : detail::joint_domain {
  using quantity = acceleration;

  template <class Self>
  struct methods : detail::additive<Self> {};
};

namespace detail {
template <class Velocities, class Self>
inline constexpr bool velocities_along =
    std::is_same_v<typename Velocities::space::domain, joint_velocities> &&
    std::is_same_v<typename Velocities::space::axes, typename Self::space::axes>;
template <class Space, class Self>
struct other_velocities {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the power or the torque of " << space_in_words<typename Self::space>()
      << " needs joint_velocities over the same axes, not " << space_in_words<Space>();
  }
};
}  // namespace detail

struct joint_torques : detail::joint_domain {
  using quantity = torque;

  template <class Self>
  struct methods : detail::additive<Self> {
    // In W; positive into the joints.
    template <Sample Velocities>
    constexpr double power(const Velocities& velocities) const {
      static_assert(
          detail::holds_or_tells<detail::velocities_along<Velocities, Self>,
                                 detail::other_velocities<typename Velocities::space, Self>>::value);
      return math::dot(this->self().vector(), velocities.vector());
    }
  };
};

struct joint_stiffness : detail::joint_domain {
  using quantity = stiffness;

  template <class Self>
  struct methods : detail::additive<Self> {
    // In N m, of springs that are turned out of their rest by `deflection` (rad). It points back, so its sign
    // is the opposite.
    template <class Vector>
    constexpr auto torque(const Eigen::MatrixBase<Vector>& deflection) const {
      using space = typename Self::space;
      using vector = typename space::vector_type;
      if constexpr (detail::takes_vector<"torque", space, space::size, Vector>())
        return vector(-this->self().vector().cwiseProduct(deflection));
      else return vector();
    }
  };
};

struct joint_damping : detail::joint_domain {
  using quantity = damping;

  template <class Self>
  struct methods : detail::additive<Self> {
    // In N m, against the motion.
    template <Sample Velocities>
    constexpr auto torque(const Velocities& velocities) const {
      static_assert(
          detail::holds_or_tells<detail::velocities_along<Velocities, Self>,
                                 detail::other_velocities<typename Velocities::space, Self>>::value);
      using vector = typename Self::space::vector_type;
      return vector(-this->self().vector().cwiseProduct(velocities.vector()));
    }
  };
};

}  // namespace cca
