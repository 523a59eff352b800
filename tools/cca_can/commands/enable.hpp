// cca-can enable: enables a drive at its present position, watches it, and disables it at the end.
#pragma once

#include "../console.hpp"
#include "../drives/talk.hpp"

namespace cca_can {

// 0 s: until ctrl-c.
template <hw::CanBus Bus>
ending enable(Bus& bus, const std::string& name, any_drive& drive, double seconds, pace& time, console& say) {
  if (!say.confirmed("enable " + drive.text + " (" + drive.family + ") on " + name +
                     (drive.takes_gains() || drive.takes_torque_alone()
                          ? ": without stiffness and torque"
                          : ": it holds its position with all its torque") +
                     ", until it is disabled at the end"))
    return not_confirmed;
  talk t(bus, drive, time, 5 * ms);
  trouble wrong = t.ask_position();
  if (wrong.empty()) wrong = t.ask_settings(0);
  if (wrong.empty()) wrong = t.enable();
  const double where = t.report().position;
  const std::int64_t from = time.now();
  std::int64_t shown = from;
  while (wrong.empty() && (seconds == 0 || static_cast<double>(time.now() - from) < seconds * 1e9)) {
    if (time.now() >= shown) {
      say.out << drive.text << "  " << text_of(t.report()) << '\n' << std::flush;
      shown += 500 * ms;
    }
    wrong = t.cycle(t.set_point({.position = where}, 0).frames);
  }
  const bool answered = t.disable();
  say.out << drive.text << (answered ? "  disabled\n" : "  told to disable, and does not answer\n");
  if (wrong.empty() || (time.end_wanted() && seconds == 0 && answered)) return done;
  say.error << "cca-can: " << drive.text << " on " << name << ": " << wrong << '\n';
  return time.end_wanted() ? interrupted : failed;
}

}  // namespace cca_can
