// A described robot in a simulated world as a plant: what the drives of a robot move, where there is none.
//
//   cca::hardware::virtual_hardware<my_arm, cca::sim::plant<description>> far(...);
//   far.plant.put_down(std::move(world));      // else the robot as its description places it
//
// World: robot_world, which plant.hpp includes, cca::sim::compiled (compiled/plant.hpp), or a type derived
// from either's world.
//
// A drive measures its velocity with its encoder: the change of the angle over a beat. What holds the robot
// while its drives hold nothing, `hold`:
//   nothing    it falls
//   brakes     each joint has a brake, as in arms: it holds the joint while its drive holds nothing, and
//              takes 60 ms to open
//   stand      the robot does not move until all drives have been enabled once
//
// It knows nothing of drives and boards: laws, motions and readings are any types with the members that
// cca/hardware/virtual_drives/virtual_hardware.hpp names. Cost: that of the world.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <cca/robots/ports.hpp>
#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/world_named.hpp>

namespace cca::sim {

enum class held_by : std::uint8_t { nothing, brakes, stand };

template <class R, class World = robot_world>
class plant {
  using measured = robots::measured_axes_of<R>;

public:
  using world_type = typename detail::world_named<R, World>::type;
  static constexpr auto count = static_cast<std::size_t>(measured::count);
  struct motion {
    double position = 0, velocity = 0, torque = 0;  // rad, rad/s, N m
  };

  held_by hold = held_by::nothing;

  world_type& world() { return world_; }
  const world_type& world() const { return world_; }
  void put_down(world_type&& w) {
    world_ = std::move(w);
    *this = plant(std::move(world_), hold);
  }

  plant() : plant(detail::world_at_start<R, world_type>(), held_by::nothing) {}
  plant(world_type&& w, held_by how) : hold(how), world_(std::move(w)) {
    for (std::size_t i = 0; i < count; ++i) moved_[i].position = held_at_[i] = angle(i);
  }

  template <class Laws>
  void advance(const Laws& laws, const std::array<bool, count>& enabled, double seconds) {
    stood_ = stood_ || std::ranges::all_of(enabled, [](bool yes) { return yes; });
    std::array<double, count> pulls{};
    if (hold != held_by::stand || stood_) {
      std::array<joint_law, static_cast<std::size_t>(robots::axes_of_robot<R>::count)> motors{};
      for (std::size_t i = 0; i < count; ++i) {
        motors[coordinate[i]] = motor_of(i, laws[i], enabled[i]);
        pulls[i] = motors[coordinate[i]].torque;
      }
      world_.advance(motors);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double before = moved_[i].position, now = angle(i);
      moved_[i] = {now, (now - before) / seconds,
                   is_braked(i) ? pulls[i] : world_.joints()[coordinate[i]].torque};
    }
  }
  std::array<motion, count> motions() const { return moved_; }

  template <class Reading>
  void feel(Reading& r) const {
    using sensors = robots::sensors_of<R>;
    if constexpr (requires { r.loads[0] = world_.load(0); })
      for (std::size_t i = 0; i < robots::detail::load_count(sensors()); ++i) r.loads[i] = world_.load(i);
    if constexpr (requires { r.inertial[0] = world_.inertial(0); })
      for (std::size_t i = 0; i < robots::detail::unit_count(sensors()); ++i)
        r.inertial[i] = world_.inertial(i);
  }

private:
  // Of each measured axis, among the coordinates of the body.
  static constexpr std::array<std::size_t, count> coordinate = []<class... Axes>(axes<Axes...>) {
    return std::array{static_cast<std::size_t>(robots::axes_of_robot<R>::template index_of<Axes>)...};
  }(measured());
  static constexpr int opens_after = 60;  // ms

  double angle(std::size_t i) const { return world_.joints()[coordinate[i]].angle; }
  bool is_braked(std::size_t i) const {
    return hold == held_by::brakes && open_for_[i] * 1e3 * world_.model().beat < opens_after;
  }
  // A brake is eight times as stiff as the servo.
  template <class Law>
  joint_law motor_of(std::size_t i, const Law& l, bool enabled) {
    open_for_[i] = enabled || l.damping > 0 || l.stiffness > 0 ? open_for_[i] + 1 : 0;
    if (!is_braked(i)) {
      held_at_[i] = angle(i);
      return {l.position, l.velocity, l.torque, l.stiffness, l.damping};
    }
    const auto& d = world_.model().drives[coordinate[i]];
    return {.position = held_at_[i], .torque = l.torque, .stiffness = 8 * d.stiffness, .damping = d.damping};
  }

  world_type world_;
  std::array<motion, count> moved_{};
  std::array<double, count> held_at_{};
  std::array<int, count> open_for_{};  // for how many beats the drive has held its joint
  bool stood_ = false;
};

}  // namespace cca::sim
