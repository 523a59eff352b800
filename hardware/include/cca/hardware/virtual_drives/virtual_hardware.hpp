// All that is at the far end of a robot's buses, in memory: the buses, a virtual drive for each joint, the
// board, and after them a plant, which moves the joints. So a robot runs where there is none, in one line:
//
//   struct my_arm : cca::hardware::robot<description, cca::hardware::virtual_bus_end, a1, ..., board> {};
//   ...
//   cca::hardware::virtual_hardware<my_arm, cca::sim::plant<description>> far(
//       controller.get<"robot.synchronizer">());
//   controller.step(), far.step();   // and so on: what happens until the controller's next beat
//
//   Robot     a hardware::robot, or any type with its `joints` and `board`; any mixture of drives and buses
//   Plant     advance(laws, enabled, seconds)   a beat; the law of each joint (drive_command, at the joint)
//                                               and whether its drive is enabled
//             motions()                         position, velocity and torque of each joint: rad, rad/s, N m
//             feel(reading)                     optional: what the board reads
//             move_servos(targets)              optional: rad, of the servos of an Oncilla's board
//             cca::sim::plant (the simulator) is one; virtual_motors<Robot::joints> below another, a motor
//             for each joint: far.plant.put_at<hip>(0.3) puts one at its angle before a start
//   Virtual   the virtual drive for each drive (virtual_of.hpp)
//
// drive<Axis>() is the virtual drive of the joint of that axis: far.drive<hip>().go_silent(true).
// step(tap) calls tap(bus, frame) for each frame of the controller. pace() is the pace of runs in the time of
// these drives: `controller.run(cca::for_<10>{}, far.pace())`, `shut_down(controller, far.pace())`. `wires`:
// the third end of each bus is for spies and for nodes that disturb. `speed_scale`: of the velocities that
// the drives report, for tests. Neither copied nor moved: its parts point to one another. Error:
// space.unknown_axis. Example: tests/runtime/robot_on_drives/laboratory.cpp; docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/type_name.hpp>
#include <cca/hardware/bus/memory_bus.hpp>
#include <cca/hardware/safety/beats.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>
#include <cca/hardware/virtual_drives/virtual_robot.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::hardware {

using virtual_bus = memory_bus<3, 16>;
using virtual_bus_end = virtual_bus::end_type;

namespace detail {

template <class Joints, class Axis>
struct axis_without_joint {
  static constexpr void tell(auto& m) {
    m << "space.unknown_axis: no joint of this robot has the axis " << cca::detail::type_name<Axis>()
      << ": its joints have " << cca::detail::axes_in_words<typename Joints::axes>() << "; name one of these";
  }
};

// The number of the joint of an axis.
template <class Joints, class Axis>
constexpr std::size_t joint_of() {
  constexpr bool is_there = Joints::axes::template contains<Axis>;
  static_assert(cca::detail::holds_or_tells<is_there, axis_without_joint<Joints, Axis>>::value);
  if constexpr (is_there) return static_cast<std::size_t>(Joints::axes::template index_of<Axis>);
  else return 0;
}

}  // namespace detail

// A plain motor for each joint, with a load (N m) on it. `Joints`: `Robot::joints`.
template <class Joints>
struct virtual_motors {
  static constexpr std::size_t count = Joints::count;
  std::array<virtual_motor, count> motors{};
  std::array<double, count> load{};

  // At rest at this angle of the joint (rad).
  template <class Axis>
  void put_at(double angle) {
    motors[detail::joint_of<Joints, Axis>()].now = {angle, 0, 0};
  }
  template <class Axis>
  virtual_motor& motor() {
    return motors[detail::joint_of<Joints, Axis>()];
  }
  template <class Axis>
  const virtual_motor& motor() const {
    return motors[detail::joint_of<Joints, Axis>()];
  }

  void advance(const std::array<drive_command, count>& laws, const std::array<bool, count>&, double seconds) {
    for (std::size_t i = 0; i < count; ++i) motors[i].advance(laws[i], load[i], seconds);
  }
  std::array<drive_motion, count> motions() const {
    std::array<drive_motion, count> all;
    std::ranges::transform(motors, all.begin(), &virtual_motor::now);
    return all;
  }
};

namespace detail {

template <class Robot>
struct beat_of {
  static constexpr std::int64_t ns = 1'000'000;
};
template <class Robot>
  requires requires { typename Robot::description::rate; }
struct beat_of<Robot> {
  static constexpr std::int64_t ns = beats<typename Robot::description::rate>::period;
};

// The bit rates of each bus: those of the joints on it, or of the board.
template <std::size_t Buses, class Board, class... J>
constexpr std::array<bit_rates, Buses> rates_of_buses(joint_list<J...>) {
  std::array<bit_rates, Buses> all{};
  if constexpr (requires { Board::rates; }) all[Board::bus] = Board::rates;
  ((all[J::bus] = J::rates), ...);
  return all;
}

}  // namespace detail

template <class Robot, class Plant, template <class> class Virtual = virtual_of>
class virtual_hardware {
public:
  using joints = typename Robot::joints;
  using board = typename Robot::board;
  using drives_and_board = virtual_robot<virtual_bus_end, Virtual, board, joints>;
  static constexpr std::size_t count = drives_and_board::count, buses = drives_and_board::buses;
  static constexpr std::int64_t beat = detail::beat_of<Robot>::ns;

  // `each`: of each bus, but the rates are those of its drives, and the seeds grow with its number.
  explicit virtual_hardware(const memory_bus_options& each = {}) : wires(made_wires(each)) {
    std::apply([&](auto&... end) { far.connect(end...); }, ends);
  }
  template <class Synchronizer>
    requires requires(const Synchronizer& s) { s.phase(); }
  explicit virtual_hardware(Synchronizer& synchronizer, const memory_bus_options& each = {})
      : virtual_hardware(each) {
    connect(synchronizer);
  }
  virtual_hardware(const virtual_hardware&) = delete;
  virtual_hardware& operator=(const virtual_hardware&) = delete;

  // Also after the controller has become another one.
  template <class Synchronizer>
  void connect(Synchronizer& synchronizer) {
    std::apply([&](auto&... end) { synchronizer.connect(end...); }, near);
  }

  template <class Tap>
  void step(Tap tap) {
    const std::int64_t heard = now + answers_at;
    go_to(heard);
    far.listen(heard, tap);
    laws = far.laws(heard);
    if constexpr (requires { plant.move_servos(far.abduction); }) plant.move_servos(far.abduction);
    plant.advance(laws, enabled(), 1e-9 * static_cast<double>(beat));
    const auto moved = plant.motions();
    std::array<drive_motion, count> motions;
    for (std::size_t i = 0; i < count; ++i)
      motions[i] = {moved[i].position, speed_scale[i] * moved[i].velocity, moved[i].torque};
    typename board::reading felt{};
    if constexpr (requires { plant.feel(felt); }) plant.feel(felt);
    far.tell(motions, felt);
    now += beat;
    go_to(now - 1);
  }
  void step() {
    step([](std::size_t, const can_frame&) {});
  }

  // Instead of the clock's time that of the drives passes.
  class time_of_drives {
  public:
    explicit time_of_drives(virtual_hardware& all) : far(&all) {}
    void begin() { begun = far->now; }
    void wait(std::int64_t since) {
      while (far->now < begun + since) far->step();
    }

  private:
    virtual_hardware* far;
    std::int64_t begun = 0;
  };
  time_of_drives pace() { return time_of_drives(*this); }

  template <class Axis>
  auto& drive() {
    return std::get<detail::joint_of<joints, Axis>()>(far.drives);
  }
  std::array<bool, count> enabled() const {
    return std::apply([](const auto&... drive) { return std::array{drive.enabled()...}; }, far.drives);
  }
  std::size_t enabled_count() const { return static_cast<std::size_t>(std::ranges::count(enabled(), true)); }

  std::array<virtual_bus, buses> wires;
  drives_and_board far{};
  Plant plant{};
  std::array<drive_command, count> laws{};  // of the drives in the last beat, in numbers of the joints
  std::array<double, count> speed_scale = ones();
  std::int64_t now = 0;                // ns
  std::int64_t answers_at = beat / 2;  // ns into a beat: when the drives answer

private:
  static std::array<virtual_bus, buses> made_wires(const memory_bus_options& each) {
    constexpr auto rates = detail::rates_of_buses<buses, board>(joints());
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::array{virtual_bus({rates[I], each.one_shot, each.seed + I, each.script})...};
    }(std::make_index_sequence<buses>());
  }
  static constexpr std::array<double, count> ones() {
    std::array<double, count> all{};
    all.fill(1);
    return all;
  }
  std::array<virtual_bus_end, buses> all_ends(std::size_t side) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::array{wires[I].end(side)...};
    }(std::make_index_sequence<buses>());
  }
  void go_to(std::int64_t time) {
    for (auto& w : wires) w.advance(time);
  }

  std::array<virtual_bus_end, buses> near = all_ends(0), ends = all_ends(1);
};

}  // namespace cca::hardware
