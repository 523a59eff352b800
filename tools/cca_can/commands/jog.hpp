// cca-can jog: moves one joint slowly, within a range, a speed and a torque, and disables it at the end,
// however it ends.
//
// next_jog_command alone decides what goes to the drive. Its target speeds up and slows down within a quarter
// of a second, never exceeds the speed, and never leaves the range. It never gets further from the drive's
// position than half of the torque pulls. So a joint that is held gets half of the torque, and does not jump
// when it is released. The torque bounds what a command makes of the last reported position and speed:
//   drives that take gains       the drive gets gains, reduced where they would make more torque. Until the
//                                next command, 5 ms and an answer's way later, the drive's own law goes on: a
//                                joint that is pushed also meets stiffness times its way and damping times
//                                its change of speed (0.32 N m above 0.5 at 3 N m on 0.01 kg m^2). A moteus
//                                gets the bound too, and always keeps it
//   drives by torque             the law is computed here, and its torque cut at the bound. The drive makes
//                                no more, whatever happens meanwhile; nor does it damp what happens meanwhile
//   drives by position           the drive's own servo pulls, with its own largest torque (6072h), which must
//                                be set to no more
#pragma once

#include <algorithm>
#include <cmath>

#include "../console.hpp"
#include "../drives/talk.hpp"

namespace cca_can {

struct jog_limits {
  double low = 0, high = 0;  // rad, of the drive's output
  double speed = 0;          // rad/s
  double torque = 0;         // N m
  double stiffness = 0;      // N m/rad
  double damping = 0;        // N m s/rad
};

// The torque of the law, for drives that do not compute it.
inline hw::drive_command as_torque(const hw::drive_command& c,
                                   const jog_limits& l,
                                   const hw::drive_report& at) {
  const double v = at.velocity - at.velocity == 0 ? at.velocity : 0;
  const double law = c.stiffness * (c.position - at.position) + c.damping * (c.velocity - v);
  return {.torque = std::clamp(law, -l.torque, l.torque)};
}

struct jog_target {
  double position = 0, velocity = 0;
};

// `target` moves on with it. The torque is that of the law at the measured position and speed.
inline hw::drive_command next_jog_command(
    const jog_limits& l, double goal, const hw::drive_report& at, double dt, jog_target& target) {
  const double rise = l.speed / 0.25;  // rad/s^2
  const double way = std::clamp(goal, l.low, l.high) - target.position;
  // As fast as it can go and still stop at the goal.
  const double fastest = std::min({l.speed, std::sqrt(2 * rise * std::abs(way)), std::abs(way) / dt});
  const double wanted = std::copysign(fastest, way);
  const double speed = std::clamp(
      std::clamp(wanted, target.velocity - rise * dt, target.velocity + rise * dt), -l.speed, l.speed);
  const double next = std::abs(way) <= std::abs(speed) * dt && speed * way >= 0
                          ? target.position + way
                          : target.position + speed * dt;
  const double reach = 0.5 * l.torque / l.stiffness;
  const double kept = std::clamp(std::clamp(next, at.position - reach, at.position + reach), l.low, l.high);
  target.velocity = std::clamp((kept - target.position) / dt, -l.speed, l.speed);
  target.position = kept;

  hw::drive_command c{
      .position = kept, .velocity = target.velocity, .stiffness = l.stiffness, .damping = l.damping};
  const double v = at.velocity - at.velocity == 0 ? at.velocity : 0;
  const double law = c.stiffness * (c.position - at.position) + c.damping * (c.velocity - v);
  if (std::abs(law) > l.torque) {
    const double part = l.torque / std::abs(law);
    c.stiffness *= part;
    c.damping *= part;
  }
  return c;
}

inline constexpr double jog_slack = 0.05;  // rad beyond the range, for overshoot

inline double fastest(double speed) { return 2 * speed + 0.5; }  // rad/s, before it is disabled
// rad, the way between two reports: as fast, and as long as a drive may be silent.
inline double longest_way(double speed) { return fastest(speed) * 1e-9 * detail::silence; }

// Why its reports could not show in time that it leaves its range; empty: they can. Over the end of what it
// reports only a drive can go that gets torque alone, and is known to wrap there: the law of any other one
// meets a position that has jumped. So each other one must be disabled before it gets there, also if the last
// frame came as long ago as a drive may be silent.
inline trouble beyond_reports(const jog_limits& l, const any_drive& d) {
  if (!(d.wraps > 0)) return {};
  char text[300] = "";
  constexpr double silence = 1e-9 * detail::silence, as_printed = 5e-5;  // rad: the text has four digits
  const double end = d.wraps / 2, way = longest_way(l.speed), within = std::max(0.0, end - jog_slack - way);
  if (!(way < end))
    std::snprintf(text, sizeof text,
                  "its position begins again after %.4f rad, and it can turn by half of that in the %.1f s "
                  "that it may be silent: state less than %.3f rad/s",
                  d.wraps, silence, std::max(0.0, (end / silence - 0.5) / 2));
  else if ((d.may_stay || !d.takes_torque_alone()) &&
           !(l.low >= -within - as_printed && l.high <= within + as_printed))
    std::snprintf(
        text, sizeof text,
        "the positions that it reports end at %.4f and %.4f rad, where they stay or begin again: at "
        "%.3f rad/s state a range within %.4f to %.4f rad",
        -end, end, l.speed, -within, within);
  return text;
}

// Why the drive must be disabled; empty: all is well.
inline trouble beyond_limits(const jog_limits& l, const hw::drive_report& at) {
  if (!(at.position >= l.low - jog_slack && at.position <= l.high + jog_slack))
    return "it left its range: " + std::to_string(at.position) + " rad";
  if (std::abs(at.velocity) > fastest(l.speed))
    return "it is faster than twice the speed: " + std::to_string(at.velocity) + " rad/s";
  return {};
}

struct jog_order {
  jog_limits limits{};
  double goal = 0;
  bool relative = false;  // from its present position
  double hold = 0.5;      // s, at the goal
};

template <hw::CanBus Bus>
ending jog(Bus& bus, const std::string& name, any_drive& drive, jog_order o, pace& time, console& say) {
  const jog_limits& l = o.limits;
  char what[400];
  std::snprintf(
      what, sizeof what,
      "jog %s (%s) on %s %s %.4f rad, within %.4f to %.4f rad, at most at %.3f rad/s and with %.3f N m\n"
      "Nobody within reach, the joint free to move, the switch of its supply in your hand.",
      drive.text.c_str(), drive.family.c_str(), name.c_str(), o.relative ? "by" : "to", o.goal, l.low, l.high,
      l.speed, l.torque);
  if (!say.confirmed(what)) return not_confirmed;

  talk t(bus, drive, time, 5 * ms);
  trouble wrong = beyond_reports(l, drive);
  if (wrong.empty()) wrong = t.ask_position();
  const double start = t.report().position;
  if (o.relative) o.goal += start;
  if (wrong.empty()) wrong = t.ask_settings(l.torque);
  if (wrong.empty() && !(start >= l.low && start <= l.high))
    wrong = "it is at " + std::to_string(start) +
            " rad, outside of the range: turn it by hand, or give another range";
  if (wrong.empty() && !(o.goal >= l.low && o.goal <= l.high))
    wrong = "the goal, " + std::to_string(o.goal) + " rad, is outside of the range";
  if (!wrong.empty()) {
    say.error << "cca-can: " << drive.text << " on " << name << ": " << wrong << '\n';
    return time.end_wanted() ? interrupted : failed;
  }

  const auto order = [&](const hw::drive_command& c) {
    return t.set_point(drive.takes_torque_alone() ? as_torque(c, l, t.report()) : c, l.torque);
  };
  wrong = t.enable();
  jog_target target{.position = t.report().position};
  double last = target.position;
  const double way = std::abs(o.goal - target.position);
  const std::int64_t from = time.now();
  const std::int64_t longest = from + static_cast<std::int64_t>((2 * way / l.speed + 3) * 1e9);
  std::int64_t shown = from, arrived = 0;
  bool there = false;
  while (wrong.empty() && !(there && time.now() - arrived > static_cast<std::int64_t>(o.hold * 1e9))) {
    if (time.now() >= shown) {
      say.out << drive.text << "  " << text_of(t.report()) << '\n' << std::flush;
      shown += 100 * ms;
    }
    const hw::set_point_frames s = order(next_jog_command(l, o.goal, t.report(), t.seconds(), target));
    if (!s.finite) wrong = "it reports numbers that are not finite";
    else wrong = t.cycle(s.frames);
    if (wrong.empty()) wrong = beyond_limits(l, t.report());
    if (wrong.empty() && !(std::abs(t.report().position - last) <= jog_slack + longest_way(l.speed)))
      wrong = "its position jumped, from " + std::to_string(last) + " to " +
              std::to_string(t.report().position) +
              " rad: does it begin again after a range, which cca-can does not know of this family?";
    last = t.report().position;
    if (!there && target.position == o.goal) there = true, arrived = time.now();
    if (!there && time.now() > longest)
      wrong = "it does not get there: something holds it, or the torque is too small";
  }
  // Gently, while it still listens: 0.2 s of damping alone.
  for (int i = 0; i < 40 && (wrong.empty() || time.end_wanted()); ++i) {
    const double damping = std::min(l.damping, 0.5 * l.torque / std::max(0.1, std::abs(t.report().velocity)));
    const trouble now = t.cycle(order({.position = t.report().position, .damping = damping}).frames);
    if (!now.empty() && !time.end_wanted()) wrong = now;
  }
  const std::string at_last = text_of(t.report());
  const bool answered = t.disable();
  say.out << drive.text << "  " << at_last << '\n'
          << drive.text << (answered ? "  disabled\n" : "  told to disable, and does not answer\n");
  if (wrong.empty()) return done;
  say.error << "cca-can: " << drive.text << " on " << name << ": " << wrong << '\n';
  return time.end_wanted() ? interrupted : failed;
}

}  // namespace cca_can
