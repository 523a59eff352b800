#pragma once
// Virtual drives on four buses in memory, and behind them the arm in the simulator: where there is no arm.
//
//   behind_drives<on_canopen::joints, on_canopen::board> far;
//   far.connect(controller);          // which has the arm at "robot"
//   controller.step(), far.pass_millisecond();
//
// A drive measures its velocity with its encoder: the change of the angle over a millisecond. Each joint has
// a brake, as in arms: it holds the joint while its drive holds nothing, and takes 60 ms to open.
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>
#include <cca/hardware/virtual_robot.hpp>
#include <cca/sim/robot.hpp>

#include "spaces.hpp"

namespace touch {

using memory_wire = cca::hardware::memory_bus<3, 16>;
using memory_end = memory_wire::end_type;

// Neither copied nor moved: its parts point to one another.
template <class Joints, class Board>
class behind_drives {
public:
  static constexpr std::size_t count = Joints::count, buses = 4;
  static constexpr std::int64_t beat = 1'000'000;

  behind_drives() { far.connect(ends[0], ends[1], ends[2], ends[3]); }
  behind_drives(const behind_drives&) = delete;
  behind_drives& operator=(const behind_drives&) = delete;

  template <class Controller>
  void connect(Controller& c) {
    c.template get<"robot.synchronizer">().connect(near[0], near[1], near[2], near[3]);
  }

  cca::sim::robot_world& world() { return world_; }
  void put_down(cca::sim::robot_world&& w) {
    world_ = std::move(w);
    former = angles();
    held_at = former;
  }

  // What the drives do until the controller's next beat. `tap(bus, frame)` sees all frames of the controller.
  template <class Tap>
  void pass_millisecond(Tap tap) {
    const std::int64_t heard = now + beat / 2;
    go_to(heard);
    far.listen(heard, tap);
    laws = far.laws(heard);
    std::size_t i = 0;
    std::array<cca::sim::joint_law, count> motors;
    std::apply([&](const auto&... drive) { ((motors[i] = motor_of(i, drive.enabled()), ++i), ...); },
               far.drives);
    former = angles();
    world_.advance(motors);
    std::array<cca::hardware::drive_motion, count> motions;
    const auto at = angles();
    for (i = 0; i < count; ++i)
      motions[i] = {at[i], speed_scale[i] * (at[i] - former[i]) * 1000,
                    is_braked(i) ? motors[i].torque : world_.joints()[i].torque};
    auto felt = Board::reading::untold();
    felt.loads[0] = world_.load(0);
    far.tell(motions, felt);
    now += beat;
    go_to(now - 1);
  }
  void pass_millisecond() {
    pass_millisecond([](std::size_t, const cca::hardware::can_frame&) {});
  }

  std::array<memory_wire, buses> wires;
  cca::hardware::virtual_robot<memory_end, cca::hardware::virtual_of, Board, Joints> far{};
  std::array<cca::hardware::drive_command, count> laws{};  // of the drives in the last beat
  std::array<double, count> speed_scale = all_alike(1);    // of the velocities that they report
  std::int64_t now = 0;

private:
  static constexpr std::array<double, count> all_alike(double x) {
    std::array<double, count> all{};
    all.fill(x);
    return all;
  }
  std::array<double, count> angles() const {
    std::array<double, count> all;
    for (std::size_t i = 0; i < count; ++i) all[i] = world_.joints()[i].angle;
    return all;
  }
  bool is_braked(std::size_t i) const { return opening[i] < 60; }
  // The brake is eight times as stiff as the servo.
  cca::sim::joint_law motor_of(std::size_t i, bool enabled) {
    const auto& l = laws[i];
    opening[i] = enabled || l.damping > 0 || l.stiffness > 0 ? opening[i] + 1 : 0;
    if (!is_braked(i)) {
      held_at[i] = world_.joints()[i].angle;
      return {l.position, l.velocity, l.torque, l.stiffness, l.damping};
    }
    const auto& d = world_.model().drives[i];
    return {.position = held_at[i], .torque = l.torque, .stiffness = 8 * d.stiffness, .damping = d.damping};
  }
  void go_to(std::int64_t time) {
    for (auto& w : wires) w.advance(time);
  }

  cca::sim::robot_world world_{cca::sim::model_of<arm::description>()};
  std::array<double, count> former = angles(), held_at = former;
  std::array<int, count> opening{};  // for how many beats the drive has held its joint
  std::array<memory_end, buses> near{wires[0].end(0), wires[1].end(0), wires[2].end(0), wires[3].end(0)};
  std::array<memory_end, buses> ends{wires[0].end(1), wires[1].end(1), wires[2].end(1), wires[3].end(1)};
};

}  // namespace touch
