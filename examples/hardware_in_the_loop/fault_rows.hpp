#pragma once
// The rows of the fault campaign: what goes wrong, and how it is mended.
#include <array>
#include <csignal>
#include <cstdint>
#include <string>
#include <utility>

#include "campaign_run.hpp"
#include "start_run.hpp"
#include "with_canopen.hpp"

namespace hil {

// Another node holds bus 0 for this beat.
template <class Run>
void hold(Run& r) {
  std::array<hw::can_frame, 8> noise;
  noise.fill({.id = hw::standard(0), .length = 8});
  r.wires[0].end(2).send(noise);
}

// Faults at the start.
template <class Delay, class Go>
void starts(Go go) {
  using run_type = in_memory<limited<Delay>>;
  using s = start_scenario<run_type>;
  const auto with = [&](const s& what) { go([&] { return start_run<run_type>(what).go(); }, false); };
  const double hip = front_stance.hip, end = joints::angle[0].upper;
  with(s{.fault = "start with a hip 0.6 rad outside of its range",
         .refusal = {"left_front_hip is at 2.",
                     "outside of its range -1.200 to 1.900 rad by more than 0.50 rad"},
         .outside = {end + 0.6 - hip}});
  with(s{.fault = "start with a hip 0.3 rad outside of its range, the robot held up",
         .outside = {end + 0.3 - hip},
         .hangs = true});
  with(s{.fault = "start with a velocity of the wrong sign",
         .refusal = {"left_hind_hip: the velocity that its drive reports is not the change of its angle"},
         .begin = [](run_type& r) { r.speed_scale[2] = -1; },
         .mend = [](run_type& r) { r.speed_scale[2] = 1; }});

  using canopen_run = with_canopen::run_type<Delay>;
  using canopen = start_run<canopen_run, with_canopen::joints>;
  const start_scenario<canopen_run> silent{
      .fault = "start without a measured velocity: a CANopen drive without TPDO2",
      .refusal = {"left_hind_knee: its drive does not report its velocity"},
      .script = {{.what = hw::bus_trouble::lose,
                  .end = 0,
                  .frames = hw::can_filter{with_canopen::left_hind_knee::drive::sends_velocity}}}};
  go([&] { return canopen(silent).go(); }, false);
}

// Calls go(run) for each row: `run` makes the row.
template <class Delay, class Go>
void campaign(Go go) {
  using t = hw::bus_trouble;
  using limited_run = in_memory<limited<Delay>>;
  using unlimited_run = in_memory<unlimited<Delay>>;
  const auto with = [&](const auto& what) { go([&] { return run(what); }, what.signal != 0); };
  using s = scenario<limited<Delay>>;
  constexpr std::size_t robot = 0, drives = 1;

  with(s{.fault = "frames lost, 5 %", .beats = 1000, .script = {{.what = t::lose, .chance = 0.05}}});
  with(s{.fault = "frames lost, all for 20 beats", .beats = 20, .script = {{.what = t::lose}}});
  with(s{.fault = "frames late, one in ten by 1 ms",
         .beats = 1000,
         .script = {{.what = t::delay, .chance = 0.1, .delay = 1'000'000}}});
  with(s{
      .fault = "frames late, all by 3 ms", .beats = 300, .script = {{.what = t::delay, .delay = 3'000'000}}});
  with(s{.fault = "frames duplicated", .beats = 1000, .script = {{.what = t::duplicate, .chance = 0.5}}});
  with(s{.fault = "frames reordered", .beats = 1000, .script = {{.what = t::reorder, .chance = 0.2}}});
  with(s{.fault = "answers corrupted, 2 %",
         .beats = 1000,
         .script = {{.what = t::corrupt, .end = robot, .chance = 0.02}}});
  with(s{.fault = "set-points corrupted, 1 %",
         .beats = 1000,
         .script = {{.what = t::corrupt, .end = drives, .chance = 0.01}}});
  with(s{.fault = "drive silent",
         .each = [](limited_run& r, std::int64_t) { drive<2>(r).go_silent(true); },
         .mend = [](limited_run& r) { drive<2>(r).clear(); }});
  with(s{.fault = "drive faulted",
         .each = [](limited_run& r, std::int64_t) { drive<4>(r).fail(0xA); },
         .mend = [](limited_run& r) { drive<4>(r).clear(); }});
  with(s{.fault = "drive rebooted", .each = [](limited_run& r, std::int64_t k) {
           if (k == 0) drive<1>(r).reboot(r.now, 150'000'000);
         }});
  with(s{.fault = "sensor board silent",
         .each = [](limited_run& r, std::int64_t) { r.far.board_silent = true; },
         .mend = [](limited_run& r) { r.far.board_silent = false; }});
  with(s{.fault = "bus warning", .script = {{.what = t::warning, .end = robot}}});
  with(s{.fault = "bus passive", .script = {{.what = t::passive, .end = robot}}});
  with(s{.fault = "bus off", .script = {{.what = t::bus_off, .end = robot}}});
  with(s{.fault = "link down, up", .script = {{.what = t::link_down, .end = robot}}});
  with(s{.fault = "link down for 1 beat", .beats = 1, .script = {{.what = t::link_down, .end = robot}}});
  with(s{.fault = "queue full: another node fills bus 0", .each = [](limited_run& r, std::int64_t) {
           std::array<hw::can_frame, 8> noise;
           noise.fill({.id = hw::standard(0), .length = 8});
           for (auto& f : noise) f.id = hw::standard(0x000), f.data.fill(0xAA);
           r.wires[0].end(2).send(noise);
         }});
  with(s{.fault = "queue full: nobody else on the bus",
         .script = {{.what = t::link_down, .end = drives}, {.what = t::link_down, .end = 2}}});
  with(s{.fault = "NaN in the controller",
         .each = [](limited_run& r, std::int64_t) { saboteur_of(r).not_a_number = true; },
         .mend = [](limited_run& r) { saboteur_of(r).not_a_number = false; }});
  with(scenario<unlimited<Delay>>{
      .fault = "NaN in the controller, limiter switched off",
      .each = [](unlimited_run& r, std::int64_t) { saboteur_of(r).not_a_number = true; },
      .mend = [](unlimited_run& r) { saboteur_of(r).not_a_number = false; }});
  with(s{.fault = "controller stuck on old data",
         .each = [](limited_run& r, std::int64_t) { saboteur_of(r).stuck = true; },
         .mend = [](limited_run& r) { saboteur_of(r).stuck = false; }});
  for (const std::int64_t beats : {1, 10, 100})
    with(s{.fault = "controller stalled for " + std::to_string(beats) + (beats == 1 ? " beat" : " beats"),
           .beats = beats,
           .stands_still = beats});
  for (const std::int64_t beats : {1, 10})
    with(s{.fault = "a beat takes more than " + std::to_string(beats) + (beats == 1 ? " period" : " periods"),
           .beats = beats,
           .long_beat = beats});
  with(s{.fault = "all beats take more than 1 period; 10 in a row are a fault",
         .beats = 100,
         .long_beat = 1,
         .every_beat_is_long = true,
         .fault_after = 10});
  with(s{.fault = "process killed", .beats = 1, .killed = true});
  with(s{.fault = "emergency stop pressed",
         .each = [](limited_run& r, std::int64_t) { button(r).press(); },
         .mend = [](limited_run& r) { button(r).release(); },
         .pressed = true});
  with(s{.fault = "soft stop asked for", .beats = 1, .each = [](limited_run& r, std::int64_t) {
           button(r).stop_softly();
         }});
  // Stopping.
  with(s{.fault = "stop() in the middle of the trot", .beats = 700, .stops = true});
  with(s{.fault = "SIGINT in the middle of the trot", .beats = 700, .signal = SIGINT});
  with(s{.fault = "SIGTERM in the middle of the trot", .beats = 700, .signal = SIGTERM});
  with(s{.fault = "stop() while another node holds bus 0",
         .beats = 2,
         .each = [](limited_run& r, std::int64_t) { hold(r); },
         .stops = true});
  with(s{.fault = "stop() with a silent drive",
         .each = [](limited_run& r, std::int64_t) { drive<2>(r).go_silent(true); },
         .mend = [](limited_run& r) { drive<2>(r).clear(); },
         .stops = true});
  with(s{.fault = "a component's fault",
         .each = [](limited_run& r, std::int64_t) { saboteur_of(r).gives_up = true; },
         .mend = [](limited_run& r) { saboteur_of(r).gives_up = false; }});
  with(s{.fault = "a component's fault while another node holds bus 0",
         .beats = 2,
         .each =
             [](limited_run& r, std::int64_t) {
               hold(r);
               saboteur_of(r).gives_up = true;
             },
         .mend = [](limited_run& r) { saboteur_of(r).gives_up = false; }});
  with(s{.fault = "a component's fault, and a silent drive",
         .each =
             [](limited_run& r, std::int64_t) {
               drive<6>(r).go_silent(true);
               saboteur_of(r).gives_up = true;
             },
         .mend =
             [](limited_run& r) {
               drive<6>(r).clear();
               saboteur_of(r).gives_up = false;
             }});
  // The pressed emergency stop.
  with(s{.fault = "emergency stop pressed, the legs are told to spread",
         .each =
             [](limited_run& r, std::int64_t) {
               button(r).press();
               spread_of(r).target = 0.3;
             },
         .mend =
             [](limited_run& r) {
               button(r).release();
               spread_of(r).target = 0;
             },
         .pressed = true});
  with(s{.fault = "emergency stop pressed, then started again and again",
         .each =
             [](limited_run& r, std::int64_t k) {
               button(r).press();
               if (k % 20 == 10) synchronizer(r).start();
             },
         .mend = [](limited_run& r) { button(r).release(); },
         .pressed = true});
  // What is measured.
  for (const auto& [what, scale] :
       {std::pair{"velocity frozen at 0", 0.0}, std::pair{"velocity of the wrong sign", -1.0},
        std::pair{"velocity 2.2 times too large", 2.2}})
    with(s{.fault = what,
           .each = [to = scale](limited_run& r, std::int64_t) { r.speed_scale[2] = to; },
           .mend = [](limited_run& r) { r.speed_scale[2] = 1; }});
  with(s{.fault = "calibration changed while it runs",
         .each = [](limited_run& r, std::int64_t) { synchronizer(r).p.offset[0] = 0.5; },
         .mend = [](limited_run& r) { synchronizer(r).p.offset[0] = 0; }});
  with(s{.fault = "sensor board faulty",
         .each =
             [](limited_run& r, std::int64_t) {
               auto reading = r.plant.board();
               reading.status = 1;
               r.far.board_silent = true;  // this sends in its place
               r.wires[4].end(2).send(board::frames(reading, 0));
             },
         .mend = [](limited_run& r) { r.far.board_silent = false; }});
  starts<Delay>(go);
}

}  // namespace hil
