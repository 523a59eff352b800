// The synchronizer of a robot on CAN: the only node that knows the buses. It reads in `sense` and sends in
// `act`.
//
//   sense   out one port an axis: robots::oncilla::measured_joint (rad, rad/s, N m), NaN until the drive has
//   reported;
//               the nodes behind it publish only numbers (oncilla_nodes.hpp)
//           out "trunk"  the sensor board, as robots::oncilla::measured_trunk, NaN likewise
//           out "joints" joint_states for the guards: what is measured, what is wrong, how far the drives are
//   act     in "set_points" of the guards; optional "abduction" targets for the board
//
// `connect(bus0, bus1, ...)` gives it the buses, which must outlive it; copies share them.
// `on_start` and `start()` are the deliberate way to motion: they enable the drives. Once all drives are
// enabled, the phase `begins`, and the guards start where the joints are.
// These trip the emergency stop in the same beat: a bus that went away; a drive that is silent for
// `silent_beats` or three times its own period, reports a fault, jumps or no longer reports its velocity; a
// sensor board that is silent or faulty; a loop that stood still. Then set points go out only if they damp,
// until `start()`.
// No set point is sent behind frames that still wait: it would be stale. `on_fault` damps at once and stops;
// `on_stop` disables the drives.
//
// Parameters: `offset`, the calibration of each joint in rad, added to its type's offset.
// Cost: two calls of each bus a beat, some dozen instructions a frame; no allocation. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include <cca/base/reflect.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/hardware/drives/set_points.hpp>
#include <cca/hardware/robot/board_record.hpp>
#include <cca/hardware/robot/joint_frames.hpp>
#include <cca/hardware/robot/joint_monitor.hpp>
#include <cca/hardware/robot/sensor_board.hpp>
#include <cca/hardware/safety/link_supervisor.hpp>
#include <cca/robots/oncilla/former_names.hpp>

namespace cca::hardware {

template <CanBus Bus, class Board, class Joints>
class can_synchronizer;

template <CanBus Bus, class Board, class... J>
class can_synchronizer<Bus, Board, joint_list<J...>> {
public:
  using joints = joint_list<J...>;
  static constexpr std::size_t count = sizeof...(J), buses = 1 + std::max({Board::bus, J::bus...});
  using offsets = std::array<cca::quantity<cca::angle, -1, 1>, count>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (offsets, offset));
  };
  parameters p{};

  static constexpr int silent_beats = joint_monitor<J...>::silent_beats, silent_board_beats = 10,
                       enabling_beats = 1000;
  static constexpr std::int64_t longest_pause =
      3'500'000;  // ns on the bus's clock, between two beats' frames

  template <class... Buses>
  void connect(Buses&... all) {
    static_assert(
        sizeof...(Buses) == buses,
        "cca::hardware::can_synchronizer: connect as many buses as the joints and the board are on");
    bus_ends = {&all...};
  }

  auto sense() -> std::tuple<out<J::axis::label, robots::oncilla::measured_joint<typename J::axis>>...,
                             out<"trunk", robots::oncilla::measured_trunk>,
                             out<"joints", joint_states<joints>>> {
    listen();
    bring_up();
    typename joint_states<joints>::vector_type states;
    for (std::size_t i = 0; i < count; ++i)
      joint_state{drives.angle[i], drives.speed[i], drives.torque[i], trip_of(i), phase_now}.put(states, i);
    return each([&]<std::size_t... I>(std::index_sequence<I...>) {
      return decltype(sense())(Eigen::Vector3d(drives.angle[I], J::speed_of(drives.reports[I].velocity),
                                               J::torque_of(drives.reports[I].torque))...,
                               trunk_record_of(reading), states);
    });
  }

  void act(in<"set_points", set_points<joints>> wanted,
           optional_in<"abduction", robots::oncilla::abduction_angles> abduction) {
    clear(outbox), moves = {};
    if (phase_now == motion_phase::enabling) {
      outbox = enabling_frames;
    } else if (phase_now == motion_phase::begins || phase_now == motion_phase::running) {
      each([&]<std::size_t... I>(std::index_sequence<I...>) {
        (command_joint<J, I>(set_point::of(wanted.vector(), I)), ...);
      });
    }
    if (abduction && phase_now != motion_phase::stopped) {
      const auto& a = abduction.vector();
      outbox[Board::bus].add(Board::abduct({a[0], a[1], a[2], a[3]}));
    }
    send_batches();
    if (phase_now == motion_phase::begins) phase_now = motion_phase::running;
  }

  // While a bus is away or still holds frames, this waits and the drives stay as they are.
  void start() {
    phase_now = motion_phase::enabling;
    enabling_steps = {};
    ready = refused = {};
    beats_left = enabling_beats;
    failed = safety_rule::none;
    drives.forget_trips();
    drives.forget_jumps();
    quiet_board = 0;
    last_arrival = 0;
  }
  void stop() {
    clear(outbox), moves = {};
    each([&]<std::size_t... I>(std::index_sequence<I...>) { (add<J>(J::drive::disable()), ...); });
    send_and_stop();
  }

  void on_start() { start(); }
  void on_stop() { stop(); }
  void on_fault() {
    clear(outbox), moves = {};
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      (add<J>(damped<J>(std::isfinite(drives.angle[I]) ? drives.angle[I] : 0.0)), ...);
    });
    send_and_stop();
  }

  motion_phase phase() const { return phase_now; }
  const drive_report& report(std::size_t joint) const { return drives.reports[joint]; }
  const board_reading& board() const { return reading; }
  const link_supervisor<3>& link(std::size_t bus) const { return links[bus]; }
  safety_rule refusal() const { return failed; }  // why the last start failed

private:
  static constexpr std::size_t most_frames = 8 * count + 1 + 4;
  using batch = frame_list<most_frames>;
  static void clear(std::array<batch, buses>& all) { std::ranges::for_each(all, &batch::clear); }

  template <class F>
  static decltype(auto) each(F f) {
    return f(std::make_index_sequence<count>());
  }

  bool moving() const { return phase_now >= motion_phase::begins; }

  void listen() {
    drives.begin_beat();
    const std::uint64_t board_frames_before = reading.frames;
    std::int64_t newest_arrival = last_arrival;
    for (std::size_t b = 0; b < buses; ++b) {
      if (!bus_ends[b]) continue;
      for (std::size_t n = inbox.size(); n == inbox.size();) {
        n = bus_ends[b]->receive(inbox);
        for (std::size_t k = 0; k < n; ++k) {
          newest_arrival = std::max(newest_arrival, inbox[k].time);
          if (b == Board::bus && Board::decode(inbox[k].frame, reading)) continue;
          each([&]<std::size_t... I>(std::index_sequence<I...>) {
            (drives.template hear<J, I>(b, inbox[k], p.offset[I], moving()) || ...);
          });
        }
      }
      links[b].observe(bus_ends[b]->state(), bus_ends[b]->counters());
    }
    const std::int64_t pause = last_arrival == 0 ? 0 : newest_arrival - last_arrival;
    last_arrival = newest_arrival;
    if (!moving()) return;
    auto& trips = drives.trips;
    if (pause > longest_pause) trips.fill(safety_rule::stalled);
    drives.check();
    for (std::size_t i = 0; i < count; ++i)
      if (links[bus_of[i]].state() == link_state::safe) trips[i] = safety_rule::link;
    quiet_board = reading.frames == board_frames_before ? quiet_board + 1 : 0;
    if (quiet_board >= silent_board_beats || reading.status != 0)
      std::ranges::replace(trips, safety_rule::none, safety_rule::sensor_board);
    if (links[Board::bus].state() == link_state::safe) trips.fill(safety_rule::link);
  }

  // A step of enabling. Motion begins once all drives are ready, all positions known and all buses free.
  void bring_up() {
    if (phase_now != motion_phase::enabling) return;
    clear(enabling_frames);
    bool all = true;
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      const auto next = [&]<class One, std::size_t K>() {
        if (!is_free(One::bus))
          return void(all = false);  // one step at a time, and none behind those of `stop`
        const drive_report& report = drives.reports[K];
        const bool off = refused[K] || report.activity == drive_activity::disabled;
        // Again every 50 beats, since a frame may be lost.
        if (off && beats_left % 50 == 0) std::get<K>(enabling_steps) = {}, refused[K] = false;
        if (!refused[K]) {
          const enable_step s = std::get<K>(enabling_steps).next(report);
          for (std::size_t k = 0; k < s.frames.size(); ++k) enabling_frames[One::bus].add(s.frames[k]);
          ready[K] = ready[K] || s.progress == enable_progress::done;
          refused[K] = !ready[K] && s.progress == enable_progress::failed;
        }
        all =
            all && ready[K] && report.activity != drive_activity::disabled && std::isfinite(drives.angle[K]);
      };
      (next.template operator()<J, I>(), ...);
    });
    if (--beats_left <= 0) {
      failed = safety_rule::enabling;
      return stop();
    }
    if (!all || reading.frames == 0) return;
    for (std::size_t b = 0; b < buses; ++b)
      if (!is_free(b)) return;
    for (auto& l : links) l.start(0);
    drives.forget_trips();
    quiet_board = 0;
    phase_now = motion_phase::begins;
  }

  template <class One, std::size_t I>
  void command_joint(set_point s) {
    const bool runs = s.mode() == motion_mode::run;
    if (runs && !links[One::bus].may_move()) return;
    moves[One::bus] = runs;
    s.position -= p.offset[I] + drives.template turned<One>(I);
    add<One>(
        frames_for<One>(s, drives.angle[I] - p.offset[I] - drives.template turned<One>(I), drives.speed[I]));
  }
  template <class One>
  static drive_frames damped(double where) {
    return frames_for<One>(
        {{where, 0, 0, 0, One::servo.safe_damping}, static_cast<double>(motion_mode::damped)}, where, 0);
  }
  template <class One>
  void add(const drive_frames& frames) {
    for (std::size_t k = 0; k < frames.size(); ++k) outbox[One::bus].add(frames[k]);
  }
  // Behind frames that still wait, a set point would be stale: it is dropped and counted. Only frames that
  // damp may go behind frames that move, once: so they come last.
  void send_batches() {
    for (std::size_t b = 0; b < buses; ++b) {
      if (!bus_ends[b] || outbox[b].empty() || !links[b].may_speak()) continue;
      for (const can_frame& f : cycle_end_frames[b]) outbox[b].add(f);
      const bool too_late = bus_ends[b]->in_flight() != 0 && (moves[b] || !moved[b]);
      const send_result sent = too_late ? send_result{0, send_outcome::full} : bus_ends[b]->send(outbox[b]);
      if (sent.sent != 0) moved[b] = moves[b];
      if (links[b].may_move()) links[b].sent(sent);
    }
  }
  void send_and_stop() {
    moved.fill(true);  // so this goes out behind whatever still waits
    send_batches();
    phase_now = motion_phase::stopped;
    for (auto& l : links) l.stop();
  }
  bool is_free(std::size_t b) const {
    return bus_ends[b] && !is_away(bus_ends[b]->state()) && bus_ends[b]->in_flight() == 0;
  }

  safety_rule trip_of(std::size_t i) const { return moving() ? drives.trips[i] : safety_rule::none; }

  static constexpr std::array<std::size_t, count> bus_of{J::bus...};
  static constexpr auto cycle_end_frames = cycle_ends<buses, J...>();

  std::array<Bus*, buses> bus_ends{};
  std::array<link_supervisor<3>, buses> links{};
  joint_monitor<J...> drives{};
  board_reading reading = board_reading::untold();
  int quiet_board = 0, beats_left = 0;
  safety_rule failed = safety_rule::none;
  std::tuple<typename J::drive::enabling...> enabling_steps{};
  std::array<bool, count> ready{}, refused{};
  // Whether the next batch follows the controller, and whether the last one that was sent did.
  std::array<bool, buses> moves{}, moved{};
  std::int64_t last_arrival = 0;
  motion_phase phase_now = motion_phase::stopped;
  std::array<batch, buses> enabling_frames{}, outbox{};
  std::array<received_frame, 64> inbox{};
};

}  // namespace cca::hardware
