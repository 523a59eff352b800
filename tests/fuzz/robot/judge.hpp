// Judges every frame that a robot's controller sends: what may never go out, whatever happens.
//
//   closed   the emergency stop is pressed, or the controller is stopped, faulted or not started: no frame
//            moves anything, none enables a drive, no abduction servo moves. A drive that takes torque alone,
//            and has said that it is enabled, may get torque that brakes
//   limits   numbers are finite. A position that a drive shall follow is within the range of its axis. Only
//            a motion that begins outside may be there: it never leads farther out, and it comes in no faster
//            than `approach`; a soft stop holds it there. The torque of a drive that takes it, at the
//            measured angle and speed, is within the limits of the axis
//   speed    the first position of a motion is where the joint is measured; from then on it moves at most as
//            fast as the axis may, in each beat of 1 ms. Not judged in a soft stop, which holds the position
//            that was measured when it began
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <cca/hardware/oncilla.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/odrive.hpp>
#include <cca/hardware/robstride.hpp>
#include <cca/hardware/cia402.hpp>

namespace fuzz {

namespace hw = cca::hardware;

// What a frame asks of a drive.
struct request {
  hw::drive_command command{};
  bool enables = false, follows = false;  // follows: the drive is to follow `command`
  bool brakes = false;                    // it gets no position
};

// Of which family a drive is: by a member that only this family has.
template <class D> concept is_mit = requires { typename D::wire; };
template <class D> concept is_moteus = requires { typename D::request; };
template <class D> concept is_odrive = requires { D::by_velocity; };
template <class D> concept is_robstride = requires { D::run_mode(0); };
template <class D> concept is_cia402 = requires { D::sends_velocity; };

template <class D>
std::optional<request> read(const hw::can_frame& f) {
  request r;
  hw::drive_command& c = r.command;
  if constexpr (is_mit<D>) {
    if (f.id != D::request_id) return {};
    using special = hw::mit_special;
    if (f == hw::mit_special_frame(D::request_id, special::enter)) return request{.enables = true};
    for (const special what : {special::leave, special::clear_fault, special::set_zero})
      if (f == hw::mit_special_frame(D::request_id, what)) return request{};
    c = D::wire::from_wire(D::wire::read(std::span<const std::uint8_t, 8>(f.data.data(), 8)));
    r.follows = c.stiffness > 0 || std::abs(c.torque) > 0.05;
  } else if constexpr (is_moteus<D>) {
    typename D::request q;
    if (!D::hear(f, q)) return {};
    r.enables = q.mode == 10;
    r.brakes = !r.enables;
    r.follows = r.enables && q.command.position == q.command.position;  // NaN: stay where you are
    c = q.command;
    c.stiffness *= D::motor::stiffness, c.damping *= D::motor::damping;
  } else if constexpr (is_odrive<D>) {
    r.enables = f == D::axis_state(8);
    r.follows = D::hear(f, c);
    if (!r.enables && !r.follows) return {};
  } else if constexpr (is_robstride<D>) {
    r.enables = f == D::enable();
    if (D::hear(f, c)) r.follows = c.stiffness > 0 || std::abs(c.torque) > 0.05;
    else if (std::ranges::none_of(D::requests, [&](const hw::can_filter& own) { return own.matches(f.id); }))
      return {};
  } else {
    static_assert(is_cia402<D>, "fuzz::read: teach it the frames of this family");
    std::uint16_t word = 0;
    if (!D::hear(f, word, c)) return {};
    r.enables = (word & 0x87) == 0x07;
    r.follows = (word & 0x8F) == 0x0F;
  }
  return r;
}

template <class Joints, class Board>
class judge {
public:
  std::uint64_t frames = 0, motions_from_outside = 0;
  std::string verdict{};  // the first frame that should not have been sent

  // In each beat that takes place, before its frames. `running`: the robot moves by the controller's set
  // points. `approach`: the parameter of the rate guard, rad/s.
  void begin_beat(bool closed, bool running, bool enabling, hw::motion_mode mode, double approach) {
    now_closed = closed;
    if (!running) known = {}, since = {};
    for (double& way : may_come_in) way += 0.5 * approach * 1e-3;  // outside it moves with half of it
    for (int& beats : since) ++beats;
    now_running = running, now_enabling = enabling, follows_commands = mode == hw::motion_mode::run;
  }

  // `measured`: angle and speed of each joint, as the controller knows them.
  template <class Synchronizer>
  void look(std::size_t bus,
            const hw::can_frame& f,
            const Synchronizer& robot,
            const std::array<double, 8>& offset) {
    ++frames;
    std::array<double, 4> targets = spread;
    if (bus == Board::bus && Board::abducted(f, targets)) return judge_servos(targets);
    std::size_t i = 0;
    each([&]<class J>(std::type_identity<J>) {
      if (J::bus == bus)
        if (const auto r = read<typename J::drive>(f)) judge_drive<J>(i, *r, robot.report(i), offset[i]);
      ++i;
    });
  }

private:
  void fail(std::string_view joint, const char* what, const hw::drive_command& c = {}, double angle = 0) {
    if (!verdict.empty()) return;
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, " (%.4f rad, %.3f rad/s, %.3f N m, %.2f, %.2f; it is at %.4f rad)",
                  c.position, c.velocity, c.torque, c.stiffness, c.damping, angle);
    verdict = std::string(joint) + ": " + what + numbers;
  }
  template <class F>
  static void each(F f) {
    [&]<class... J>(std::type_identity<hw::joint_list<J...>>) {
      (f(std::type_identity<J>()), ...);
    }(std::type_identity<Joints>());
  }

  void judge_servos(const std::array<double, 4>& targets) {
    if (now_closed || !now_running) fail("abduction", "a target goes out while nothing may move");
    for (std::size_t k = 0; k < targets.size(); ++k)
      if (!(std::abs(targets[k]) <= 0.5)) fail("abduction", "a target is outside of every range");
    spread = targets;
  }

  template <class J>
  void judge_drive(std::size_t i, const request& r, const hw::drive_report& report, double offset) {
    using D = typename J::drive;
    constexpr bool by_position = (D::uses & hw::of_position) != 0,
                   by_stiffness = (D::uses & hw::of_stiffness) != 0,
                   by_torque = !by_position && !by_stiffness && (D::uses & hw::of_velocity) == 0;
    const auto& name = J::axis::name;
    const hw::drive_command c = J::from_drive(r.command);
    const bool is_braked = by_torque && report.activity == hw::drive_activity::enabled &&
                           (c.torque * J::speed_of(report.velocity) <= 0 || std::abs(c.torque) < 0.05);
    if (now_closed && is_braked) return;
    if (now_closed && (r.follows || r.enables)) return fail(name, "moves or is enabled while nothing may");
    if (!r.follows) {  // it gives way; a position that it gets meanwhile goes on, or else the next one begins
      since[i] = 0;
      if (now_running && by_stiffness)
        known[i] = c.position, gave_way[i] = c.position != c.position || r.brakes;
      return;
    }
    for (const double x : {c.position, c.velocity, c.torque, c.stiffness, c.damping})
      if (!std::isfinite(x)) return fail(name, "a number is not finite");
    if (!now_running) {  // a drive that is being enabled holds where it is
      if (!now_enabling) fail(name, "follows before motion has begun");
      return;
    }
    const double angle = J::angle_of(report.position), speed = J::speed_of(report.velocity);
    const double step = J::speed.upper * 1e-3 + 2e-3;  // the resolution of a frame, and of the measured angle
    if constexpr (by_position) {
      const double from = known[i].value_or(angle);
      const bool is_stiff = !by_stiffness || c.stiffness > 0.2, holds = std::abs(c.position - angle) <= step;
      if (follows_commands && is_stiff && !holds && !gave_way[i] &&
          !(std::abs(c.position - from) <= step * since[i]))
        fail(name, "a position jumps", c, angle);
      const hw::joint_bounds range{J::angle.lower - offset, J::angle.upper - offset};
      const bool begins = !known[i] || gave_way[i];
      known[i] = c.position;
      since[i] = 0;
      gave_way[i] = false;
      judge_range(name, i, range, begins && holds, is_stiff, c, angle);
    }
    if constexpr (by_stiffness || !by_position) {
      const double law =
          by_stiffness ? c.stiffness * (c.position - angle) + c.damping * (c.velocity - speed) + c.torque
                       : c.torque;
      const double slack = 0.1 + 0.02 * (J::torque.upper - J::torque.lower);
      if (!(J::torque.lower - slack <= law && law <= J::torque.upper + slack))
        fail(name, "more torque than it may have", c, angle);
    }
  }

  // Rounded by frames and by what is measured: 2 mrad.
  void judge_range(std::string_view name,
                   std::size_t i,
                   hw::joint_bounds range,
                   bool begins,
                   bool is_stiff,
                   const hw::drive_command& c,
                   double angle) {
    constexpr double rounding = 2e-3, far = 0.05;  // far: the joint moves on while no frame gets through
    if (!follows_commands && outside[i] && is_stiff &&
        !hw::joint_bounds{std::min(*outside[i], angle) - far, std::max(*outside[i], angle) + far}.holds(
            c.position))
      fail(name, "a soft stop outside of the range does not hold the joint where it is", c, angle);
    if (range.holds(c.position)) {
      outside[i].reset();
      return;
    }
    if (!follows_commands) {  // a soft stop: where the joint is, or on its way from there
      if (is_stiff && !hw::joint_bounds{std::min(range.lower, angle) - 2 * rounding,
                                        std::max(range.upper, angle) + 2 * rounding}
                           .holds(c.position))
        fail(name, "a soft stop leads farther out", c, angle);
      outside[i] = came_from[i] = c.position, may_come_in[i] = 0;
      return;
    }
    if (begins) outside[i] = came_from[i] = c.position, may_come_in[i] = 0, ++motions_from_outside;
    const double reached = outside[i].value_or(range.nearest(c.position));
    if (is_stiff && !hw::joint_bounds{std::min(range.lower, reached) - rounding,
                                      std::max(range.upper, reached) + rounding}
                         .holds(c.position))
      fail(name, outside[i] ? "a position leads farther out" : "a position is outside of the range", c,
           angle);
    if (outside[i] && is_stiff && !(std::abs(c.position - came_from[i]) <= may_come_in[i] + 2 * rounding))
      fail(name, "a joint comes into its range faster than `approach`", c, angle);
    if (outside[i]) outside[i] = c.position;
  }

  std::array<std::optional<double>, 8> known{};  // the last position that a drive was to follow
  std::array<int, 8> since{};                    // and how many beats ago that was: a frame may be dropped
  std::array<bool, 8> gave_way{};
  // Of a motion that began outside of its range: its last position, until that is within; where it began; how
  // far it may have come since.
  std::array<std::optional<double>, 8> outside{};
  std::array<double, 8> came_from{}, may_come_in{};
  std::array<double, 4> spread{};
  bool follows_commands = false, now_closed = true, now_running = false, now_enabling = false;
};

}  // namespace fuzz
