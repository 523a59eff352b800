// The synchronizer of a robot on CAN: the one node that knows the buses. It reads all that came in `sense`,
// and writes in `act`.
//
//   sense   out one port an axis: robots::oncilla::measured_joint (rad, rad/s, N m), NaN until the drive has
//   told: the nodes behind it publish
//           what is a number (oncilla_nodes.hpp)
//           out "trunk"  the sensor board, as robots::oncilla::measured_trunk, NaN likewise
//           out "joints" joint_states for the guards: what is measured, what is wrong, how far the drives are
//   act     in "set_points" of the guards; optional "abduction" targets for the board
//
// `connect(bus0, bus1, ...)` gives it the buses, which must outlive it; copies share them. `on_start` and
// `start()` are the deliberate way to motion: drives are enabled; once all of them are, the phase `begins`
// and the guards start where the joints are. A bus that went away, a drive that says nothing for
// `silent_beats` or three times its own period, tells of a fault, jumps or loses its speed, a sensor board
// that is silent or faulty, a loop that stood still, all trip the emergency stop, in the same beat. Then
// set-points go out only if they damp, until `start()`. No set-point is sent behind frames that still wait:
// it would be an old one. `on_fault` damps at once and stops; `on_stop` disables. Parameters: `offset`, the
// calibration of each joint, in addition to its type's. Cost: two calls of each bus a beat, some dozen
// instructions a frame; no allocation. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/base/reflect.hpp>
#include <cca/hardware/board_record.hpp>
#include <cca/hardware/joint_frames.hpp>
#include <cca/hardware/link_supervisor.hpp>
#include <cca/hardware/sensor_board.hpp>
#include <cca/hardware/set_points.hpp>
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

  static constexpr int silent_beats = 3, silent_board_beats = 10, enabling_beats = 1000;
  static constexpr std::int64_t longest_pause =
      3'500'000;  // ns on the bus's clock between two batches of answers

  template <class... Buses>
  void connect(Buses&... all) {
    static_assert(
        sizeof...(Buses) == buses,
        "cca::hardware::can_synchronizer: connect as many buses as the joints and the board are on");
    wires = {&all...};
  }

  auto sense() -> std::tuple<out<J::axis::label, robots::oncilla::measured_joint<typename J::axis>>...,
                             out<"trunk", robots::oncilla::measured_trunk>,
                             out<"joints", joint_states<joints>>> {
    listen();
    bring_up();
    typename joint_states<joints>::vector_type states;
    for (std::size_t i = 0; i < count; ++i)
      joint_state{angle[i], speed[i], torque[i], trip_of(i), at}.put(states, i);
    return each([&]<std::size_t... I>(std::index_sequence<I...>) {
      return decltype(sense())(
          Eigen::Vector3d(angle[I], J::speed_of(reports[I].velocity), J::torque_of(reports[I].torque))...,
          trunk_record_of(reading), states);
    });
  }

  void act(in<"set_points", set_points<joints>> wanted,
           optional_in<"abduction", robots::oncilla::abduction_angles> abduction) {
    clear(outbox), moves = {};
    if (at == motion_phase::enabling) {
      outbox = enabling_frames;
    } else if (at == motion_phase::begins || at == motion_phase::running) {
      each([&]<std::size_t... I>(std::index_sequence<I...>) {
        (order<J, I>(set_point::of(wanted.vector(), I)), ...);
      });
    }
    if (abduction && at != motion_phase::stopped) {
      const auto& a = abduction.vector();
      outbox[Board::bus].add(Board::abduct({a[0], a[1], a[2], a[3]}));
    }
    post();
    if (at == motion_phase::begins) at = motion_phase::running;
  }

  // Refused by waiting: as long as a bus is away or still holds frames, the drives stay as they are.
  void start() {
    at = motion_phase::enabling;
    way = {};
    ready = refused = {};
    budget = enabling_beats;
    trips.fill(safety_rule::none);
    failed = safety_rule::none;
    jumps.fill(0), quiet.fill(0), quiet_board = 0;
    newest = 0;
  }
  void stop() {
    clear(outbox), moves = {};
    each([&]<std::size_t... I>(std::index_sequence<I...>) { (add<J>(J::drive::disable()), ...); });
    post_and_stop();
  }

  void on_start() { start(); }
  void on_stop() { stop(); }
  void on_fault() {
    clear(outbox), moves = {};
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      (add<J>(damped<J>(std::isfinite(angle[I]) ? angle[I] : 0.0)), ...);
    });
    post_and_stop();
  }

  motion_phase phase() const { return at; }
  const drive_report& report(std::size_t joint) const { return reports[joint]; }
  const board_reading& board() const { return reading; }
  const link_supervisor<3>& link(std::size_t bus) const { return links[bus]; }
  safety_rule refusal() const { return failed; }  // why the last start came to nothing

private:
  static constexpr std::size_t most_frames = 8 * count + 1 + 4;
  using batch = frame_list<most_frames>;
  static void clear(std::array<batch, buses>& all) { std::ranges::for_each(all, &batch::clear); }

  template <class F>
  static decltype(auto) each(F f) {
    return f(std::make_index_sequence<count>());
  }

  void listen() {
    const auto before = frames_of_drives();
    const std::uint64_t of_board = reading.frames;
    std::int64_t latest = newest;
    for (std::size_t b = 0; b < buses; ++b) {
      if (!wires[b]) continue;
      for (std::size_t n = inbox.size(); n == inbox.size();) {
        n = wires[b]->receive(inbox);
        for (std::size_t k = 0; k < n; ++k) {
          latest = std::max(latest, inbox[k].time);
          if (b == Board::bus && Board::decode(inbox[k].frame, reading)) continue;
          each([&]<std::size_t... I>(std::index_sequence<I...>) { (hear<J, I>(b, inbox[k]) || ...); });
        }
      }
      links[b].observe(wires[b]->state(), wires[b]->counters());
    }
    const std::int64_t pause = newest == 0 ? 0 : latest - newest;
    newest = latest;
    if (at < motion_phase::begins) return;
    if (pause > longest_pause) trips.fill(safety_rule::stalled);
    const auto now = frames_of_drives();
    for (std::size_t i = 0; i < count; ++i) {
      quiet[i] = now[i] == before[i] ? quiet[i] + 1 : 0;
      if (jumps[i] >= silent_beats) note(i, safety_rule::implausible);
      if (quiet[i] >= patient[i]) note(i, safety_rule::silent);
      if (reports[i].fault != drive_fault::none || reports[i].activity == drive_activity::disabled)
        note(i, safety_rule::drive_fault);
      if (links[bus_of[i]].state() == link_state::safe) trips[i] = safety_rule::link;
    }
    quiet_board = reading.frames == of_board ? quiet_board + 1 : 0;
    if (quiet_board >= silent_board_beats || reading.status != 0)
      std::ranges::replace(trips, safety_rule::none, safety_rule::sensor_board);
    if (links[Board::bus].state() == link_state::safe) trips.fill(safety_rule::link);
  }
  void note(std::size_t i, safety_rule rule) {
    if (trips[i] == safety_rule::none) trips[i] = rule;
  }

  template <class One, std::size_t I>
  bool hear(std::size_t b, const received_frame& f) {
    if (One::bus != b) return false;
    drive_report heard = reports[I];
    if (!One::drive::decode(f.frame, heard)) return false;
    if ((heard.told & of_velocity) && !std::isfinite(heard.velocity))
      return ++jumps[I], true;  // no number to judge by
    if (heard.told & of_position) {
      const double now = One::angle_of(heard.position) + p.offset[I];
      const double pause = static_cast<double>(f.time - told_at[I]) * 1e-9;
      const double fastest = 1.5 * std::max(One::speed.upper, -One::speed.lower);
      if (at >= motion_phase::begins && std::isfinite(angle[I]) &&
          !(std::abs(now - angle[I]) <= 0.05 + fastest * (pause + 1e-3))) {
        ++jumps[I];
        return true;
      }
      jumps[I] = 0;
      told_at[I] = f.time;
      angle[I] = now;
    }
    if (heard.told & of_velocity) speed[I] = One::speed_of(heard.velocity);
    if (heard.told & of_torque) torque[I] = One::torque_of(heard.torque);
    reports[I] = heard;
    return true;
  }

  // Steps of enabling; once all drives are ready and their positions known, and the buses are free, motion
  // begins.
  void bring_up() {
    if (at != motion_phase::enabling) return;
    clear(enabling_frames);
    bool all = true;
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      const auto next = [&]<class One, std::size_t K>() {
        if (!is_free(One::bus))
          return void(all = false);  // a step at a time, and none behind those of `stop`
        const bool off = refused[K] || reports[K].activity == drive_activity::disabled;
        if (off && budget % 50 == 0)
          std::get<K>(way) = {}, refused[K] = false;  // once more, now and then: a frame may be lost
        if (!refused[K]) {
          const enable_step s = std::get<K>(way).next(reports[K]);
          for (std::size_t k = 0; k < s.frames.size(); ++k) enabling_frames[One::bus].add(s.frames[k]);
          ready[K] = ready[K] || s.progress == enable_progress::done;
          refused[K] = !ready[K] && s.progress == enable_progress::failed;
        }
        all = all && ready[K] && reports[K].activity != drive_activity::disabled && std::isfinite(angle[K]);
      };
      (next.template operator()<J, I>(), ...);
    });
    if (--budget <= 0) {
      failed = safety_rule::enabling;
      return stop();
    }
    if (!all || reading.frames == 0) return;
    for (std::size_t b = 0; b < buses; ++b)
      if (!is_free(b)) return;
    for (auto& l : links) l.start(0);
    trips.fill(safety_rule::none);
    quiet.fill(0), quiet_board = 0;
    at = motion_phase::begins;
  }

  template <class One, std::size_t I>
  void order(set_point s) {
    const bool runs = s.mode() == motion_mode::run;
    if (runs && !links[One::bus].may_move()) return;
    moves[One::bus] = runs;
    s.position -= p.offset[I];
    add<One>(frames_for<One>(s, angle[I] - p.offset[I], speed[I]));
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
  // Behind frames that still wait a set-point would only become a stale one: it is dropped, and counted. Only
  // what damps goes behind what moves, once: so it comes last.
  void post() {
    for (std::size_t b = 0; b < buses; ++b) {
      if (!wires[b] || outbox[b].empty() || !links[b].may_speak()) continue;
      for (const can_frame& f : ends[b]) outbox[b].add(f);
      const bool too_late = wires[b]->in_flight() != 0 && (moves[b] || !moved[b]);
      const send_result sent = too_late ? send_result{0, send_outcome::full} : wires[b]->send(outbox[b]);
      if (sent.sent != 0) moved[b] = moves[b];
      if (links[b].may_move()) links[b].sent(sent);
    }
  }
  void post_and_stop() {
    moved.fill(true);  // whatever waits, this goes behind it
    post();
    at = motion_phase::stopped;
    for (auto& l : links) l.stop();
  }
  bool is_free(std::size_t b) const {
    return wires[b] && !is_away(wires[b]->state()) && wires[b]->in_flight() == 0;
  }

  std::array<std::uint64_t, count> frames_of_drives() const {
    return each(
        [&]<std::size_t... I>(std::index_sequence<I...>) { return std::array{reports[I].frames...}; });
  }
  safety_rule trip_of(std::size_t i) const {
    return at >= motion_phase::begins ? trips[i] : safety_rule::none;
  }

  static constexpr std::array<double, count> unknown{(sizeof(J) ? drive_report::untold : 0)...};
  static constexpr std::array<std::size_t, count> bus_of{J::bus...};
  static constexpr std::array<int, count> patient{patience<J>(silent_beats, 1'000'000)...};
  static constexpr auto ends = cycle_ends<buses, J...>();

  std::array<Bus*, buses> wires{};
  std::array<link_supervisor<3>, buses> links{};
  std::array<drive_report, count> reports{};
  board_reading reading = board_reading::untold();
  std::array<double, count> angle = unknown, speed{}, torque{};
  std::array<std::int64_t, count> told_at{};
  std::array<int, count> quiet{}, jumps{};
  int quiet_board = 0, budget = 0;
  std::array<safety_rule, count> trips{};
  safety_rule failed = safety_rule::none;
  std::tuple<typename J::drive::enabling...> way{};
  std::array<bool, count> ready{}, refused{};
  std::array<bool, buses> moves{}, moved{};  // what is to be sent, and what was, follows the controller
  std::int64_t newest = 0;
  motion_phase at = motion_phase::stopped;
  std::array<batch, buses> enabling_frames{}, outbox{};
  std::array<received_frame, 64> inbox{};
};

}  // namespace cca::hardware
