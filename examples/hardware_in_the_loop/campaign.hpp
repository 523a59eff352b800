#pragma once
// One run of the fault campaign: the trot on virtual drives, a fault after 1.5 s, the robot's reaction, and a
// restart by the operator.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "spy.hpp"

namespace hil {

// Faults in the controller: commands that are not numbers, commands that are made of the same old data again
// and again, and a component that gives up.
struct saboteur {
  auto process(cca::in<"angles", robots::oncilla::leg_angles> wanted)
      -> std::tuple<cca::out<"angles", robots::oncilla::leg_angles>, cca::fault> {
    if (!stuck) origin = wanted.origin(), angles = wanted.vector();
    cca::out<"angles", robots::oncilla::leg_angles> result = angles;
    if (not_a_number) result[robots::oncilla::left_hind_hip{}] = std::nan("");
    result = result.with_origin(origin);
    return {result, gives_up ? cca::fault("it gives up") : cca::fault()};
  }
  bool not_a_number = false, stuck = false, gives_up = false;

private:
  robots::oncilla::leg_angles::vector_type angles = robots::oncilla::leg_angles::vector_type::Zero();
  std::int64_t origin = cca::never;
};

// The target of the abduction servos: 0, as in the trot, until a fault changes it.
struct spread {
  auto process() -> cca::out<"angles", robots::oncilla::abduction_angles> {
    return robots::oncilla::abduction_angles::vector_type::Constant(target);
  }
  double target = 0;
};

template <class Limiter>
struct sabotaged : cca::graph<cca::rate<1000>,
                              cca::node<"throttle", trot::throttle, cca::timed<10>>,
                              cca::node<"posture", trot::posture, cca::timed<10>>,
                              cca::node<"cpg", trot::stride_oscillator, cca::timed<1>>,
                              cca::node<"gait", trot::gait, cca::port_triggered<"phase">>,
                              cca::node<"saboteur", saboteur>,
                              cca::node<"limits", Limiter>,
                              cca::node<"spread", spread>,
                              cca::node<"spread_limits", cca::limiter<robots::oncilla::abduction_angles>>,
                              cca::node<"robot", oncilla<memory_end>>,

                              cca::wire<"robot.orientation", "posture.orientation", cca::latest>,
                              cca::wire<"throttle.amplitude", "cpg.amplitude", cca::latest>,
                              cca::wire<"posture.turn", "gait.turn", cca::latest>,
                              cca::wire<"posture.lean", "gait.lean", cca::latest>,
                              cca::wire<"cpg.phase", "gait.phase">,
                              cca::wire<"cpg.amplitude", "gait.amplitude">,
                              cca::wire<"gait.angles", "saboteur.angles">,
                              cca::wire<"saboteur.angles", "limits.command">,
                              cca::wire<"limits.safe", "robot.command">,
                              cca::wire<"spread.angles", "spread_limits.command">,
                              cca::wire<"spread_limits.safe", "robot.abduction">> {};

// With the limiter of every architecture, and with the limiter switched off.
struct limited : sabotaged<cca::limiter<robots::oncilla::leg_angles>> {};
struct unlimited : sabotaged<cca::unlimited<robots::oncilla::leg_angles>> {};

template <class Architecture>
struct scenario {
  using run_type = in_memory<Architecture>;
  std::string fault;
  std::int64_t beats = 200;             // the fault's duration
  std::vector<hw::bus_fault> script{};  // from the fault's beginning on
  std::function<void(run_type&, std::int64_t)> each =
      {};                                    // called in each of its beats, with their number from 0 on
  std::function<void(run_type&)> mend = {};  // ends the fault
  std::function<bool(std::int64_t)> controller_runs = {};  // in each of its beats; empty: always
  bool killed = false;                                     // the program is killed and started again
};

struct result {
  std::string fault, first_cause;
  std::int64_t beats_to_detect = -1;  // -1: it needed no reaction
  std::int64_t beats_to_safe = 0;     // after the detection
  std::string detected_by = "-";
  double max_excursion =
      0;  // rad, from the position at the detection; without one, from a run without the fault
  double max_torque = 0;
  std::int64_t sent = 0, sent_outside_limits = 0;
  bool recovered = false, fell = false;
  bool good() const { return recovered && sent_outside_limits == 0 && beats_to_safe <= 3; }
};

struct timing {  // in beats: before a fault, after it, of the longest fault, after the restart
  static constexpr std::int64_t begin = 1500, after = 700, longest = 1000, restarted = 2500;
};

// The time in a beat at which the far end answers, ns: early, so that the abduction targets of the next beat
// don't destroy a frame of the sensor board that still waits (on_drives.hpp).
inline constexpr std::int64_t early = 300'000;

// The positions of the joints from the beginning of the fault on. `undisturbed`: without a fault.
using path = std::vector<std::array<double, 8>>;
template <class Architecture>
std::array<double, 8> positions(const in_memory<Architecture>& r) {
  std::array<double, 8> all{};
  const auto joints_now = r.robot.joints();
  for (std::size_t i = 0; i < 8; ++i) all[i] = joints_now[i].position;
  return all;
}
template <class Architecture>
const path& undisturbed() {
  static const path all = [] {
    in_memory<Architecture> r({}, true, early);
    r.controller.load();
    r.controller.start();
    path w;
    for (std::int64_t k = 0; k < timing::begin + timing::longest + timing::after; ++k) {
      r.step();
      if (k >= timing::begin) w.push_back(positions(r));
    }
    return w;
  }();
  return all;
}
inline double farthest(const path& a, const path& b) {
  double most = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    for (std::size_t i = 0; i < 8; ++i) most = std::max(most, std::abs(a[k][i] - b[k][i]));
  return most;
}

template <class Architecture>
result run(const scenario<Architecture>& s) {
  constexpr std::int64_t begin = timing::begin, after = timing::after, restarted = timing::restarted;
  std::vector<hw::bus_fault> script;
  for (hw::bus_fault f : s.script) {
    f.from = begin * 1'000'000, f.until = (begin + s.beats) * 1'000'000;
    script.push_back(f);
    if (f.end != hw::every_end) continue;
    script.back().end = 0;  // for robot and drives, not for the spy
    f.end = 1;
    script.push_back(f);
  }
  in_memory<Architecture> r(script, true, early);
  r.controller.load();
  r.controller.start();
  auto& stop = r.controller.template get<"robot.emergency_stop">();
  spy watcher;

  result found;
  found.fault = s.fault;
  std::int64_t last_moving = -1, detected = -1;
  std::array<double, 8> where{};
  auto former = r.laws;
  path gone;
  const auto note = [&](std::int64_t k) {
    watcher.look(r);
    const auto q = r.robot.joints();
    const auto finds = [&](const char* who) {
      if (detected >= 0) return;
      detected = k;
      found.detected_by = who;
    };
    if (found.first_cause.empty() && r.controller.state() != cca::state::started && k >= begin && !s.killed) {
      finds("controller");
      found.first_cause = r.controller.fault() ? "a component's fault" : "stop()";
    }
    if (found.first_cause.empty() && stop.mode() != hw::motion_mode::run && k >= begin) {
      finds("controller");
      found.first_cause = std::string(hw::name_of(stop.first_cause().rule));
      if (const int j = stop.first_cause().joint; j >= 0)
        found.first_cause += ", " + std::string(joints::names[static_cast<std::size_t>(j)]);
    }
    bool moving = false, unfed = true;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& c = r.laws[i];
      moving = moving || std::abs(c.velocity) > 0.03 ||
               (c.stiffness > 0.2 && std::abs(c.position - former[i].position) > 0.002);
      unfed = unfed && c.stiffness == 0 && c.damping == 0;
    }
    former = r.laws;
    if (moving && k >= begin) last_moving = k;
    if (unfed && k >= begin) finds("drives' watchdog");
    if (k < begin) {
      for (std::size_t i = 0; i < 8; ++i) where[i] = q[i].position;
    } else {
      gone.push_back(positions(r));
      for (std::size_t i = 0; i < 8; ++i) {
        if (detected < 0 || k <= detected) where[i] = q[i].position;
        found.max_excursion = std::max(found.max_excursion, std::abs(q[i].position - where[i]));
        found.max_torque = std::max(found.max_torque, std::abs(q[i].torque));
      }
    }
  };

  std::int64_t k = 0;
  for (; k < begin; ++k) r.step(), note(k);
  for (; k < begin + s.beats + after; ++k) {
    const std::int64_t since = k - begin;
    const bool during = since < s.beats;
    if (during && s.each) s.each(r, since);
    if (since == s.beats && s.mend) s.mend(r);
    r.step(!(s.killed || (during && s.controller_runs && !s.controller_runs(since))));
    note(k);
  }

  const bool tripped = detected >= 0;
  if (tripped) {
    found.beats_to_detect = detected - begin;
    found.beats_to_safe = std::max<std::int64_t>(0, last_moving + 1 - detected);
  } else {
    found.max_excursion = farthest(gone, undisturbed<Architecture>());
  }
  found.fell = r.robot.world.fallen();

  // The restart by the operator.
  if (s.killed) {
    r.restart_program();
    r.controller.load();
    r.controller.start();
  } else if (tripped) {
    if (r.controller.state() != cca::state::loaded) r.controller.stop();
    r.controller.start();
  }
  for (const std::int64_t end = k + restarted; k < end; ++k) r.step(), watcher.look(r);
  auto& now = r.controller;
  found.recovered = now.template get<"robot.emergency_stop">().mode() == hw::motion_mode::run &&
                    !now.template get<"robot.rate">().approaching();
  if (!found.recovered && found.first_cause.empty())
    found.first_cause =
        std::string(hw::name_of(now.template get<"robot.emergency_stop">().first_cause().rule));
  found.sent = watcher.sent;
  found.sent_outside_limits = watcher.outside;
  return found;
}

}  // namespace hil
