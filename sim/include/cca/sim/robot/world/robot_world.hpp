// A described robot in the Open Dynamics Engine, with what stands around it: laws for its drives in, one beat
// of physics, readings out.
//
//   cca::sim::robot_world w(cca::sim::model_of<cca::robots::arm::description>(), room);
//   w.advance(laws);                      one law for each coordinate (joint_law.hpp)
//   w.joints()[3].angle                   rad; torques are means over the beat
//   w.joint("a4"), w.end("arm")           by name, or by number
//   w.load("flange_load")                 of a force sensor, in its frame
//   w.inertial("gyro").orientation        of the inertial unit of a sensor
//   w.contact_at_end("arm").slip          what its contacts have done (contact_account.hpp)
//
// A world is a value. A copy is a snapshot: original and copy, given the same commands, stay bit-identical.
// `save` and `restore` do the same with a plain value, for worlds of the same model and scene. `pull`,
// `push` and `move`: a force at the end of a part, one on the base, a box that moves without notice.
//
// A motor brakes with its full torque and drives with what its line leaves. Springs, friction and motors are
// stable at every stiffness, damping and step (drives_in_engine.hpp); coupled joints follow at its end
// (coupled_joints.hpp). A world that can't be right any more (plausible.hpp) stands still: `trouble()`,
// `trouble_text()`. Errors: std::invalid_argument when it is made (tree_in_engine.hpp, robot_model.hpp,
// checked_scene.hpp) or a place is none; std::out_of_range, with all names, for a name that the robot doesn't
// have, and mostly with how many there are for a number. Cost: docs/robots.md. It allocates nothing after the
// first beats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/base/eigen.hpp>
#include <cca/sim/robot/model/contact_account.hpp>
#include <cca/sim/engine/moving_frame.hpp>
#include <cca/sim/engine/refused_number.hpp>
#include <cca/sim/robot/model/push.hpp>
#include <cca/sim/robot/model/robot_model.hpp>
#include <cca/sim/robot/model/robot_state.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>
#include <cca/sim/engine/scene.hpp>

namespace cca::sim {

class world_in_engine;  // world_in_engine.hpp

class robot_world {
public:
  explicit robot_world(robot_model model, scene around = {}, const robot_world_settings& settings = {});

  robot_world(const robot_world& other);
  robot_world(robot_world&&) noexcept;
  robot_world& operator=(const robot_world& other);
  robot_world& operator=(robot_world&& other) noexcept;
  ~robot_world();

  // Puts the robot there: coordinates and speeds, and the motion of a base that floats. All are finite.
  void place(std::span<const double> q, std::span<const double> dq);
  void place(std::span<const double> q, std::span<const double> dq, const moving_frame& base);

  // One beat. A law that isn't finite is ignored: the drive keeps the last one.
  void advance(std::span<const joint_law> laws);

  // How the drives differ from their description from now on, one for each coordinate (drive_condition.hpp).
  // One that no drive can be in is ignored: the drive stays as it was.
  void set_condition(std::span<const drive_condition> now);

  // A force and a torque at the end of a part (in order of declaration), along the world's axes, until they
  // are set again.
  void pull(std::size_t part, const Eigen::Vector3d& force, const Eigen::Vector3d& torque = {0, 0, 0});
  void pull(std::string_view part, const Eigen::Vector3d& force, const Eigen::Vector3d& torque = {0, 0, 0}) {
    pull(index_of(model().names.ends, part, "part"), force, torque);
  }

  // A force on the centre of mass of a base that floats, along the world's axes, until it is set again.
  void push(const Eigen::Vector3d& force);
  // Pushes as the plan says, but only where it says something else than at the last call, so `push` is for
  // everybody. What it said is part of the state: a world that is restored goes on with the plan.
  void follow(const push_plan& plan);

  // Puts a box of the scene elsewhere.
  void move(std::size_t box, const placement& where);

  // Why it stands still.
  const world_trouble& trouble() const { return state().trouble; }
  std::string trouble_text() const;

  const std::vector<joint_reading>& joints() const { return state().joints; }
  const std::vector<joint_law>& laws() const { return state().laws; }  // that the drives follow
  const joint_reading& joint(std::string_view name) const {
    return state().joints[index_of(model().names.joints, name, "joint")];
  }
  // The torque about the sensor's origin, then the force of the world, along the sensor's axes.
  const std::array<double, 6>& load(std::size_t sensor) const {
    return state().loads[numbered(sensor, state().loads.size(), "force sensor")];
  }
  const std::array<double, 6>& load(std::string_view sensor) const {
    return load(index_of(model().names.sensors, sensor, "force sensor"));
  }

  // Of the world on all shapes at the end of a part, along the world's axes: N, a mean over the beat.
  const std::array<double, 3>& force_on_end(std::size_t part) const {
    return state().end_forces[numbered(part, state().end_forces.size(), "part")];
  }
  const std::array<double, 3>& force_on_end(std::string_view part) const {
    return force_on_end(index_of(model().names.ends, part, "part"));
  }

  const inertial_reading& inertial(std::size_t unit) const {
    return state().inertial[numbered(unit, state().inertial.size(), "inertial unit")];
  }
  const inertial_reading& inertial(std::string_view sensor) const {
    return inertial(static_cast<std::size_t>(
        model().unit_of[index_of(model().names.inertial, sensor, "inertial sensor")]));
  }

  // The true state, which no sensor of the robot measures; in the world.
  moving_frame frame(int link) const;
  moving_frame end(std::size_t part) const;
  moving_frame end(std::string_view part) const { return end(index_of(model().names.ends, part, "part")); }
  Eigen::Vector3d ball_position(std::size_t i) const;
  Eigen::Vector3d ball_velocity(std::size_t i) const;
  double mass() const;
  Eigen::Vector3d centre_of_mass() const;

  // Accounts since the start: of a shape, of those at the end of a part, of those on the base; J of the
  // motors.
  const contact_account& contact(std::size_t shape) const {
    return state().contacts[numbered(shape, state().contacts.size(), "shape of the robot")];
  }
  contact_account contact_at_end(std::size_t part) const {
    return contact_of(model(), state().contacts,
                      [&](const placed_shape& s) { return s.end == static_cast<int>(part); });
  }
  contact_account contact_at_end(std::string_view part) const {
    return contact_at_end(index_of(model().names.ends, part, "part"));
  }
  contact_account contact_of_base() const {
    return contact_of(model(), state().contacts, [](const placed_shape& s) { return s.link < 0; });
  }
  double positive_work() const { return state().positive_work; }  // braking is none
  double absolute_work() const { return state().absolute_work; }  // braking is work
  double parallel_error() const { return state().parallel_error; }

  // Of the robot alone, J: kinetic, and potential from the height of the world's origin.
  double energy() const;
  // In springs and cables between points and in the springs of joints, J.
  double spring_energy() const;
  // The force of a spring or cable (in order of declaration), N; negative: it pushes.
  double tension(std::size_t spring) const;
  double time() const { return static_cast<double>(state().beats) * model().beat; }

  const robot_model& model() const;
  const scene& around() const;
  // Of the floor or the terrain at x, whichever is higher; m. Without both it is minus infinity.
  double ground_height(double x) const;
  const robot_world_settings& settings() const;

  robot_state save() const;
  void restore(const robot_state& s);
  std::uint64_t hash() const { return save().hash(); }

private:
  const robot_state& state() const;

  std::unique_ptr<world_in_engine> in_;
};

}  // namespace cca::sim

#if !CCA_HAS_COMPILED_SIM
#include <cca/sim/robot/world/robot_world_functions.hpp>
#endif
