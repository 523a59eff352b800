// Forward kinematics as a component: the position of the tip of a chain.
//
//   cca::node<"paw", cca::forward_kinematics<leg, leg_angles, paw_in_trunk>>
//
//   in  "angles"       Joints  rad (prismatic joints: m); the axes of the chain in any order, maybe others
//   out "position"     Tip     in the frame of the chain's base, m, over any of the axes x, y, z
//    or "orientation"          if Tip is a space of orientations
//    or "pose"                 if Tip is a space of poses
//
// It has no state: an angle or coordinate that is NaN or infinite makes the output of that firing NaN, which
// components with a state and limiters recognise (input_status.hpp).
//
// Errors: frame.mismatch, space.mismatch. Cost: kinematics.hpp. Example:
// tests/runtime/mapping/kinematics.cpp.
#pragma once

#include <cca/component/port.hpp>
#include <cca/mapping/kinematics.hpp>
#include <cca/mapping/rigid_motion.hpp>

namespace cca {
namespace detail {

template <class Space>
constexpr auto tip_port() {
  if constexpr (same_kind<typename Space::domain, pose<void>>) return fixed_string("pose");
  else if constexpr (same_kind<typename Space::domain, orientation<void>>) return fixed_string("orientation");
  else return fixed_string("position");
}

template <class Space>
constexpr bool is_tip_space =
    same_kind<typename Space::domain, cartesian_position<void>> ||
    same_kind<typename Space::domain, orientation<void>> || same_kind<typename Space::domain, pose<void>>;

template <class Space>
constexpr bool has_cartesian_axes() {
  return !same_kind<typename Space::domain, cartesian_position<void>> ||
         cartesian_part<typename Space::axes>::named;
}

template <class Space>
typename Space::vector_type tip_in(const rigid& tip) {
  if constexpr (same_kind<typename Space::domain, pose<void>>) {
    typename Space::vector_type v;
    v.template head<3>() = tip.at;
    v.template tail<4>() = quaternion_of(tip.turn);
    return v;
  } else if constexpr (same_kind<typename Space::domain, orientation<void>>) {
    return quaternion_of(tip.turn);
  } else {
    typename Space::vector_type v;
    using part = cartesian_part<typename Space::axes>;
    for (int i = 0; i < Space::size; ++i) v[i] = tip.at[part::of[static_cast<std::size_t>(i)]];
    return v;
  }
}

template <class Space>
struct tip_frame_of {
  using type = void;
};
template <CartesianSpace Space>
struct tip_frame_of<Space> {
  using type = typename frame_along<typename Space::domain>::type;
};

template <class Tip>
struct no_tip_space {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the tip of a chain is given in " << space_in_words<Tip>()
      << ", but it has a space of positions over axes x, y and z, of orientations or of poses";
  }
};
template <class Base, class Tip>
struct tip_in_other_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: kinematics say where the tip of a chain is in the frame of its base, "
      << type_name<Base>() << ", but " << space_in_words<Tip>()
      << " has another frame; put a `cca::frame_change` in between";
  }
};
template <class Chain, class Joints>
struct joints_lack_axis {
  static constexpr void tell(text& m) {
    m << "space.mismatch: " << space_in_words<Joints>() << " lacks the axis "
      << missing_axis_in_words<typename Joints::axes>(typename Chain::axes()) << " of the chain "
      << type_name<Chain>() << "; it must have all axes of the chain";
  }
};

// In functions; mapping.hpp says why.
template <class Chain, class Tip>
constexpr auto check_tip() {
  static_assert(holds_or_tells<(is_tip_space<Tip> && has_cartesian_axes<Tip>()), no_tip_space<Tip>>::value);
  static_assert(holds_or_tells<(!is_tip_space<Tip> ||
                                SameFrame<typename Chain::base, typename tip_frame_of<Tip>::type>),
                               tip_in_other_frame<typename Chain::base, Tip>>::value);
}
template <class Chain, class Joints>
constexpr auto check_joints_within() {
  static_assert(holds_or_tells<MovedWithin<Chain, Joints>, joints_lack_axis<Chain, Joints>>::value);
}

}  // namespace detail

template <class Chain, class Joints, class Tip>
struct forward_kinematics {
  using checked = decltype(detail::check_tip<Chain, Tip>());
  using checked_too = decltype(detail::check_joints_within<Chain, Joints>());

  auto process(in<"angles", Joints> angles) -> out<detail::tip_port<Tip>(), Tip> {
    return detail::tip_in<Tip>(
        chain_pose<Chain>(detail::reordered<typename Chain::axes, Joints>::from(angles.vector())).tip());
  }
};
template <class Type, class Joints, class Tip>
  requires(!SerialChain<Type>)
struct forward_kinematics<Type, Joints, Tip> : forward_kinematics<detail::mended_chain<Type>, Joints, Tip> {
  static_assert(detail::holds_or_tells<false, detail::no_chain<Type>>::value);
};

}  // namespace cca
