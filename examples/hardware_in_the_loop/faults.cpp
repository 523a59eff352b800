// The fault campaign: one run for each fault of the list below. Prints a table.
//
// usage: hardware_in_the_loop_faults [faults.json [docs/hardware.md]]
//   faults.json        writes the table as JSON
//   docs/hardware.md   replaces the table in this page
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>

#include "../trot/report/json.hpp"
#include "campaign_run.hpp"

namespace {

using namespace hil;
using limited_run = in_memory<limited>;
using t = hw::bus_trouble;

template <std::size_t Drive, class Run>
auto& drive(Run& r) {
  return std::get<Drive>(r.far.drives);
}

// Another node holds bus 0 for this beat.
template <class Run>
void hold(Run& r) {
  std::array<hw::can_frame, 8> noise;
  noise.fill({.id = hw::standard(0), .length = 8});
  r.wires[0].end(2).send(noise);
}

std::vector<result> campaign(const cca::interruption& interrupted) {
  std::vector<result> all;
  const auto with = [&](const auto& s) {
    if (interrupted) return;  // what is over goes into the table
    all.push_back(run(s));
    std::cerr << '.' << std::flush;
  };
  using s = scenario<limited>;
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
         .each = [](limited_run& r, std::int64_t) { r.controller.get<"saboteur">().not_a_number = true; },
         .mend = [](limited_run& r) { r.controller.get<"saboteur">().not_a_number = false; }});
  with(scenario<unlimited>{
      .fault = "NaN in the controller, limiter switched off",
      .each = [](in_memory<unlimited>& r,
                 std::int64_t) { r.controller.get<"saboteur">().not_a_number = true; },
      .mend = [](in_memory<unlimited>& r) { r.controller.get<"saboteur">().not_a_number = false; }});
  with(s{.fault = "controller stuck on old data",
         .each = [](limited_run& r, std::int64_t) { r.controller.get<"saboteur">().stuck = true; },
         .mend = [](limited_run& r) { r.controller.get<"saboteur">().stuck = false; }});
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
         .each = [](limited_run& r, std::int64_t) { r.controller.get<"robot.emergency_stop">().press(); },
         .mend = [](limited_run& r) { r.controller.get<"robot.emergency_stop">().release(); }});
  with(s{.fault = "soft stop asked for", .beats = 1, .each = [](limited_run& r, std::int64_t) {
           r.controller.get<"robot.emergency_stop">().stop_softly();
         }});
  // Stopping.
  with(s{.fault = "stop() in the middle of the trot", .stops = true});
  with(s{.fault = "stop() while another node holds bus 0",
         .beats = 2,
         .each = [](limited_run& r, std::int64_t) { hold(r); },
         .stops = true});
  with(s{.fault = "stop() with a silent drive",
         .each = [](limited_run& r, std::int64_t) { drive<2>(r).go_silent(true); },
         .mend = [](limited_run& r) { drive<2>(r).clear(); },
         .stops = true});
  with(s{.fault = "a component's fault",
         .each = [](limited_run& r, std::int64_t) { r.controller.get<"saboteur">().gives_up = true; },
         .mend = [](limited_run& r) { r.controller.get<"saboteur">().gives_up = false; }});
  with(s{.fault = "a component's fault while another node holds bus 0",
         .beats = 2,
         .each =
             [](limited_run& r, std::int64_t) {
               hold(r);
               r.controller.get<"saboteur">().gives_up = true;
             },
         .mend = [](limited_run& r) { r.controller.get<"saboteur">().gives_up = false; }});
  with(s{.fault = "a component's fault, and a silent drive",
         .each =
             [](limited_run& r, std::int64_t) {
               drive<6>(r).go_silent(true);
               r.controller.get<"saboteur">().gives_up = true;
             },
         .mend =
             [](limited_run& r) {
               drive<6>(r).clear();
               r.controller.get<"saboteur">().gives_up = false;
             }});
  // The pressed emergency stop.
  with(s{.fault = "emergency stop pressed, the legs are told to spread",
         .each =
             [](limited_run& r, std::int64_t) {
               r.controller.get<"robot.emergency_stop">().press();
               r.controller.get<"spread">().target = 0.3;
             },
         .mend =
             [](limited_run& r) {
               r.controller.get<"robot.emergency_stop">().release();
               r.controller.get<"spread">().target = 0;
             }});
  with(s{.fault = "emergency stop pressed, then started again and again",
         .each =
             [](limited_run& r, std::int64_t k) {
               r.controller.get<"robot.emergency_stop">().press();
               if (k % 20 == 10) r.controller.get<"robot.synchronizer">().start();
             },
         .mend = [](limited_run& r) { r.controller.get<"robot.emergency_stop">().release(); }});
  // What is measured.
  for (const auto& [what, scale] :
       {std::pair{"velocity frozen at 0", 0.0}, std::pair{"velocity of the wrong sign", -1.0},
        std::pair{"velocity 2.2 times too large", 2.2}})
    with(s{.fault = what,
           .each = [to = scale](limited_run& r, std::int64_t) { r.speed_scale[2] = to; },
           .mend = [](limited_run& r) { r.speed_scale[2] = 1; }});
  with(s{.fault = "calibration changed while it runs",
         .each = [](limited_run& r,
                    std::int64_t) { r.controller.get<"robot.synchronizer">().p.offset[0] = 0.5; },
         .mend = [](limited_run& r) { r.controller.get<"robot.synchronizer">().p.offset[0] = 0; }});
  with(s{.fault = "sensor board faulty",
         .each =
             [](limited_run& r, std::int64_t) {
               auto reading = r.robot.board();
               reading.status = 1;
               r.far.board_silent = true;  // this sends in its place
               r.wires[4].end(2).send(board::frames(reading, 0));
             },
         .mend = [](limited_run& r) { r.far.board_silent = false; }});
  std::cerr << '\n';
  return all;
}

constexpr std::string_view head =
    "| fault | first cause | found by, after beats | safe after | joint moves, rad | torque, N m | outside "
    "limits | restarts |\n";

std::string table_of(const std::vector<result>& all) {
  std::ostringstream out;
  out << head << "|---|---|---|---|---|---|---|---|\n" << std::fixed;
  for (const result& r : all) {
    const bool found = r.beats_to_detect >= 0;
    out << "| " << r.fault << " | "
        << (!found                  ? "goes on"
            : r.first_cause.empty() ? "-"
                                    : r.first_cause)
        << " | " << r.detected_by << (found ? ", " + std::to_string(r.beats_to_detect) : "") << " | "
        << (found ? std::to_string(r.beats_to_safe) : "-") << " | " << std::setprecision(2) << r.max_excursion
        << " | " << std::setprecision(1) << r.max_torque << " | " << r.sent_outside_limits << " of " << r.sent
        << " | " << (r.recovered ? "yes" : "no") << " |\n";
  }
  return out.str();
}

std::string json_of(const std::vector<result>& all) {
  trot::json list = trot::json::array();
  for (const result& r : all)
    list.push_back({{"fault", r.fault},
                    {"first_cause", r.first_cause},
                    {"detected_by", r.detected_by},
                    {"beats_to_detect", r.beats_to_detect < 0 ? trot::json() : trot::json(r.beats_to_detect)},
                    {"beats_to_safe", r.beats_to_safe},
                    {"max_excursion_rad", r.max_excursion},
                    {"max_torque_nm", r.max_torque},
                    {"set_points_sent", r.sent},
                    {"sent_outside_limits", r.sent_outside_limits},
                    {"recovered", r.recovered}});
  std::ostringstream out;
  trot::write(out, list);
  return out.str();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": could not be written to its end");
}

// The page with the new table.
std::string renewed(const std::string& path, const std::string& table) {
  std::ostringstream page;
  page << std::ifstream(path).rdbuf();
  std::string text = page.str();
  const std::size_t from = text.find(head), to = text.find("\n\n", from);
  if (to == std::string::npos) throw std::runtime_error(path + ": has no table of the campaign");
  return text.replace(from, to + 1 - from, table);
}

int run_campaign(const std::vector<std::string>& files) {
  const cca::interruption interrupted;
  const auto all = campaign(interrupted);
  const std::string table = table_of(all);
  std::cout << table;
  if (files.size() > 0) write(files[0], json_of(all));
  if (files.size() > 1 && !interrupted) write(files[1], renewed(files[1], table));
  int bad = 0;
  for (const result& r : all)
    if (!r.good()) {
      std::cerr << r.fault << ": " << (r.recovered ? "" : "does not recover; ")
                << (r.beats_to_safe > 3 ? "is not safe within 3 beats; " : "")
                << (r.sent_outside_limits ? "a set-point outside of the limits was sent; " : "")
                << (r.lost_beats == r.expected_lost_beats
                        ? ""
                        : "lost " + std::to_string(r.lost_beats) + " beats, not " +
                              std::to_string(r.expected_lost_beats))
                << '\n';
      ++bad;
    }
  if (interrupted)
    std::cerr << "hardware_in_the_loop_faults: interrupted after " << all.size() << " faults\n";
  return interrupted ? interrupted.exit_code() : bad ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
  std::vector<std::string> files;
  cca::command_line line("the trot on virtual drives, and everything that can go wrong");
  line.words("[FILE [PAGE]]", files, 2,
             "writes the table as JSON, and replaces that of the page, docs/hardware.md");
  return cca::run_program(count, words, line, [&] { return run_campaign(files); });
}
