#pragma once
// The spy of the fault campaign: a third node on each bus, which checks every frame that leads to motion.
//
//   a set point of a drive    its numbers within the limits of the joint; its torque, at what the controller
//                             knows of the joint, within those too. A frame that had to wait was right for
//                             what was known a millisecond before, so either will do
//   a joint outside           that enters its range: its set points move at most with half of `approach`
//   a frame that enables      a drive, while the emergency stop is pressed: never
//   an abduction target       only while the robot runs; within the range, and no faster than the axis may
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "in_memory.hpp"

namespace hil {

template <class Joints = joints>
class spy {
public:
  template <class Run>
  void look(Run& run) {
    const auto& robot = run.controller.template get<"robot.synchronizer">();
    const bool runs = run.controller.template get<"robot.emergency_stop">().mode() == hw::motion_mode::run &&
                      robot.phase() == hw::motion_phase::running;
    may_spread = runs || ran, spread_begins = !ran, ran = runs;
    approach = run.controller.template get<"robot.rate">().p.approach;
    for (int& n : since) ++n;
    for (std::size_t i = 0; i < Joints::count; ++i) before[i] = known[i];
    each([&]<class J>(std::type_identity<J>, std::size_t i) {
      known[i] = {J::angle_of(robot.report(i).position), J::speed_of(robot.report(i).velocity)};
    });
    std::array<hw::received_frame, 256> frames;
    for (std::size_t b = 0; b < buses; ++b) {
      auto end = run.wires[b].end(2);
      const std::size_t n = end.receive(frames);
      for (std::size_t k = 0; k < n; ++k) check(b, frames[k].frame, robot.board());
    }
  }
  std::int64_t sent = 0, outside = 0;
  bool pressed = false;  // the emergency stop, whatever the controller says

private:
  struct knowledge {
    double angle = std::nan(""), speed = std::nan("");
  };

  void check(std::size_t bus, const hw::can_frame& f, const hw::board_reading& reading) {
    each([&]<class J>(std::type_identity<J>, std::size_t i) {
      if (J::bus != bus) return;
      using drive = typename J::drive;
      if constexpr (requires { typename drive::wire; }) {
        if (f.id != drive::request_id) return;
        if (f == hw::mit_special_frame(f.id, hw::mit_special::enter)) return check_enable();
        if (f.data[0] == 0xFF && f.data[1] == 0xFF && f.data[2] == 0xFF) return;  // leaves, or clears a fault
        using format = typename drive::wire;
        check_set_point<J>(i, J::from_drive(format::from_wire(
                                  format::read(std::span<const std::uint8_t, 8>(f.data.data(), 8)))));
      } else {
        std::uint16_t word = 0;
        hw::drive_command c;
        if (!drive::hear(f, word, c)) return;
        if ((word & 0x07) == 0x07) check_enable();
        ++sent;
        outside += !within(J::from_drive(c).position, J::angle, 0.5) && (word & 0x0F) == 0x0F;
      }
    });
    std::array<double, 4> wanted = spread_to;
    if (bus == board::bus && board::abducted(f, wanted)) check_abduction(wanted, reading);
  }

  void check_enable() { outside += pressed; }

  void check_abduction(const std::array<double, 4>& wanted, const hw::board_reading& reading) {
    ++sent;
    using axis = robots::oncilla::left_front_abduction;
    constexpr double range = cca::detail::upper_limit_of<axis, cca::angle>,
                     step = 1e-3 * cca::detail::upper_limit_of<axis, cca::velocity> + 2e-4;
    bool good = may_spread;
    for (std::size_t k = 0; k < 4; ++k) {
      const double from = spread_begins ? reading.abduction[k] : spread_to[k];
      good = good && std::abs(wanted[k]) <= range + 1e-4 && std::abs(wanted[k] - from) <= step;
    }
    outside += !good;
    spread_to = wanted;
  }

  static bool within(double x, hw::joint_bounds b, double step) {
    return b.lower - step <= x && x <= b.upper + step;
  }

  template <class J>
  void check_set_point(std::size_t i, const hw::drive_command& c) {
    ++sent;
    constexpr double beyond = 0.5;  // rad: a start from farther outside is refused
    const bool follows = c.stiffness > 0.2;
    const knowledge& q = known[i];
    // `enters`: a joint that lay outside of its range when it started goes back into it, until the joint and
    // its set point are within.
    if (!follows) enters[i] = true;
    else if (J::angle.holds(c.position) && J::angle.holds(q.angle)) enters[i] = false;
    bool good = c.stiffness <= J::servo.most_stiff + 0.2 && c.damping <= 5.01;
    if (follows) good = good && within(c.position, J::angle, enters[i] ? beyond : 0.001);
    if (follows && enters[i] && !within(c.position, J::angle, 0.001) && since[i] < 10)
      good = good && std::abs(c.position - last[i]) <= 0.5e-3 * approach * since[i] + 0.001;
    if (follows) last[i] = c.position, since[i] = 0;
    if (c.damping > 0.01) good = good && within(c.velocity, J::speed, 0.02);
    outside += !(good && (is_torque_good<J>(c, q, follows, enters[i]) ||
                          is_torque_good<J>(c, before[i], follows, enters[i])));
  }
  template <class J>
  static bool is_torque_good(const hw::drive_command& c, const knowledge& q, bool follows, bool enters) {
    constexpr double steps = 0.1;  // N m, from the resolution of position, velocity and gains in a frame
    if (!std::isfinite(q.angle) || (!follows && c.damping <= 0.01)) return true;
    const double torque =
        c.stiffness * (c.position - q.angle) + c.damping * (c.velocity - q.speed) + c.torque;
    const bool brakes = enters && torque * q.speed < 0;
    return within(torque, brakes ? J::torque : hw::limit_guard<Joints>::window(place<J>, {q.angle, q.speed}),
                  steps);
  }

  template <class J, class... All>
  static constexpr std::size_t place_in(hw::joint_list<All...>) {
    std::size_t n = 0;
    bool found = false;
    ((found = found || std::is_same_v<J, All>, n += !found), ...);
    return n;
  }
  template <class J>
  static constexpr std::size_t place = place_in<J>(Joints());

  // f(type, number) for each joint.
  template <class F>
  static void each(F f) {
    [&]<class... J>(hw::joint_list<J...>) {
      std::size_t i = 0;
      (f(std::type_identity<J>(), i++), ...);
    }(Joints());
  }

  std::array<knowledge, Joints::count> known{}, before{};
  std::array<double, Joints::count> last{};  // the position that the drive was to follow last
  std::array<int, Joints::count> since = [] {
    std::array<int, Joints::count> long_ago;
    long_ago.fill(1000);
    return long_ago;
  }();
  std::array<bool, Joints::count> enters{};
  std::array<double, 4> spread_to{};
  double approach = 0;
  bool may_spread = false, spread_begins = true, ran = false;
};

}  // namespace hil
