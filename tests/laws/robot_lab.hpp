// A robot on virtual drives, without a simulator: eight plain motors are its mechanics. For tests of starting
// and stopping, and for the random campaign.
//
//   robot_lab<joints, board, architecture> lab;   // `architecture` has the robot at "robot"
//   lab.beat();                                   // the controller's step, then the drives' millisecond
//
// The third end of each bus is for spies and for nodes that disturb.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include <cca/cca.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/oncilla.hpp>
#include <cca/hardware/virtual_robot.hpp>

namespace laws {

namespace hw = cca::hardware;
namespace oncilla = cca::robots::oncilla;

using lab_wire = hw::memory_bus<3, 16>;
using wire_end = lab_wire::end_type;

// A send queue that takes nothing while a test says so.
struct refusing {
  bool now = false;
  std::uint64_t frames = 0;
  hw::bus_counters counted{};
};

// The controller's end of a bus; it notes what the controller sends, or tries to send.
struct lab_end {
  wire_end end;
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

template <class Joints, class Board, class Architecture, template <class> class Virtual>
class robot_lab {
public:
  using joints = Joints;
  static constexpr std::size_t count = Joints::count, buses = 5;

  explicit robot_lab(bool one_shot = true)
      : wires{made(one_shot, 0), made(one_shot, 1), made(one_shot, 2), made(one_shot, 3), made(one_shot, 4)} {
    for (std::size_t i = 0; i < count; ++i) put(i, (Joints::angle[i].lower + Joints::angle[i].upper) / 2);
    controller.template get<"robot.synchronizer">().connect(near[0], near[1], near[2], near[3], near[4]);
    far.connect(ends[0], ends[1], ends[2], ends[3], ends[4]);
  }
  robot_lab(const robot_lab&) = delete;
  robot_lab& operator=(const robot_lab&) = delete;

  // A knee is pulled against a spring, which holds it where it is put.
  void put(std::size_t i, double angle) {
    motors[i].now = {angle, 0, 0};
    rest[i] = angle;
    if (is_pulled(i)) motors[i].friction = 0.3;
  }

  void beat(bool controller_runs = true) {
    for (auto& frames : sent) frames.clear();
    if (controller_runs) controller.step();
    rest_of_beat();
  }
  void beats(int n) {
    for (; n > 0; --n) beat();
  }
  // What happens until the next step of the controller.
  void rest_of_beat() {
    go_to(now + 500'000);
    far.listen(now + 500'000, [&](std::size_t bus, const hw::can_frame& f) { heard(bus, f); });
    command = far.laws(now + 500'000);
    std::array<hw::drive_motion, count> motions;
    for (std::size_t i = 0; i < count; ++i) {
      motors[i].advance(command[i], is_pulled(i) ? 2 * (rest[i] - motors[i].now.position) : 0, 1e-3);
      motions[i] = motors[i].now;
      motions[i].velocity *= speed_scale[i];
    }
    board.abduction = abducted;
    far.tell(motions, board);
    go_to((now += 1'000'000) - 1);
  }

  auto& stop() { return controller.template get<"robot.emergency_stop">(); }
  auto& synchronizer() { return controller.template get<"robot.synchronizer">(); }
  hw::motion_phase phase() { return synchronizer().phase(); }
  bool is_enabled(std::size_t i) const {
    std::size_t at = 0;
    bool found = false;
    std::apply([&](const auto&... drive) { ((found = at++ == i ? drive.enabled() : found), ...); },
               far.drives);
    return found;
  }
  int enabled() const {
    int n = 0;
    for (std::size_t i = 0; i < count; ++i) n += is_enabled(i);
    return n;
  }
  double stiffest() const {
    double most = 0;
    for (const auto& c : command) most = std::max(most, c.stiffness);
    return most;
  }
  double least_damping() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& c : command) least = std::min(least, c.damping);
    return least;
  }

  std::array<std::vector<hw::can_frame>, buses> sent{};  // by the controller, in this beat, on each bus
  std::array<refusing, buses> refused{};                 // whether the controller's end takes frames
  // What happens to each bus; a test may write it while the lab runs. It begins with nothing.
  static constexpr hw::bus_fault no_trouble{.from = 0, .until = 0};
  std::array<std::array<hw::bus_fault, 3>, buses> troubles = [] {
    std::array<std::array<hw::bus_fault, 3>, buses> all;
    for (auto& of_bus : all) of_bus.fill(no_trouble);
    return all;
  }();
  std::array<lab_wire, buses> wires;
  cca::controller<Architecture> controller{};
  hw::virtual_robot<wire_end, Virtual, Board, Joints> far{};
  std::array<hw::virtual_motor, count> motors{};
  std::array<hw::drive_command, count> command{};                 // what the drives follow
  std::array<double, count> speed_scale{1, 1, 1, 1, 1, 1, 1, 1};  // of the velocities that they report
  std::array<double, 4> abducted{};                               // where the abduction servos are
  hw::board_reading board{};
  std::int64_t now = 0;

protected:
  virtual ~robot_lab() = default;
  virtual void heard(std::size_t, const hw::can_frame&) {}

private:
  lab_wire made(bool one_shot, std::size_t bus) const {
    return lab_wire({.rates = {1'000'000}, .one_shot = one_shot, .seed = bus + 1, .script = troubles[bus]});
  }
  static constexpr bool is_pulled(std::size_t i) { return Joints::torque[i].lower >= 0; }
  void go_to(std::int64_t time) {
    for (auto& w : wires) w.advance(time);
  }
  std::array<lab_end, buses> near{{{wires[0].end(0), &sent[0], &refused[0]},
                                   {wires[1].end(0), &sent[1], &refused[1]},
                                   {wires[2].end(0), &sent[2], &refused[2]},
                                   {wires[3].end(0), &sent[3], &refused[3]},
                                   {wires[4].end(0), &sent[4], &refused[4]}}};
  std::array<wire_end, buses> ends{wires[0].end(1), wires[1].end(1), wires[2].end(1), wires[3].end(1),
                                   wires[4].end(1)};
  std::array<double, count> rest{};
};

}  // namespace laws
