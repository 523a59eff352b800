#pragma once
// The synchronizer of the simulated Oncilla: the one node that knows the simulator. Its `sense` hands each
// resource node what was measured, its `act` takes what they want, pushes the trunk as the disturbance says
// and advances the world by a beat.
//
//   sense   out "left_front_hip" ... "right_hind_knee"   angle, velocity, torque of a joint
//           out "trunk"                                  see `trunk_record`
//   act     in  "left_front_hip" ... "right_hind_knee"   targets, rad
//           in  "abduction", optional                    targets, rad; unwired: as the robot was put down
//           in  "stiffness", optional                    of the hips, N m/rad; unwired: the model's
//
// `put_down` sets the world; without it the robot stands on level ground. A copy of the node is a snapshot of
// the world. Cost: a beat of physics, about 0.1 ms; the rest is copying numbers.
#include <cstddef>
#include <tuple>
#include <utility>

#include <cca/component/port.hpp>

#include <cca/sim/disturbance.hpp>
#include <cca/sim/oncilla_spaces.hpp>
#include <cca/sim/world.hpp>

namespace cca::sim {

// Where what stands in the trunk's record.
struct trunk_record {
  static constexpr int orientation = 0, angular_velocity = 4, specific_force = 7, foot_load = 10,
                       contact = 14, abduction = 18, size = 22;
};
static_assert(measured_trunk::size == trunk_record::size);

// Feet a little ahead of the hips, where the springs carry the robot.
inline initial_posture standing_posture(const oncilla_model& model = oncilla_defaults) {
  const leg_angles_in_plane q = sim::leg_angles_for(model, {0.04, -0.165});
  initial_posture posture;
  for (leg_posture& leg : posture.legs) leg = {q.hip, q.knee, 0};
  return posture;
}

class simulator {
public:
  void put_down(sim::world&& world, const sim::disturbance& disturbance = sim::disturbance::none()) {
    world_ = std::move(world);
    disturbance_ = disturbance;
  }

  // While it runs, too.
  void disturb(const sim::disturbance& disturbance) { disturbance_ = disturbance; }

  const sim::world& world() const { return world_; }

  auto sense() -> std::tuple<out<"left_front_hip", measured_joint<left_front_hip>>,
                             out<"right_front_hip", measured_joint<right_front_hip>>,
                             out<"left_hind_hip", measured_joint<left_hind_hip>>,
                             out<"right_hind_hip", measured_joint<right_hind_hip>>,
                             out<"left_front_knee", measured_joint<left_front_knee>>,
                             out<"right_front_knee", measured_joint<right_front_knee>>,
                             out<"left_hind_knee", measured_joint<left_hind_knee>>,
                             out<"right_hind_knee", measured_joint<right_hind_knee>>,
                             out<"trunk", measured_trunk>> {
    const auto& legs = world_.reading().legs;
    const auto joint = [](const joint_reading& r) { return Eigen::Vector3d(r.angle, r.velocity, r.torque); };
    return {joint(legs[0].hip),  joint(legs[1].hip),  joint(legs[2].hip),
            joint(legs[3].hip),  joint(legs[0].knee), joint(legs[1].knee),
            joint(legs[2].knee), joint(legs[3].knee), trunk()};
  }

  void act(in<"left_front_hip", joint_angle<left_front_hip>> hip_0,
           in<"right_front_hip", joint_angle<right_front_hip>> hip_1,
           in<"left_hind_hip", joint_angle<left_hind_hip>> hip_2,
           in<"right_hind_hip", joint_angle<right_hind_hip>> hip_3,
           in<"left_front_knee", joint_angle<left_front_knee>> knee_0,
           in<"right_front_knee", joint_angle<right_front_knee>> knee_1,
           in<"left_hind_knee", joint_angle<left_hind_knee>> knee_2,
           in<"right_hind_knee", joint_angle<right_hind_knee>> knee_3,
           optional_in<"abduction", abduction_angles> abduction,
           optional_in<"stiffness", hip_stiffnesses> stiffness) {
    robot_command command = world_.targets();
    const double hips[] = {hip_0.vector()[0], hip_1.vector()[0], hip_2.vector()[0], hip_3.vector()[0]};
    const double knees[] = {knee_0.vector()[0], knee_1.vector()[0], knee_2.vector()[0], knee_3.vector()[0]};
    for (std::size_t i = 0; i < leg_count; ++i) {
      command[i].hip = hips[i];
      command[i].knee = knees[i];
      if (abduction) command[i].abduction = abduction.vector()[static_cast<int>(i)];
      if (stiffness) command[i].hip_stiffness = stiffness.vector()[static_cast<int>(i)];
    }
    world_.push(disturbance_.push_at(world_.time()));
    world_.advance(command);
  }

private:
  measured_trunk::vector_type trunk() const {
    using at = trunk_record;
    measured_trunk::vector_type record;
    const robot_reading& now = world_.reading();
    const quaternion& q = now.trunk.orientation;
    record.segment<4>(at::orientation) << q.x, q.y, q.z, q.w;
    for (int k = 0; k < 3; ++k) {
      record[at::angular_velocity + k] = now.trunk.angular_velocity[static_cast<std::size_t>(k)];
      record[at::specific_force + k] = now.trunk.specific_force[static_cast<std::size_t>(k)];
    }
    for (int i = 0; i < static_cast<int>(leg_count); ++i) {
      const leg_reading& leg = now.legs[static_cast<std::size_t>(i)];
      record[at::foot_load + i] = leg.foot_force[2];
      record[at::contact + i] = leg.contact() ? 1 : 0;
      record[at::abduction + i] = leg.abduction.angle;
    }
    return record;
  }

  sim::world world_{oncilla_defaults, terrain::flat(), standing_posture()};
  sim::disturbance disturbance_{};
};

}  // namespace cca::sim
