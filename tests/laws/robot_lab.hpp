// A robot on virtual drives, without a simulator: plain motors are its mechanics. For tests of starting and
// stopping, of all families of drives, and for the random campaign.
//
//   robot_lab<robot<lab_end>, architecture> lab;   // `architecture` has the robot at "robot"
//   lab.beat();                                    // the controller's step, then the drives' millisecond
//
// It is a cca::hardware::virtual_hardware, so it has the drives, the buses and what the drives follow. The
// third end of each bus is for spies and for nodes that disturb.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/cca.hpp>
#include <cca/hardware/sensor_board.hpp>
#include <cca/hardware/virtual_hardware.hpp>

namespace laws {

namespace hw = cca::hardware;

// A send queue that takes nothing while a test says so.
struct refusing {
  bool now = false;
  std::uint64_t frames = 0;
  hw::bus_counters counted{};
};

// The controller's end of a bus; it notes what the controller sends, or tries to send.
struct lab_end {
  hw::virtual_bus_end end;
  std::vector<hw::can_frame>* sent;
  refusing* refused;

  hw::send_result send(std::span<const hw::can_frame> frames) noexcept {
    sent->insert(sent->end(), frames.begin(), frames.end());
    if (!refused->now || frames.empty()) return end.send(frames);
    refused->frames += frames.size();
    return {.sent = 0, .outcome = hw::send_outcome::full};
  }
  std::size_t receive(std::span<hw::received_frame> into) noexcept { return end.receive(into); }
  hw::bus_state state() const noexcept { return end.state(); }
  const hw::bus_counters& counters() const noexcept {
    refused->counted = end.counters();
    refused->counted.dropped_full += refused->frames;
    return refused->counted;
  }
  std::uint64_t in_flight() const noexcept { return end.in_flight(); }
};
static_assert(hw::CanBus<lab_end>);

// The middle of a joint's range, where the lab puts it.
template <class Joints>
constexpr double middle_of(std::size_t joint) {
  return (Joints::angle[joint].lower + Joints::angle[joint].upper) / 2;
}

// A motor a joint. A cable pulls a knee against a spring, which holds it where it is put.
template <class Joints>
struct pulled_motors : hw::virtual_motors<Joints> {
  static constexpr std::size_t count = Joints::count;
  std::array<double, count> rest{};
  std::array<double, 4> abducted{};  // where the abduction servos are

  void put(std::size_t i, double angle) {
    this->motors[i].now = {angle, 0, 0};
    rest[i] = angle;
    if (is_pulled(i)) this->motors[i].friction = 0.3;
  }
  void advance(const std::array<hw::drive_command, count>& laws,
               const std::array<bool, count>& enabled,
               double seconds) {
    for (std::size_t i = 0; i < count; ++i)
      this->load[i] = is_pulled(i) ? 2 * (rest[i] - this->motors[i].now.position) : 0;
    hw::virtual_motors<Joints>::advance(laws, enabled, seconds);
  }
  void feel(hw::board_reading& r) const { r.abduction = abducted; }

private:
  static constexpr bool is_pulled(std::size_t i) { return Joints::torque[i].lower >= 0; }
};

template <class Robot, class Architecture, template <class> class Virtual = hw::virtual_of>
class robot_lab : public hw::virtual_hardware<Robot, pulled_motors<typename Robot::joints>, Virtual> {
  using hardware = hw::virtual_hardware<Robot, pulled_motors<typename Robot::joints>, Virtual>;

public:
  using joints = typename Robot::joints;
  using hardware::buses, hardware::count;

  explicit robot_lab(bool one_shot = true) : hardware({.one_shot = one_shot, .seed = 1}) {
    for (std::size_t i = 0; i < count; ++i) this->plant.put(i, middle_of<joints>(i));
    for (std::size_t b = 0; b < buses; ++b) this->wires[b].follow(troubles[b]);
    std::apply([this](auto&... end) { synchronizer().connect(end...); }, near);
  }

  void beat() {
    for (auto& frames : sent) frames.clear();
    controller.step();
    rest_of_beat();
  }
  void beats(int n) {
    for (; n > 0; --n) beat();
  }
  // What happens until the next step of the controller.
  void rest_of_beat() { hardware::step(heard); }

  auto& stop() { return controller.template get<"robot.emergency_stop">(); }
  auto& synchronizer() { return controller.template get<"robot.synchronizer">(); }
  hw::motion_phase phase() { return synchronizer().phase(); }
  template <class F>
  void of_drive(std::size_t which, F f) {
    std::size_t i = 0;
    std::apply([&](auto&... drive) { ((i++ == which ? f(drive) : void()), ...); }, this->far.drives);
  }
  double stiffest() const {
    return std::ranges::max(this->laws, {}, &hw::drive_command::stiffness).stiffness;
  }
  double least_damping() const {
    return std::ranges::min(this->laws, {}, &hw::drive_command::damping).damping;
  }

  // Called for each frame that the drives hear.
  std::function<void(std::size_t bus, const hw::can_frame&)> heard = [](std::size_t, const hw::can_frame&) {};
  std::array<std::vector<hw::can_frame>, buses> sent{};  // by the controller, in this beat, on each bus
  std::array<refusing, buses> refused{};                 // whether the controller's end takes frames
  // What happens to each bus; a test may write it while the lab runs. It begins with nothing.
  static constexpr hw::bus_fault no_trouble{.from = 0, .until = 0};
  std::array<std::array<hw::bus_fault, 3>, buses> troubles = [] {
    std::array<std::array<hw::bus_fault, 3>, buses> all;
    for (auto& of_bus : all) of_bus.fill(no_trouble);
    return all;
  }();
  cca::controller<Architecture> controller{};

private:
  std::array<lab_end, buses> near = [this]<std::size_t... B>(std::index_sequence<B...>) {
    return std::array{lab_end{this->wires[B].end(0), &sent[B], &refused[B]}...};
  }(std::make_index_sequence<buses>());
};

}  // namespace laws
