#pragma once
// The spy of the fault campaign: a third node on each bus, which checks every frame that leads to motion.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "in_memory.hpp"

namespace hil {

// Checks every set-point on the buses, as a third node: those of the drives, and those of the abduction
// servos.
class spy {
public:
  template <class Run>
  void look(Run& run) {
    const bool runs =
        run.controller.template get<"robot.emergency_stop">().mode() == hw::motion_mode::run &&
        run.controller.template get<"robot.synchronizer">().phase() == hw::motion_phase::running;
    may_spread = runs || ran, spread_begins = !ran, ran = runs;
    std::array<hw::received_frame, 256> frames;
    for (std::size_t b = 0; b < buses; ++b) {
      auto end = run.wires[b].end(2);
      const std::size_t n = end.receive(frames);
      for (std::size_t k = 0; k < n; ++k)
        check(frames[k].frame, run.controller.template get<"robot.synchronizer">());
    }
  }
  std::int64_t sent = 0, outside = 0;

private:
  template <class Synchronizer>
  void check(const hw::can_frame& f, const Synchronizer& known) {
    std::size_t i = 0;
    const auto one = [&]<class J>(std::type_identity<J>) {
      using format = typename J::drive::wire;
      if (f.id == J::drive::request_id && !(f.data[0] == 0xFF && f.data[1] == 0xFF && f.data[2] == 0xFF)) {
        ++sent;
        const auto c = J::from_drive(
            format::from_wire(format::read(std::span<const std::uint8_t, 8>(f.data.data(), 8))));
        outside += !is_good<J>(c, J::angle_of(known.report(i).position),
                               J::speed_of(known.report(i).velocity), enters[i]);
      }
      ++i;
    };
    all(one, joints());
    std::array<double, 4> wanted = spread_to;
    if (!board::abducted(f, wanted)) return;
    ++sent;
    using axis = robots::oncilla::left_front_abduction;
    constexpr double range = cca::detail::upper_limit_of<axis, cca::angle>,
                     step = 1e-3 * cca::detail::upper_limit_of<axis, cca::velocity> + 2e-4;
    bool good = may_spread;
    for (std::size_t k = 0; k < 4; ++k) {
      const double from = spread_begins ? known.board().abduction[k] : spread_to[k];
      good = good && std::abs(wanted[k]) <= range + 1e-4 && std::abs(wanted[k] - from) <= step;
    }
    outside += !good;
    spread_to = wanted;
  }
  // `enters`: a joint that lay outside of its range when it started goes back into it.
  template <class J>
  static bool is_good(const hw::drive_command& c, double angle, double speed, bool& enters) {
    const auto within = [](double x, hw::joint_bounds b, double step) {
      return b.lower - step <= x && x <= b.upper + step;
    };
    constexpr double torque_steps =
        0.1;                        // N m, from the resolution of position, velocity and gains in a frame
    constexpr double beyond = 0.5;  // rad: a start from farther outside is refused
    const bool follows = c.stiffness > 0.2;
    if (!follows) enters = true;  // until the joint and its first set point are within the range
    else if (J::angle.holds(c.position) && J::angle.holds(angle)) enters = false;
    bool good = c.stiffness <= J::servo.most_stiff + 0.2 && c.damping <= 5.01;
    if (follows) good = good && within(c.position, J::angle, enters ? beyond : 0.001);
    if (c.damping > 0.01) good = good && within(c.velocity, J::speed, 0.02);
    if (!std::isfinite(angle) || (!follows && c.damping <= 0.01)) return good;
    const double torque = c.stiffness * (c.position - angle) + c.damping * (c.velocity - speed) + c.torque;
    const bool brakes = enters && torque * speed < 0;
    return good &&
           within(torque, brakes ? J::torque : hw::limit_guard<joints>::window(place<J>, {angle, speed}),
                  torque_steps);
  }
  template <class J, class... All>
  static constexpr std::size_t place_in(hw::joint_list<All...>) {
    std::size_t n = 0;
    bool found = false;
    ((found = found || std::is_same_v<J, All>, n += !found), ...);
    return n;
  }
  template <class J>
  static constexpr std::size_t place = place_in<J>(joints());

  template <class F, class... J>
  static void all(F& f, hw::joint_list<J...>) {
    (f(std::type_identity<J>()), ...);
  }
  std::array<bool, 8> enters{};
  std::array<double, 4> spread_to{};
  bool may_spread = false, spread_begins = true, ran = false;
};

}  // namespace hil
