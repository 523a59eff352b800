// The synchronizer of the simulated Oncilla: the one node that knows the simulator. Its `sense` hands the
// readings to the resource nodes; its `act` takes their targets, pushes the trunk as the disturbance says and
// advances the world by a beat.
//
//   sense   out one port for each joint, under its axis' name: measured_joint
//           out "trunk"                 measured_trunk, see trunk_record (cca/robots/oncilla/spaces.hpp)
//   act     in  one port for each joint: the target, rad
//           in  "abduction", optional   targets, rad; not wired: as the robot was put down
//           in  "stiffness", optional   of the hips, N m/rad; not wired: the model's
//
// `put_down` sets the world; without it the robot stands on level ground. A copy of the node is a snapshot of
// the world. Cost: a beat of physics, about 0.1 ms; the rest is copying numbers.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include <cca/component/port.hpp>
#include <cca/robots/oncilla/spaces.hpp>

#include <cca/sim/disturbance.hpp>
#include <cca/sim/world.hpp>

namespace cca::sim {

// Feet a little ahead of the hips, where the springs carry the robot.
inline initial_posture standing_posture(const oncilla_model& model = oncilla_defaults) {
  const leg_angles_in_plane q = sim::leg_angles_for(model, {0.04, -0.165});
  initial_posture posture;
  for (leg_posture& leg : posture.legs) leg = {q.hip, q.knee, 0};
  return posture;
}

namespace detail {

// The trunk's record, as the simulated sensors read.
inline measured_trunk::vector_type trunk_record_of(const robot_reading& now) {
  measured_trunk::vector_type v;
  const trunk_reading& trunk = now.trunk;
  const quaternion& q = trunk.orientation;
  trunk_record::part<"orientation">(v) << q.x, q.y, q.z, q.w;
  trunk_record::part<"angular_velocity">(v) << trunk.angular_velocity[0], trunk.angular_velocity[1],
      trunk.angular_velocity[2];
  trunk_record::part<"acceleration">(v) << trunk.specific_force[0], trunk.specific_force[1],
      trunk.specific_force[2];
  for (std::size_t leg = 0; leg < leg_count; ++leg) {
    const leg_reading& r = now.legs[leg];
    const auto i = static_cast<Eigen::Index>(leg);
    trunk_record::part<"foot_loads">(v)[i] = r.foot_force[2];
    trunk_record::part<"contacts">(v)[i] = r.contact() ? 1 : 0;
    trunk_record::part<"abducted">(v)[i] = r.abduction.angle;
  }
  return v;
}

template <class Axes>
class simulator_of;

template <class... Axes>
class simulator_of<axes<Axes...>> {
public:
  void put_down(sim::world&& world, const sim::disturbance& disturbance = sim::disturbance::none()) {
    world_ = std::move(world);
    disturbance_ = disturbance;
  }

  // While it runs, too.
  void disturb(const sim::disturbance& disturbance) { disturbance_ = disturbance; }

  const sim::world& world() const { return world_; }

  auto sense() -> std::tuple<out<Axes::label, measured_joint<Axes>>..., out<"trunk", measured_trunk>> {
    return {joint<Axes>()..., trunk_record_of(world_.reading())};
  }

  void act(in<Axes::label, joint_angle<Axes>>... targets,
           optional_in<"abduction", abduction_angles> abduction,
           optional_in<"stiffness", hip_stiffnesses> stiffness) {
    robot_command command = world_.targets();
    const std::array<double, sizeof...(Axes)> angles{targets.vector()[0]...};
    for (std::size_t leg = 0; leg < leg_count; ++leg) {
      command[leg].hip = angles[robots::oncilla::hip_of(leg)];
      command[leg].knee = angles[robots::oncilla::knee_of(leg)];
      if (abduction) command[leg].abduction = abduction.vector()[static_cast<Eigen::Index>(leg)];
      if (stiffness) command[leg].hip_stiffness = stiffness.vector()[static_cast<Eigen::Index>(leg)];
    }
    world_.push(disturbance_.push_at(world_.time()));
    world_.advance(command);
  }

private:
  template <class Axis>
  Eigen::Vector3d joint() const {
    constexpr std::size_t at = leg_axes::index_of<Axis>, leg = at % leg_count;
    constexpr bool is_hip = at == robots::oncilla::hip_of(leg);
    const leg_reading& readings = world_.reading().legs[leg];
    const joint_reading& r = is_hip ? readings.hip : readings.knee;
    return {r.angle, r.velocity, r.torque};
  }

  sim::world world_{oncilla_defaults, terrain::flat(), standing_posture()};
  sim::disturbance disturbance_{};
};

}  // namespace detail

class simulator : public detail::simulator_of<leg_axes> {};

}  // namespace cca::sim
