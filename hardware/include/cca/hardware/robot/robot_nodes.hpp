// The resource nodes of a described robot on real drives, with the ports of those in the simulator, and the
// servos of its joints.
//
//   driven_joint<R, Axis>
//     sense  in "measured"; out "angle" (rad), "velocity" (rad/s), "torque" (N m, as the drive reports it),
//            each a maybe: until the drive reports it, nothing is published
//     act    as in cca/robots/commanded_joint.hpp
//   robot_servos<R, Joints>
//     act    in what each joint wants, under its axis' name; "joints"; out "wanted"
//            wanted_points: the law of the joint's servo (cca/robots/joint_servo.hpp) with the gains of its
//            joint type. A joint without a command is damped, or held where it was when motion began, if
//            its drive `holds` (cca/robots/description.hpp)
//
// A command that is not finite makes a set point that is not finite: the guards stop for it. Cost: some
// operations a joint.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/drives/set_points.hpp>
#include <cca/robots/commanded_joint.hpp>
#include <cca/robots/joint_servo.hpp>

namespace cca::hardware {

namespace detail {

// A field of a record as a port: empty until its first number is one.
template <fixed_string Field, class Space, class Record, class Vector>
[[gnu::always_inline]] inline maybe<Field, Space> published(const Vector& numbers) {
  const auto part = Record::template part<Field>(numbers);
  if (part[0] - part[0] == 0) return part;
  return {};
}

}  // namespace detail

template <class R, class Axis>
struct driven_joint : robots::commanded_joint<R, Axis> {
  using record = robots::joint_readings<R, Axis>;
  using angle = sub_space<robots::angles<R>, Axis>;
  using velocity = sub_space<robots::velocities<R>, Axis>;
  using torque = sub_space<robots::torques<R>, Axis>;

  auto sense(in<"measured", robots::measured_joint<R, Axis>> now)
      -> std::tuple<maybe<"angle", angle>, maybe<"velocity", velocity>, maybe<"torque", torque>> {
    const auto& v = now.vector();
    return {detail::published<"angle", angle, record>(v), detail::published<"velocity", velocity, record>(v),
            detail::published<"torque", torque, record>(v)};
  }
};

template <class R, class Joints>
class robot_servos;

template <class R, class... J>
class robot_servos<R, joint_list<J...>> {
public:
  using joints = joint_list<J...>;

  auto act(in<J::axis::label, robots::wanted_joint<R, typename J::axis>>... wanted,
           in<"joints", joint_states<joints>> states,
           beat now) -> out<"wanted", wanted_points<joints>> {
    const std::array<robots::joint_commands, joints::count> commands{robots::commands_of(wanted.vector())...};
    typename wanted_points<joints>::vector_type v;
    for (std::size_t i = 0; i < joints::count; ++i)
      point_of(i, commands[i], joint_state::of(states.vector(), i), now.dt()).put(v, i);
    return v;
  }
  void on_start() { servos = {}; }

private:
  wanted_point point_of(std::size_t i,
                        const robots::joint_commands& given,
                        const joint_state& q,
                        double beat) {
    wanted_point s;
    s.position = joints::angle[i].nearest(q.known() ? q.angle : 0);
    for (const double number : given.values)
      if (std::isinf(number)) return s.torque = number, s;
    if (q.phase <= motion_phase::begins) servos[i] = {};  // a target begins where the joint is then
    const joint_servo& servo = joints::servo[i];
    const robots::joint_law law = servos[i].follow(given,
                                                   {servo.stiffness, servo.damping, joints::torque[i].upper,
                                                    joints::speed[i].upper, joints::continuous[i], holds[i]},
                                                   q.known() ? q.angle : s.position, beat);
    if (!servos[i].has_command()) return s.damping = servo.safe_damping, s;
    if (law.stiffness > 0) s.position = law.position;
    s.velocity = law.velocity, s.torque = law.torque, s.stiffness = law.stiffness, s.damping = law.damping;
    return s;
  }

  static constexpr std::array<bool, joints::count> holds{
      R::drives[static_cast<std::size_t>(robots::axes_of_robot<R>::template index_of<typename J::axis>)]
          .holds...};

  std::array<robots::joint_servo, joints::count> servos{};
};

}  // namespace cca::hardware
