// A simulated robot that is not ideal: the ports of cca::sim::robot<R>, in either world, with sensors, drives
// and a battery as its parameters say (uncertainty.hpp).
//
//   cca::node<"robot", cca::sim::robot<R, cca::sim::uncertain<>>>                    in the engine
//   cca::node<"robot", cca::sim::robot<R, cca::sim::uncertain<cca::sim::compiled>>>  in compiled physics
//   controller.set("robot.simulator.orientation.noise", "1 deg");
//
// `uncertain<World>` takes any world that cca::sim::robot does. The parameters are those of the node
// "simulator", so files set them, too; they may change while it runs, but the seed counts from the next
// start. The masses and the ground belong to the world that a program puts down.
//
// Readings: joints and sensors, each as its parameters say. Commands: late, lost, a position with backlash
// and at a bounded speed; those of the first beat count at once. Drives and battery act
// within the physics (drive_condition.hpp). Without uncertainty it has the bits of the plain robot. A copy is
// a snapshot. Errors: as cca/sim/robot.hpp; parameters. Cost: a table of all numbers for each of the last 250
// ms, 100 operations for each number with noise. It allocates nothing. Example:
// tests/runtime/uncertain/robots.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include <cca/base/math/roots.hpp>
#include <cca/sim/robot/model/drive_condition.hpp>
#include <cca/sim/robot/robot_graph.hpp>
#include <cca/sim/uncertain/uncertainty.hpp>

namespace cca::sim {

template <class World = robot_world>
struct uncertain {};

namespace detail {

template <class R, class World>
struct world_named<R, uncertain<World>> : world_named<R, World> {};

template <class R, class World, class Axes, class Sensors>
class uncertain_robot_of;

template <class R, class World, class... Axes, class... Sensors>
class uncertain_robot_of<R, World, axes<Axes...>, robots::sensors<Sensors...>>
    : public simulated_robot_of<R, World, axes<Axes...>, robots::sensors<Sensors...>> {
  using plain = simulated_robot_of<R, World, axes<Axes...>, robots::sensors<Sensors...>>;
  using plain::count;
  static constexpr double beat = 1 / cca::detail::hz_of<typename R::rate>;
  static constexpr auto lines = static_cast<std::size_t>(most_delay / beat + 1.5);
  template <class Sensor>
  using numbers = std::array<double, static_cast<std::size_t>(robots::sensed<R, Sensor>::size)>;
  template <class Sensor>
  using channel = uncertain_channel<static_cast<std::size_t>(robots::sensed<R, Sensor>::size)>;
  using commands = std::array<robots::joint_commands, count>;

public:
  using parameters = uncertainty;
  parameters p{};

  auto sense() -> std::tuple<out<Axes::label, robots::measured_joint<R, Axes>>...,
                             out<Sensors::name, robots::sensed<R, Sensors>>...> {
    truth& now = past_.add();
    for (std::size_t i = 0; i < count; ++i) {
      const auto joint = plain::joint(i);
      now.joints[i] = {joint[0], joint[1], joint[2]};
    }
    now.sensors = {taken<Sensors>(plain::template numbers_of<Sensors>())...};
    return {joint_reading(static_cast<std::size_t>(axes<Axes...>::template index_of<Axes>))...,
            sensor_reading<Sensors>()...};
  }

  auto act(in<Axes::label, robots::wanted_joint<R, Axes>>... wanted) -> fault {
    asked_.add() = commands{robots::commands_of(wanted.vector())...};
    const commands& late = asked_.before(p.drives.delay, beat);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_lost = p.drives.loss > 0 && had_command_ && noise_.happens(p.drives.loss);
      if (!is_lost) taken_[i] = late[i];
    }
    had_command_ = true;
    commands now = taken_;
    for (std::size_t i = 0; i < count; ++i) follow(now[i], i);
    wear();
    return this->drive(now);
  }

  void on_start() {
    random_numbers sensors = generator_of(p, drawn_for::sensors), drives = generator_of(p, drawn_for::drives);
    noise_ = generator_of(p, drawn_for::noise);
    for (auto& joint : joints_)
      for (auto& reading : joint) reading.draw(sensors);
    std::apply([&](auto&... each) { (each.draw(sensors), ...); }, sensors_);
    for (worn& w : worn_) w = {drawn_deviation(drives), drives.uniform(), drives.uniform()};
    past_.clear(), asked_.clear();
    moved_.fill(robots::joint_commands::none);
    had_command_ = false;
    power_ = 0;
    plain::on_start();
  }

  // W, the mean that the battery gives; the share of its voltage that is left.
  double power() const { return power_; }
  double supply() const {
    if (!(p.battery.resistance > 0) || !(p.battery.open_circuit > 0)) return 1;
    // U = (V + sqrt(V^2 - 4 R P)) / 2; beyond its largest power half of the voltage is left.
    const double volts = p.battery.open_circuit, share = power_ * p.battery.resistance / (volts * volts);
    return 0.5 * (1 + math::sqrt(std::max(0.0, 1 - 4 * share)));
  }

private:
  struct truth {
    std::array<std::array<double, 3>, count> joints{};
    std::tuple<numbers<Sensors>...> sensors{};
  };
  struct worn {
    double strength = 0, friction = 0, dry_friction = 0;  // deviations; shares of what is the most
  };

  template <class Sensor, class Numbers>
  static numbers<Sensor> taken(const Numbers& from) {
    numbers<Sensor> all;
    std::copy_n(from.begin(), all.size(), all.begin());
    return all;
  }

  typename plain::joint_numbers joint_reading(std::size_t i) {
    typename plain::joint_numbers v;
    const auto read = [&](std::size_t k, const auto& as) {
      std::array<double, 1> x{past_.before(as.delay, beat).joints[i][k]};
      joints_[i][k].change(x, as, noise_);
      v[static_cast<Eigen::Index>(k)] = x[0];
    };
    read(0, p.angle), read(1, p.velocity), read(2, p.torque);
    return v;
  }

  template <class Sensor>
  static constexpr std::size_t place = [] {
    std::size_t at = 0;
    bool found = false;
    ((found = found || std::is_same_v<Sensor, Sensors>, at += found ? 0 : 1), ...);
    return at;
  }();
  template <class Sensor>
  const auto& parameters_of() const {
    using enum robots::sensor_kind;
    if constexpr (Sensor::kind == load) return p.load;
    else if constexpr (Sensor::kind == orientation) return p.orientation;
    else if constexpr (Sensor::kind == angular_velocity) return p.angular_velocity;
    else if constexpr (Sensor::kind == specific_force) return p.acceleration;
    else if constexpr (Sensor::kind == foot_load) return p.foot_load;
    else return p.foot_contact;
  }
  template <class Sensor>
  auto sensor_reading() {
    const auto& as = parameters_of<Sensor>();
    numbers<Sensor> now = std::get<place<Sensor>>(past_.before(as.delay, beat).sensors);
    std::get<place<Sensor>>(sensors_).change(now, as, noise_);
    return plain::template read_as<Sensor>(now);
  }

  // A position with lost motion and a bounded speed.
  void follow(robots::joint_commands& now, std::size_t i) {
    double& position = now[robots::command_kind::position];
    if (!std::isfinite(position)) return;
    double& moved = moved_[i];
    if (!std::isfinite(moved)) moved = position;
    const double half = 0.5 * p.drives.backlash, most = p.drives.speed * beat;
    double next = half > 0 ? std::clamp(moved, position - half, position + half) : position;
    if (most > 0) next = std::clamp(next, moved - most, moved + most);
    position = moved = next;
  }

  // The drives as they are in this beat.
  void wear() {
    const uncertain_drives& d = p.drives;
    const bool sags = p.battery.resistance > 0;
    if (sags) draw_power();
    const bool is_worn = sags || d.strength > 0 || d.weakness > 0 || d.friction > 0 || d.dry_friction > 0;
    if (!is_worn && !was_worn_) return;
    was_worn_ = is_worn;
    std::array<drive_condition, plain::coordinates> all{};
    const double left = supply();
    for (std::size_t i = 0; i < count; ++i)
      all[plain::coordinate[i]] = {
          .strength = std::max(0.0, (1 - d.weakness) * (1 + d.strength * worn_[i].strength)),
          .supply = left,
          .friction = d.friction * worn_[i].friction,
          .dry_friction = d.dry_friction * worn_[i].dry_friction};
    this->world().set_condition(all);
  }
  void draw_power() {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto joint = plain::joint(i);
      const robots::motor_line& m = this->world().model().drives[plain::coordinate[i]].motor;
      if (m.torque > 0)
        sum += std::max(0.0, joint[2] * joint[1] + joint[2] * joint[2] * m.no_load_speed / (2 * m.torque));
    }
    power_ += (sum - power_) * (p.battery.mean > beat ? beat / p.battery.mean : 1);
  }

  random_numbers noise_{};
  std::array<std::array<uncertain_channel<1>, 3>, count> joints_{};
  std::tuple<channel<Sensors>...> sensors_{};
  std::array<worn, count> worn_{};
  delay_line<truth, lines> past_{};
  delay_line<commands, lines> asked_{};
  commands taken_{};
  std::array<double, count> moved_{};
  double power_ = 0;  // W
  bool had_command_ = false, was_worn_ = false;
};

}  // namespace detail

template <class R, class World>
class simulated_robot<R, uncertain<World>>
    : public detail::uncertain_robot_of<R,
                                        typename detail::world_named<R, World>::type,
                                        robots::measured_axes_of<R>,
                                        robots::sensors_of<R>> {};

}  // namespace cca::sim
