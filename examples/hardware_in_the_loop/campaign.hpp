#pragma once
// The fault campaign: the trot with faults in its controller, what a fault is, and what a run tells.
//
// faults.cpp runs it and prints the table; the rows are in fault_rows.hpp. A run with a fault in the middle
// of the trot is in campaign_run.hpp, one with a fault at the start in start_run.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "spy.hpp"

namespace hil {

// Faults in the controller: commands that are not numbers, commands that are made of the same old data again
// and again, a component that gives up, and one that takes longer than a beat may.
struct saboteur {
  auto process(cca::in<"angles", robots::oncilla::leg_angles> wanted)
      -> std::tuple<cca::out<"angles", robots::oncilla::leg_angles>, cca::fault> {
    if (!stuck) origin = wanted.origin(), angles = wanted.vector();
    if (works) works();
    cca::out<"angles", robots::oncilla::leg_angles> result = angles;
    if (not_a_number) result[robots::oncilla::left_hind_hip{}] = std::nan("");
    result = result.with_origin(origin);
    return {result, gives_up ? cca::fault("it gives up") : cca::fault()};
  }
  bool not_a_number = false, stuck = false, gives_up = false;
  std::function<void()> works{};  // time may pass in it

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

// `Delay`: of the two wires between the gait and the side of the buses. cca::delayed<1> is the form of the
// real robot's program, in which these are two environments (two_environments.hpp); cca::latest is one loop.
template <class Limiter, class Delay, class Robot = oncilla<memory_end>>
struct sabotaged : cca::graph<cca::rate<1000>,
                              cca::node<"throttle", trot::throttle, cca::timed<10>>,
                              cca::node<"posture", trot::posture, cca::timed<10>>,
                              cca::node<"cpg", trot::stride_oscillator, cca::timed<1>>,
                              cca::node<"gait", trot::gait, cca::port_triggered<"phase">>,
                              cca::node<"saboteur", saboteur>,
                              cca::node<"limits", Limiter>,
                              cca::node<"spread", spread>,
                              cca::node<"spread_limits", cca::limiter<robots::oncilla::abduction_angles>>,
                              cca::node<"robot", Robot>,

                              cca::wire<"robot.orientation", "posture.orientation", Delay>,
                              cca::wire<"throttle.amplitude", "cpg.amplitude", cca::latest>,
                              cca::wire<"posture.turn", "gait.turn", cca::latest>,
                              cca::wire<"posture.lean", "gait.lean", cca::latest>,
                              cca::wire<"cpg.phase", "gait.phase">,
                              cca::wire<"cpg.amplitude", "gait.amplitude">,
                              cca::wire<"gait.angles", "saboteur.angles", Delay>,
                              cca::wire<"saboteur.angles", "limits.command">,
                              cca::wire<"limits.safe", "robot.command">,
                              cca::wire<"spread.angles", "spread_limits.command">,
                              cca::wire<"spread_limits.safe", "robot.abduction">> {};

// With the limiter of every architecture, and with the limiter switched off.
template <class Delay>
struct limited : sabotaged<cca::limiter<robots::oncilla::leg_angles>, Delay> {};
template <class Delay>
struct unlimited : sabotaged<cca::unlimited<robots::oncilla::leg_angles>, Delay> {};

// The parts that a fault is done to.
template <class Run>
auto& saboteur_of(Run& r) {
  return r.controller.template get<"saboteur">();
}
template <class Run>
auto& button(Run& r) {
  return r.controller.template get<"robot.emergency_stop">();
}
template <class Run>
auto& spread_of(Run& r) {
  return r.controller.template get<"spread">();
}
template <class Run>
auto& synchronizer(Run& r) {
  return r.controller.template get<"robot.synchronizer">();
}
template <std::size_t Drive, class Run>
auto& drive(Run& r) {
  return std::get<Drive>(r.far.drives);
}

struct timing {  // in beats: before a fault, after it, of the longest fault, after the restart
  static constexpr std::int64_t begin = 1500, after = 700, longest = 1000, restarted = 2500;
};

template <class Architecture>
struct scenario {
  using run_type = in_memory<Architecture>;
  std::string fault;
  std::int64_t beats = 200;             // the fault's duration
  std::vector<hw::bus_fault> script{};  // from the fault's beginning on
  std::function<void(run_type&, std::int64_t)> each =
      {};                                    // called in each of its beats, with their number from 0 on
  std::function<void(run_type&)> mend = {};  // ends the fault
  bool killed = false;                       // the program is killed and started again
  bool stops = false;                        // the program ends its run and calls stop()
  int signal = 0;                            // the program gets this signal, and ends as `stops`
  bool pressed = false;                      // the emergency stop is pressed all the time
  std::int64_t stands_still = 0;    // periods that the program loses between two beats, as the fault begins
  std::int64_t long_beat = 0;       // periods after which the beat still works in which the fault begins
  bool every_beat_is_long = false;  // so do the beats after it
  std::int64_t fault_after = 0;     // overruns in a row are a fault; 0: never

  // Watched to its end, stop() takes longer than the damping. Then each drive must have confirmed.
  bool is_whole_stop() const {
    return (stops || signal != 0) && beats + timing::after > hw::stop_sequence<8>::damping_beats;
  }
  std::int64_t lost_beats() const {
    return every_beat_is_long ? long_beat * fault_after : stands_still + long_beat;
  }
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
  std::int64_t lost_beats = 0, expected_lost_beats = 0;
  bool recovered = false, fell = false;
  std::string unexpected;  // what else is wrong
  bool good() const {
    return unexpected.empty() && recovered && sent_outside_limits == 0 && beats_to_safe <= 3 &&
           lost_beats == expected_lost_beats;
  }
};

// The time in a beat at which the far end answers, ns: early, so that the abduction targets of the next beat
// don't destroy a frame of the sensor board that still waits (on_drives.hpp).
inline constexpr std::int64_t early = 300'000;

// The positions of the joints from the beginning of the fault on. `undisturbed`: without a fault.
using path = std::vector<std::array<double, 8>>;
template <class Architecture>
std::array<double, 8> positions(const in_memory<Architecture>& r) {
  std::array<double, 8> all{};
  const auto joints_now = r.plant.motions();
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

}  // namespace hil
