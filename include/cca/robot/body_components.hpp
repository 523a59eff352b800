// The dynamics and kinematics of a body as components.
//
//   cca::gravity_compensation<Body, Angles, Torques, Attitude>
//     in  "angles"          Angles         rad (prismatic joints: m)
//     in  "attitude"        Attitude       optional: orientation of the base in a world with z up
//     out "torques"         Torques        N m (prismatic: N) that hold the body against gravity
//
//   cca::inverse_dynamics_of<Body, Angles, Velocities, Accelerations, Torques, Attitude>
//     in  "angles"          Angles         rad
//     in  "velocities"      Velocities     rad/s
//     in  "accelerations"   Accelerations  rad/s^2
//     in  "attitude"        Attitude       optional
//     out "torques"         Torques        N m that this motion needs
//
//   cca::part_kinematics<Body, "left_front_leg", Angles, Tip>
//     in  "angles"          Angles         rad
//     out "position"        Tip            end of the part, in the frame of the base, m; its name is
//                                          "orientation" or "pose" if Tip is such a space
//
// They share the pose of the body with all that derive it from the same angles (derived_of_body.hpp).
// The spaces have the axes of the body in any order; all but Torques may have others too. Without "attitude"
// the base is upright. Parameter: `gravity`, m/s^2.
// They have no state: NaN or infinity in an input makes the outputs of that firing NaN. A limiter of torques
// publishes the allowed number nearest to 0 then.
// Errors: space.mismatch, frame.mismatch. Cost: body_dynamics.hpp. Example: tests/runtime/body/example.cpp.
#pragma once

#include <cca/component/port.hpp>
#include <cca/base/reflect.hpp>
#include <cca/mapping/forward_kinematics.hpp>
#include <cca/robot/body.hpp>
#include <cca/robot/body_dynamics.hpp>
#include <cca/robot/derived_of_body.hpp>

namespace cca {

struct gravity_parameters {
  BOOST_HANA_DEFINE_STRUCT(gravity_parameters, (double, gravity));
  constexpr gravity_parameters(double m_s2 = 9.81) : gravity(m_s2) {}
};

struct upright : frame<"world"> {};
struct base_attitude : space<orientation<upright>, axes<x, y, z>> {};

namespace detail {

// A body as a chain: its axes and its base.
template <Body Type>
struct body_as_chain {
  using axes = axes_of<Type>;
  using base = typename Type::base_frame;
};

template <class Space, class Domain>
struct other_joint_space {
  static constexpr void tell(text& m) {
    m << "space.mismatch: " << space_in_words<Space>() << " stands where a space of " << type_name<Domain>()
      << " does: the spaces of the dynamics of a body are of joint angles, velocities, accelerations and "
         "torques, in this order";
  }
};
template <class Body, class Space>
struct space_lacks_axis {
  static constexpr void tell(text& m) {
    m << "space.mismatch: " << space_in_words<Space>() << " lacks the axis "
      << missing_axis_in_words<typename Space::axes>(axes_of<Body>()) << " of the body " << type_name<Body>()
      << "; it must have all axes of the body";
  }
};
template <class Body, class Space>
struct torques_of_other_axes {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the torques of the body " << type_name<Body>() << " are " << space_in_words<Space>()
      << ", but have exactly its axes, " << axes_in_words<axes_of<Body>>() << ", all of them and no others";
  }
};

template <class Body, class Domain, class Space>
constexpr auto check_axes() {
  static_assert(holds_or_tells<std::is_same_v<typename Space::domain, Domain>,
                               other_joint_space<Space, Domain>>::value);
  static_assert(
      holds_or_tells<MovedWithin<body_as_chain<Body>, Space>, space_lacks_axis<Body, Space>>::value);
}
template <class Body, class Space>
constexpr auto check_torques() {
  static_assert(
      holds_or_tells<MovedBy<body_as_chain<Body>, Space>, torques_of_other_axes<Body, Space>>::value);
}

template <class Attitude>
vector3 gravity_in_base(const Attitude& attitude, double gravity) {
  const vector3 down{0, 0, -gravity};
  return attitude ? rotation::rotate(rotation::inverse(vector4(attitude.vector())), down) : down;
}

}  // namespace detail

template <class Type, class Angles, class Torques, class Attitude = base_attitude>
struct gravity_compensation {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using parameters = gravity_parameters;
  parameters p{};

  auto process(in<"angles", Angles> angles,
               optional_in<"attitude", Attitude> attitude,
               derived<pose_of<Type>, "angles"> pose = {}) -> out<"torques", Torques> {
    return detail::reordered<axes_of<Type>, Torques>::to(
        gravity_torques(pose.of(angles), detail::gravity_in_base(attitude, p.gravity)));
  }
};
template <class Type, class Angles, class Torques, class Attitude>
  requires(!Body<Type>)
struct gravity_compensation<Type, Angles, Torques, Attitude>
    : gravity_compensation<typename detail::body_or_refused<Type>::type, Angles, Torques, Attitude> {};

template <class Type,
          class Angles,
          class Velocities,
          class Accelerations,
          class Torques,
          class Attitude = base_attitude>
struct inverse_dynamics_of {
  using checked = std::void_t<decltype(detail::check_axes<Type, joint_angles, Angles>()),
                              decltype(detail::check_axes<Type, joint_velocities, Velocities>()),
                              decltype(detail::check_axes<Type, joint_accelerations, Accelerations>()),
                              decltype(detail::check_axes<Type, joint_torques, Torques>()),
                              decltype(detail::check_torques<Type, Torques>())>;
  using parameters = gravity_parameters;
  parameters p{};

  auto process(in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities,
               in<"accelerations", Accelerations> accelerations,
               optional_in<"attitude", Attitude> attitude,
               derived<pose_of<Type>, "angles"> pose = {}) -> out<"torques", Torques> {
    base_motion base;
    base.gravity = detail::gravity_in_base(attitude, p.gravity);
    return detail::reordered<axes_of<Type>, Torques>::to(
        inverse_dynamics(pose.of(angles),
                         detail::reordered<axes_of<Type>, Velocities>::from(velocities.vector()),
                         detail::reordered<axes_of<Type>, Accelerations>::from(accelerations.vector()), base)
            .torques);
  }
};
template <class Type, class Angles, class Velocities, class Accelerations, class Torques, class Attitude>
  requires(!Body<Type>)
struct inverse_dynamics_of<Type, Angles, Velocities, Accelerations, Torques, Attitude>
    : inverse_dynamics_of<typename detail::body_or_refused<Type>::type,
                          Angles,
                          Velocities,
                          Accelerations,
                          Torques,
                          Attitude> {};

template <class Type, fixed_string Part, class Angles, class Tip>
struct part_kinematics {
  using checked = std::void_t<decltype(detail::check_tip<detail::body_as_chain<Type>, Tip>()),
                              decltype(detail::check_axes<Type, joint_angles, Angles>())>;

  auto process(in<"angles", Angles> angles, derived<end_of<Type, Part>, "angles"> end = {})
      -> out<detail::tip_port<Tip>(), Tip> {
    return detail::tip_in<Tip>(end.of(angles));
  }
};
template <class Type, fixed_string Part, class Angles, class Tip>
  requires(!Body<Type>)
struct part_kinematics<Type, Part, Angles, Tip>
    : part_kinematics<typename detail::body_or_refused<Type>::type, Part, Angles, Tip> {};

}  // namespace cca
