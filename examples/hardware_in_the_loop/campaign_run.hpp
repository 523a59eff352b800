#pragma once
// One run of the fault campaign: the trot on virtual drives, a fault after 1.5 s, the robot's reaction, and a
// restart by the operator.
//
// The controller runs at the real pace (`cca::clocked_pace`), on the clock of the simulated robot: a beat
// that takes too long is an overrun, the periods that it takes are lost, and none is caught up.
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <cca/runtime/interruption.hpp>

#include "campaign.hpp"

namespace hil {

template <class Architecture>
class campaign_run {
public:
  explicit campaign_run(const scenario<Architecture>& what)
      : s(what), script(script_of(what)), r(script, true, early), pace(1, robot_clock{this}) {
    if (s.fault_after > 0) pace.fault_after(s.fault_after);
    found.fault = s.fault;
    found.expected_lost_beats = s.lost_beats();
  }
  campaign_run(const campaign_run&) = delete;
  campaign_run& operator=(const campaign_run&) = delete;

  result go() {
    start();
    {
      std::optional<cca::interruption> interrupted;  // as every program has it
      if (s.signal != 0) interrupted.emplace();
      const auto is_interrupted = [&] { return interrupted && *interrupted; };
      r.controller.run(cca::without_end(), pace, [&](auto&) { return goes_on() && !is_interrupted(); });
      if (is_interrupted()) r.controller.stop();
    }
    found.lost_beats = r.controller.lost_periods();
    // The run has ended: by a fault, by the program, or because the program is gone.
    while (k < end) {
      pass();
      if (!s.killed && k < end) r.controller.step();
    }
    judge();
    restart();
    r.controller.run(cca::for_some_beats{timing::restarted}, pace);
    if (refused()) {
      r.controller.stop();
      r.put_down(put_down(), {});
      r.controller.start();
      r.controller.run(cca::for_some_beats{timing::restarted}, pace);
    }
    found.recovered =
        stop().mode() == hw::motion_mode::run && !r.controller.template get<"robot.rate">().approaching();
    if (!found.recovered && found.first_cause.empty())
      found.first_cause = std::string(hw::name_of(stop().first_cause().rule));
    found.sent = watcher.sent;
    found.sent_outside_limits = watcher.outside;
    return found;
  }

private:
  // Time passes while the controller waits, and in a component that takes long.
  struct robot_clock {
    campaign_run* run;
    std::int64_t now() const { return run->r.now + run->still_works; }
    void sleep_until(std::int64_t time) const {
      run->still_works = 0;
      while (now() < time) run->pass();
    }
  };

  static std::vector<hw::bus_fault> script_of(const scenario<Architecture>& s) {
    std::vector<hw::bus_fault> script;
    for (hw::bus_fault f : s.script) {
      f.from = begin * 1'000'000, f.until = (begin + s.beats) * 1'000'000;
      script.push_back(f);
      if (f.end != hw::every_end) continue;
      script.back().end = 0;  // for robot and drives, not for the spy
      f.end = 1;
      script.push_back(f);
    }
    return script;
  }

  auto& stop() { return button(r); }

  void start() {
    r.controller.load();
    r.controller.start();
    if (s.long_beat > 0)
      saboteur_of(r).works = [this] {
        if (k != begin && !(s.every_beat_is_long && k > begin && k < begin + s.beats)) return;
        for (std::int64_t i = 0; i < s.long_beat; ++i) pass();
        still_works = 1;
      };
  }

  // Between two beats.
  bool goes_on() {
    const bool next_is_fault = k + 1 == begin;
    if (next_is_fault && s.stands_still > 0)
      for (std::int64_t i = 0; i <= s.stands_still; ++i) pass();
    return k + 1 < end && !(next_is_fault && (s.killed || s.stops));  // a signal ends the run by itself
  }

  // A millisecond of the robot, then the fault of the next one.
  void pass() {
    r.pass_millisecond();
    watcher.look(r);
    if (k < end) note();
    ++k;
    const std::int64_t since = k - begin;
    if (since == 0 && s.stops) r.controller.stop();
    if (since == 0 && s.signal != 0) std::raise(s.signal);
    watcher.pressed = s.pressed && since >= 0 && since < s.beats;
    if (since >= 0 && since < s.beats && s.each) s.each(r, since);
    if (since == s.beats && s.mend) s.mend(r);
  }

  void finds(const char* who) {
    if (detected >= 0) return;
    detected = k;
    found.detected_by = who;
  }
  // What has happened in this millisecond.
  void note() {
    if (k >= begin) note_cause();
    bool moving = false, unfed = true;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& c = r.laws[i];
      moving = moving || std::abs(c.velocity) > 0.03 ||
               (c.stiffness > 0.2 && std::abs(c.position - former[i].position) > 0.002);
      unfed = unfed && c.stiffness == 0 && c.damping == 0;
    }
    former = r.laws;
    if (unfed && k >= begin) finds("drives' watchdog");
    if (k >= begin) note_stop();
    if (detected < 0 || k <= detected) where = positions(r);
    if (k < begin) return;
    if (moving) last_moving = k;
    gone.push_back(positions(r));
    const auto q = r.plant.motions();
    for (std::size_t i = 0; i < 8; ++i) {
      found.max_excursion = std::max(found.max_excursion, std::abs(q[i].position - where[i]));
      found.max_torque = std::max(found.max_torque, std::abs(q[i].torque));
    }
  }
  void note_cause() {
    if (!found.first_cause.empty() || s.killed) return;
    const cca::state is = r.controller.state();
    if (is != cca::state::started && is != cca::state::running) {
      finds("controller");
      found.first_cause = s.signal != 0                       ? name_of(s.signal)
                          : !r.controller.fault()             ? "stop()"
                          : r.controller.fault_path().empty() ? "overruns in a row"
                                                              : "a component's fault";
    } else if (stop().mode() != hw::motion_mode::run) {
      finds("controller");
      const hw::safety_event cause = stop().first_cause();
      found.first_cause = std::string(hw::name_of(cause.rule));
      if (cause.joint >= 0)
        found.first_cause += ", " + std::string(joints::names[static_cast<std::size_t>(cause.joint)]);
    }
  }

  static std::string name_of(int signal) { return signal == SIGINT ? "SIGINT" : "SIGTERM"; }

  // How long all drives are on and follow nothing. A knee that moves against its cable is not even damped.
  void note_stop() {
    bool on = true;
    std::apply([&](const auto&... d) { on = (d.enabled() && ...); }, r.far.drives);
    damped += on && std::all_of(r.laws.begin(), r.laws.end(), [](const auto& c) { return c.stiffness == 0; });
  }
  // stop(), and a signal: the drives damp, then they are switched off, and each has confirmed.
  void judge_stop() {
    constexpr std::int64_t expected = hw::stop_sequence<8>::damping_beats;
    const auto& robot = synchronizer(r);
    bool confirmed = !robot.stopping();
    for (std::size_t i = 0; i < 8; ++i) confirmed = confirmed && !robot.unconfirmed(i);
    std::apply([&](const auto&... d) { confirmed = confirmed && !(d.enabled() || ...); }, r.far.drives);
    if (!confirmed) found.unexpected = "a drive has not confirmed that it is off; ";
    if (std::abs(damped - expected) > 3)
      found.unexpected +=
          "damps for " + std::to_string(damped) + " ms, not " + std::to_string(expected) + "; ";
  }

  void judge() {
    if (s.is_whole_stop()) judge_stop();
    if (detected >= 0) {
      found.beats_to_detect = detected - begin;
      found.beats_to_safe = std::max<std::int64_t>(0, last_moving + 1 - detected);
    } else {
      found.max_excursion = farthest(gone, undisturbed<Architecture>());
    }
    found.fell = r.plant.world.fallen();
  }

  // By the operator.
  void restart() {
    if (s.killed) {
      r.restart_program();
      r.controller.load();
      r.controller.start();
    } else if (detected >= 0) {
      if (r.controller.state() != cca::state::loaded) r.controller.stop();
      r.controller.start();
    }
  }

  // A leg of the sunken robot is outside of its range, or still swings. The operator then sets it on its feet
  // by hand.
  bool refused() {
    const hw::safety_rule why = synchronizer(r).refusal();
    return why == hw::safety_rule::range || why == hw::safety_rule::rate;
  }

  static constexpr std::int64_t begin = timing::begin;
  const scenario<Architecture>& s;
  const std::vector<hw::bus_fault> script;  // the buses read it
  in_memory<Architecture> r;
  cca::clocked_pace<robot_clock> pace;
  const std::int64_t end = begin + s.beats + timing::after;
  std::int64_t k = 0;            // the millisecond
  std::int64_t still_works = 0;  // ns: a beat that ends after the next one should have begun
  result found{};
  spy<> watcher{};
  std::int64_t last_moving = -1, detected = -1, damped = 0;
  std::array<double, 8> where{};
  std::array<hw::drive_command, 8> former = r.laws;
  path gone{};
};

template <class Architecture>
result run(const scenario<Architecture>& s) {
  return campaign_run<Architecture>(s).go();
}

}  // namespace hil
