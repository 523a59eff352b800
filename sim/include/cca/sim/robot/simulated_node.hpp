// The synchronizer of a simulated robot: the one node that knows its world. `sense` hands the readings to the
// resource nodes of the joints; `act` takes what they want and advances the world by a beat.
//
//   sense   out one port for each joint, under its axis' name: measured_joint<R, Axis>
//           out one port for each sensor, under its name (cca/robots/sensors.hpp); loads and accelerations
//               are means over the last beat
//   act     in  one port for each joint: wanted_joint<R, Axis>
//           a fault, once the world can't be right any more (plausible.hpp): it names the body;
//           `world().trouble_text()` has the numbers. The world stands still from then on
//
//   After a fault, and while the controller is stopped, the motors only damp; each `step()` is still a beat
//   of physics.
//
// `put_down` sets the world; without it the robot stands alone where R::start has it. `disturb` pushes the
// base at given times; `world()` is for all else that happens to the robot: pulls, boxes that move. A copy of
// the node is a snapshot of the world. A node that is derived from it may change the commands and the
// readings (uncertain/uncertain_robot.hpp). Cost: a beat of physics (docs/robots.md); the rest is copying
// numbers.
//
//   World   robot_world, or a type derived from it that answers more questions (cca/sim/oncilla/world.hpp); its
//           `at_start()` says how it is put down unless a program does
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/component/fault.hpp>
#include <cca/component/port.hpp>
#include <cca/robots/commanded_joint.hpp>
#include <cca/robots/joint_servo.hpp>
#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/model/plausible.hpp>
#include <cca/sim/robot/model/push.hpp>
#include <cca/sim/robot/model/robot_model.hpp>
#include <cca/sim/robot/world_named.hpp>

namespace cca::sim {

namespace detail {

template <class R, class World, class Axes, class Sensors>
class simulated_robot_of;

template <class R, class World, class... Axes, class... Sensors>
class simulated_robot_of<R, World, axes<Axes...>, robots::sensors<Sensors...>> {
protected:
  static constexpr std::size_t count = sizeof...(Axes);
  static constexpr auto coordinates = static_cast<std::size_t>(robots::axes_of_robot<R>::count);
  static constexpr std::array<std::size_t, count> coordinate{
      static_cast<std::size_t>(robots::axes_of_robot<R>::template index_of<Axes>)...};
  static constexpr std::array<bool, count> turns_without_end{is_continuous<Axes>...};

public:
  void put_down(World&& world, const push_plan& pushes = {}) {
    world_ = std::move(world);
    servos_ = {};
    disturb(pushes);
  }

  // While it runs, too.
  void disturb(const push_plan& pushes) { pushes_ = pushes; }

  World& world() { return world_; }
  const World& world() const { return world_; }

  auto sense() -> std::tuple<out<Axes::label, robots::measured_joint<R, Axes>>...,
                             out<Sensors::name, robots::sensed<R, Sensors>>...> {
    return {joint(static_cast<std::size_t>(axes<Axes...>::template index_of<Axes>))...,
            read_as<Sensors>(numbers_of<Sensors>())...};
  }

  auto act(in<Axes::label, robots::wanted_joint<R, Axes>>... wanted) -> fault {
    return drive({robots::commands_of(wanted.vector())...});
  }

  void on_start() { servos_ = {}, is_driven_ = true; }
  void on_stop() { is_driven_ = false; }
  void on_fault() { is_driven_ = false; }
  // Stopped or faulted it moves under its damping. Between two runs no simulated time passes, so a result
  // does not depend on how long they are apart.
  void on_idle() {
    if (is_driven_) return;
    std::array<joint_law, coordinates> laws;
    for (std::size_t c = 0; c < coordinates; ++c) laws[c] = {.damping = world_.model().drives[c].damping};
    world_.follow(pushes_);
    world_.advance(laws);
  }

protected:
  using joint_numbers = Eigen::Vector3d;  // angle, velocity, torque

  fault drive(const std::array<robots::joint_commands, count>& commands) {
    std::array<joint_law, coordinates> laws{};
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t c = coordinate[i];
      const robots::joint_drive& d = world_.model().drives[c];
      laws[c] = servos_[i].follow(commands[i],
                                  {d.position_stiffness(), d.damping, d.motor.torque, d.motor.no_load_speed,
                                   turns_without_end[i], d.holds},
                                  world_.joints()[c].angle, world_.model().beat);
    }
    is_driven_ = true;
    world_.follow(pushes_);
    world_.advance(laws);
    return why();
  }

  // Of the joint with this number among the measured ones.
  joint_numbers joint(std::size_t i) const {
    const auto& r = world_.joints()[coordinate[i]];
    return {r.angle, r.velocity, r.torque};
  }
  template <class Sensor>
  decltype(auto) numbers_of() const {
    using all = robots::sensors<Sensors...>;
    if constexpr (robots::is_of_feet<Sensor>) {
      return feet<Sensor>();
    } else if constexpr (Sensor::kind == robots::sensor_kind::load) {
      return world_.load(robots::detail::place_among_loads<Sensor>(all()));
    } else {
      return robots::detail::share_of<Sensor>(world_.inertial(robots::detail::unit_of<Sensor>(all())));
    }
  }
  template <class Sensor, class Numbers>
  static out<Sensor::name, robots::sensed<R, Sensor>> read_as(const Numbers& numbers) {
    using vector = typename robots::sensed<R, Sensor>::vector_type;
    return vector(vector::Map(numbers.data()));
  }

private:
  // A fault keeps a pointer to its text, so the texts of this robot live as long as the program.
  static const std::vector<std::string>& reasons() {
    static const std::vector<std::string> all = [] {
      const robot_model m = model_of<R>();
      std::vector<std::string> texts;
      for (int body = world_trouble::base; body < static_cast<int>(m.links.size()); ++body)
        texts.push_back("the simulation is not plausible any more, first at " +
                        detail::name_of_body(m, body) + ": world().trouble_text() has the numbers");
      texts.emplace_back("the simulation is not plausible any more: world().trouble_text() says why");
      return texts;
    }();
    return all;
  }
  fault why() const {
    const world_trouble& t = world_.trouble();
    if (!t) return {};
    const bool has_name = t.what != implausible::engine && t.body >= world_trouble::base;
    return reasons_
        ->at(has_name ? static_cast<std::size_t>(t.body - world_trouble::base) : reasons_->size() - 1)
        .c_str();
  }

  template <class Sensor>
  auto feet() const {
    constexpr auto ends = robots::detail::parts_of_sensor<Sensor, typename R::body>;
    std::array<double, ends.size()> all;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const std::array<double, 3>& force = world_.force_on_end(ends[i]);
      const bool touches = force != std::array<double, 3>{};
      all[i] = Sensor::kind == robots::sensor_kind::foot_load ? force[2] : touches ? 1.0 : 0.0;
    }
    return all;
  }

  World world_ = world_at_start<R, World>();
  const std::vector<std::string>* reasons_ = &reasons();
  std::array<robots::joint_servo, count> servos_{};
  push_plan pushes_{};
  bool is_driven_ = false;
};

template <class R, class Axis>
struct simulated_joint : robots::commanded_joint<R, Axis> {
  using record = robots::joint_readings<R, Axis>;

  auto sense(in<"measured", robots::measured_joint<R, Axis>> now)
      -> std::tuple<out<"angle", sub_space<robots::angles<R>, Axis>>,
                    out<"velocity", sub_space<robots::velocities<R>, Axis>>,
                    out<"torque", sub_space<robots::torques<R>, Axis>>> {
    const auto& v = now.vector();
    return {record::template part<"angle">(v), record::template part<"velocity">(v),
            record::template part<"torque">(v)};
  }
};

template <class R>
struct joints_of {
  template <class Axis>
  struct node : simulated_joint<R, Axis> {};
};

}  // namespace detail

template <class R, class World = robot_world>
class simulated_robot : public detail::simulated_robot_of<R,
                                                          typename detail::world_named<R, World>::type,
                                                          robots::measured_axes_of<R>,
                                                          robots::sensors_of<R>> {};

}  // namespace cca::sim
