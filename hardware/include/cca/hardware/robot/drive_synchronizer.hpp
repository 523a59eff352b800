// The synchronizer of a robot on CAN without its ports: it reads the buses, enables the drives, watches them,
// sends set points and stops. robot_synchronizer.hpp gives it ports.
//
//   read(now)                 in `sense`: takes what has come, and enables the drives where they start
//   measured<I>(), states()   then: angle, velocity and torque of joint I, NaN where they are too old; all
//                             joints for the guards, and the phase
//   send(set_points, more)    in `act`: set points of the guards go out. `more(runs)` may add frames for the
//                             board; it is called in each beat. `runs`: the drives follow the controller
//
// `connect(bus0, bus1, ...)` gives it the buses, which must outlive it; copies share them.
//
// Start: `on_start` and `start()` are the deliberate way to motion. They latch the calibration and enable the
// drives. Once all are enabled and measured, and no check refuses it (start_check.hpp), the phase `begins`,
// and the guards start where the joints are. Else: `refusal()`, and `failure()` with joint and numbers.
// Trips: a bus that went away; a drive that is silent, reports a fault, jumps or no longer reports what the
// guards use (joint_monitor.hpp); a sensor board that is silent or faulty; a loop that stood still. Then set
// points go out only if they damp, until `start()`.
// Stop: `stop()`, `on_stop`, `on_fault` and `damping_beats` of a tripped emergency stop run the same sequence
// (stop_sequence.hpp): damp, then disable, in each beat and each `on_idle`, until each drive has confirmed;
// `stopping()` and `unconfirmed(i)` say how far it is. A start waits for its end. While the emergency stop is
// pressed no drive is enabled. No set point is sent after frames that still wait: it would be stale.
//
//   Rate    of the beats: times are the same at any rate (beats.hpp)
//   Board   what is on the buses beside the drives (boards/, oncilla/sensor_board.hpp), or no_board: `bus`,
//           `decode(frame, reading)`, and a reading with `frames` and `status` (0: fine)
//
// Parameters: `offset`, the calibration of each joint in rad, added to its type's offset. A change is refused
// from `start()` until the robot has stopped.
// Cost: two calls of each bus a beat, some dozen instructions a frame; no allocation. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/reflect.hpp>
#include <cca/component/parameters.hpp>
#include <cca/hardware/drives/set_points.hpp>
#include <cca/hardware/robot/boards/no_board.hpp>
#include <cca/hardware/robot/bus_outbox.hpp>
#include <cca/hardware/robot/drive_enabling.hpp>
#include <cca/hardware/robot/joint_frames.hpp>
#include <cca/hardware/robot/joint_monitor.hpp>
#include <cca/hardware/robot/start_check.hpp>
#include <cca/hardware/robot/start_failure.hpp>
#include <cca/hardware/robot/stop_cause.hpp>
#include <cca/hardware/robot/stop_sequence.hpp>
#include <cca/hardware/safety/beats.hpp>
#include <cca/hardware/safety/bounds.hpp>

namespace cca::hardware {

template <CanBus Bus, class Board, class Joints, class Rate = cca::rate<1000>>
class drive_synchronizer;

template <CanBus Bus, class Board, class... J, class Rate>
class drive_synchronizer<Bus, Board, joint_list<J...>, Rate> : public stop_cause<J...> {
  using monitor = joint_monitor<Rate, J...>;
  using enabler = drive_enabling<Rate, J...>;
  using sequence = stop_sequence<sizeof...(J), Rate>;

public:
  using joints = joint_list<J...>;
  static constexpr std::size_t count = sizeof...(J), buses = 1 + std::max({Board::bus, J::bus...});
  using board_reading = typename Board::reading;
  using offsets = std::array<cca::quantity<cca::angle, -1, 1>, count>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (offsets, offset));
  };
  parameters p{};

  static constexpr int silent_beats = monitor::silent_beats,
                       silent_board_beats = beats<Rate>::lasting(10'000'000),
                       enabling_beats = enabler::most_beats, damping_beats = sequence::damping_beats,
                       confirming_beats = sequence::confirming_beats;
  // ns on the bus's clock, between two beats' frames: 3.5 beats, and at least 3.5 ms
  static constexpr auto longest_pause = std::max<std::int64_t>(3'500'000, beats<Rate>::period * 7 / 2);
  static constexpr double range_tolerance = start_check<J...>::range_tolerance;  // rad

  template <class... Buses>
  void connect(Buses&... all) {
    using mistake = detail::mistake_of_buses<Bus, Board, joints, Buses...>;
    static_assert(cca::detail::holds_or_tells<mistake::none, mistake>::value);
    if constexpr (mistake::none) outbox.connect({&all...});
  }

  // While a bus is away or still holds frames, and until a stop has come to its end, this waits.
  void start() {
    stops.hurry();
    phase_now = motion_phase::enabling;
    latched = p.offset;
    this->forget_cause();
    begin_enabling();
  }
  void stop() { begin_stop(moving()), send_stop(); }

  void on_start() { start(); }
  void on_stop() { stop(); }
  void on_fault() {
    if (phase_now == motion_phase::enabling)
      this->note_fault_in_start(checks.missing(drives, enabling, has_reported()));
    stop();
  }
  // Instead of a beat. As after a late sample, the last set points stay for some beats; then joints are
  // damped until the next one, or held where a drive can't be damped.
  void on_idle() {
    if (stopping()) listen(), send_stop();
    else if (moving()) listen(), send_idle();
  }

  motion_phase phase() const { return phase_now; }
  const drive_report& report(std::size_t joint) const { return drives.reports[joint]; }
  const board_reading& board() const { return reading; }
  const link_supervisor<3>& link(std::size_t bus) const { return outbox.links[bus]; }
  bool stopping() const { return stops.stage() != stop_stage::none; }
  // In the last stop, the drive of this joint has not said that it is off.
  bool unconfirmed(std::size_t joint) const { return !stops.is_confirmed(joint); }
  static constexpr std::string_view name_of(std::size_t joint) { return joints::names[joint]; }
  // cca::controller::set asks: why these parameters can't be taken now; empty: they can.
  std::string_view refusal_of(const parameters& other) const {
    const bool idle = phase_now == motion_phase::stopped && !stopping();
    return idle || other.offset == p.offset
               ? ""
               : "offset: start() has latched the calibration; stop the robot first";
  }

protected:
  template <class F>
  static decltype(auto) each(F f) {
    return f(std::make_index_sequence<count>());
  }

  void read(const beat& now) {
    this->begin_beat(now.index());
    listen();
    bring_up();
  }
  Eigen::Vector3d measured(std::size_t i) const {
    return {drives.angle_now(i), drives.speed_now(i), drives.torque_now(i)};
  }
  typename joint_states<joints>::vector_type states() const {
    // After a longer pause the guards begin again where the joints are.
    const motion_phase phase = idled >= beats<Rate>::in(20'000'000) && phase_now == motion_phase::running
                                   ? motion_phase::resumes
                                   : phase_now;
    typename joint_states<joints>::vector_type all;
    for (std::size_t i = 0; i < count; ++i)
      joint_state{drives.angle[i], drives.speed[i], drives.torque_now(i), trip_of(i), phase}.put(all, i);
    return all;
  }

  template <class More>
  void send(const typename set_points<joints>::vector_type& wanted, More more) {
    const motion_mode mode = set_point::of(wanted, 0).mode();
    idled = 0, followed = mode == motion_mode::run;
    last = wanted;
    if (mode == motion_mode::barred &&
        (phase_now == motion_phase::enabling || phase_now == motion_phase::begins))
      refuse({.why = safety_rule::pressed});
    damped_for = phase_now == motion_phase::running && mode >= motion_mode::damped ? damped_for + 1 : 0;
    if (damped_for >= damping_beats) begin_stop(false);
    if (stopping()) return more(false), send_stop();
    if (phase_now != motion_phase::enabling) outbox.clear();  // else it has the frames of bring_up
    if (moving())
      each([&]<std::size_t... I>(std::index_sequence<I...>) {
        (command_joint<J, I>(set_point::of(wanted, I)), ...);
      });
    more(moving() && mode == motion_mode::run && outbox.links[Board::bus].may_move());
    outbox.send();
    if (phase_now == motion_phase::begins) phase_now = motion_phase::running;
  }

  bus_outbox<Bus, buses, J...> outbox{};
  board_reading reading = board_reading::untold();

private:
  static constexpr int kept_beats = 3;  // as cca::tolerate<3>, the default
  static constexpr bool has_board = !std::is_same_v<Board, no_board>;

  bool has_reported() const { return !has_board || reading.frames != 0; }
  bool moving() const { return phase_now >= motion_phase::begins; }
  safety_rule trip_of(std::size_t i) const { return moving() ? drives.trips[i] : safety_rule::none; }

  void listen() {
    drives.begin_beat();
    const std::uint64_t board_frames_before = reading.frames;
    std::int64_t newest_arrival = last_arrival;
    for (std::size_t b = 0; b < buses; ++b) {
      Bus* const bus = outbox.end(b);
      if (!bus) continue;
      for (std::size_t n = inbox.size(); n == inbox.size();) {
        n = bus->receive(inbox);
        for (std::size_t k = 0; k < n; ++k) {
          newest_arrival = std::max(newest_arrival, inbox[k].time);
          if (has_board && b == Board::bus && Board::decode(inbox[k].frame, reading)) continue;
          each([&]<std::size_t... I>(std::index_sequence<I...>) {
            (drives.template hear<J, I>(b, inbox[k], latched[I], moving()) || ...);
          });
        }
      }
      outbox.links[b].observe(bus->state(), bus->counters());
      disabled_on[b] = disabled_on[b] || (sent_disable[b] && outbox.is_free(b));
    }
    stops.listen(joints(), drives.reports, disabled_on);
    const std::int64_t pause = last_arrival == 0 ? 0 : newest_arrival - last_arrival;
    last_arrival = newest_arrival;
    if (moving()) watch(pause, reading.frames == board_frames_before);
  }
  void watch(std::int64_t pause, bool board_was_quiet) {
    auto& trips = drives.trips;
    if (pause > longest_pause) trips.fill(safety_rule::stalled);
    drives.check();
    for (std::size_t i = 0; i < count; ++i)
      if (outbox.links[this->bus_of[i]].state() == link_state::safe) trips[i] = safety_rule::link;
    quiet_board = has_board && board_was_quiet ? quiet_board + 1 : 0;
    const bool is_board_lost = quiet_board >= silent_board_beats || reading.status != 0;
    if (has_board && is_board_lost) std::ranges::replace(trips, safety_rule::none, safety_rule::sensor_board);
    if (has_board && outbox.links[Board::bus].state() == link_state::safe) trips.fill(safety_rule::link);
    this->note_trips(drives, outbox.links, {pause, quiet_board, static_cast<int>(reading.status)});
  }

  void begin_enabling() {
    enabling.begin();
    drives.restart();
    checks.begin();
    quiet_board = damped_for = 0;
    last_arrival = 0;
  }
  // A step of enabling.
  void bring_up() {
    if (phase_now != motion_phase::enabling || stopping()) return;
    if (!outbox.end(0))
      return refuse({.why = safety_rule::enabling, .missing = "no bus is connected: call `connect` first"});
    outbox.clear();
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      // One step at a time, and none after frames that wait.
      ((outbox.is_free(J::bus)
            ? enabling.template next<J, I>(drives.reports[I], drives.is_ready(I), outbox[J::bus])
            : void()),
       ...);
    });
    if (const start_failure f = checks.check(drives)) return refuse(f);
    enabling.count_beat();
    if (enabling.is_over()) return refuse(checks.missing(drives, enabling, has_reported()));
    if (!outbox.are_all_free() || !enabling.are_all_ready() || !has_reported() || !checks.may_begin()) return;
    for (auto& l : outbox.links) l.start(0);
    drives.forget_trips();
    phase_now = motion_phase::begins;
  }
  void refuse(const start_failure& f) {
    this->note_refused(f);
    begin_stop(false);
  }

  template <class One, std::size_t I>
  void command_joint(set_point s) {
    const bool runs = s.mode() == motion_mode::run;
    if (runs && !outbox.links[One::bus].may_move()) return;
    outbox.moves[One::bus] = runs;
    const double seam = latched[I] + drives.template turned<One>(I);
    s.position -= seam;
    outbox.add(One::bus,
               frames_for<One>(s, drives.angle[I] - seam, drives.speed[I], drives.can_be_damped(I)));
  }
  // Damps, with no more torque than the joint may have at its present angle and speed.
  template <class One, std::size_t I>
  drive_frames damped() const {
    const joint_state q{drives.angle[I], drives.speed[I]};
    const double where = q.known() ? q.angle : 0;
    const set_point s =
        limit_guard<joints>::scaled(I, q, {{where, 0, 0, 0, One::servo.safe_damping}, motion_mode::damped});
    return frames_for<One>(s, where, drives.speed[I], drives.can_be_damped(I));
  }

  void begin_stop(bool damp) {
    if (stops.begin(damp)) sent_disable = disabled_on = {};
    phase_now = motion_phase::stopped;
    for (auto& l : outbox.links) l.stop();
    outbox.let_pass();
  }
  void send_to_all(bool damps) {
    outbox.clear();
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      (outbox.add(J::bus, damps ? damped<J, I>() : J::drive::disable()), ...);
    });
    outbox.send();
  }
  // A drive with gains of its own can't damp, and must not be switched off because others are late: it holds.
  void send_idle() {
    const bool is_sound =
        followed && std::ranges::all_of(drives.trips, [](safety_rule r) { return r == safety_rule::none; });
    if (idled == kept_beats) held_at = drives.angle;
    outbox.clear();
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      if (is_sound && idled < kept_beats) (command_joint<J, I>(set_point::of(last, I)), ...);
      else (outbox.add(J::bus, is_sound ? held<J, I>() : damped<J, I>()), ...);
    });
    ++idled;
    outbox.send();
  }
  template <class One, std::size_t I>
  drive_frames held() const {
    using D = typename One::drive;
    if constexpr ((D::uses & of_stiffness) != 0 || (D::uses & (of_position | of_velocity)) == 0)
      return damped<One, I>();
    else
      return frames_for<One>({{held_at[I] - latched[I] - drives.template turned<One>(I)}, motion_mode::run},
                             drives.angle[I], drives.speed[I], false);
  }
  void send_stop() {
    const stop_stage stage = stops.stage();
    send_to_all(stage == stop_stage::damping);
    for (std::size_t b = 0; b < buses; ++b)
      sent_disable[b] = sent_disable[b] || (stage == stop_stage::disabling && outbox.has_sent[b]);
    stops.advance();
    if (!stopping() && phase_now == motion_phase::enabling) begin_enabling();  // the start that has waited
  }

  monitor drives{};
  enabler enabling{};
  start_check<J...> checks{};
  sequence stops{};
  // Whether frames that disable were sent in this stop, and have gone over the bus.
  std::array<bool, buses> sent_disable{}, disabled_on{};
  offsets latched{};
  int quiet_board = 0, damped_for = 0, idled = 0;  // idled: beats since the last set points
  bool followed = false;                           // the last set points were to be followed
  std::array<double, count> held_at{};  // rad, where the joints were when the last set points ended
  typename set_points<joints>::vector_type last = set_points<joints>::vector_type::Zero();
  std::int64_t last_arrival = 0;
  motion_phase phase_now = motion_phase::stopped;
  std::array<received_frame, 64> inbox{};
};

}  // namespace cca::hardware
