// The controller of the trot moves virtual drives around the simulated Oncilla, over CAN buses.
//
//   hardware_in_the_loop [--seconds N]
//       both ends in this process, on buses in memory
//   hardware_in_the_loop --role drives --buses vcan0,...,vcan4
//       the far end: drives, sensor board, mechanics
//   hardware_in_the_loop --role robot --buses vcan0,...,vcan4
//       the controller, in a second process; it is the program for a real robot
//   ... --pace lock-step
//       for both: on a machine that is too slow for real time
//
// Exit code 0: nothing tripped and, where the program can see it, the robot came forward and has not fallen.
// Role `drives`: 2 if all drives stopped by their watchdogs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/cca.hpp>
#include <cca/runtime/interruption.hpp>

#include "../trot/report/program.hpp"
#include "lock_step.hpp"
#include "two_environments.hpp"

namespace {

using namespace hil;

struct options {
  std::int64_t beats = 5000;
  std::string role;
  bool lock_step = false;
  std::vector<std::string> names;
};

constexpr std::string_view usage =
    "hardware_in_the_loop: the trot moves virtual drives around the simulated Oncilla, over CAN buses\n"
    "\n"
    "  --seconds S       how long (5)\n"
    "  --role R          robot or drives: one of two processes, on the buses of --buses; without it both\n"
    "                    are in this process, on buses in memory\n"
    "  --buses A,B,C,D,E the five CAN interfaces\n"
    "  --pace P          wall-clock or lock-step (wall-clock)\n"
    "  --version         the version of cca\n"
    "  --help            this text\n";

options parse(const std::vector<std::string>& arguments) {
  options o;
  trot::option_reader read;
  read.value("--seconds", [&o](const std::string& text) {
    o.beats = std::llround(1000 * trot::detail::number("--seconds", text, 0.001, 36000));
  });
  read.value("--role", [&o](const std::string& text) {
    if (text != "robot" && text != "drives")
      throw trot::command_line_error("--role " + text + ": expected robot or drives");
    o.role = text;
  });
  read.value("--pace", [&o](const std::string& text) {
    if (text != "wall-clock" && text != "lock-step")
      throw trot::command_line_error("--pace " + text + ": expected wall-clock or lock-step");
    o.lock_step = text == "lock-step";
  });
  read.value("--buses", [&o](const std::string& text) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(',', from), text.size());
      o.names.push_back(text.substr(from, to - from));
      from = to + 1;
    }
    if (o.names.size() != buses)
      throw trot::command_line_error("--buses " + text + ": expected the names of five CAN interfaces");
  });
  read.all(arguments);
  if (o.role.empty() != o.names.empty())
    throw trot::command_line_error("--role and --buses come together: the role, and five CAN interfaces");
  return o;
}

template <class Controller>
int report(Controller& c) {
  const auto& stop = c.template get<"robot.emergency_stop">();
  const hw::safety_event cause = stop.first_cause();
  const bool runs = stop.mode() == hw::motion_mode::run;
  if (runs) std::printf("robot: runs, nothing tripped\n");
  else
    std::printf(
        "robot: stopped; first cause: %s%s%s, beat %lld\n", std::string(hw::name_of(cause.rule)).c_str(),
        cause.joint < 0 ? "" : " of ",
        cause.joint < 0 ? "" : std::string(joints::names[static_cast<std::size_t>(cause.joint)]).c_str(),
        static_cast<long long>(cause.beat));
  return runs ? 0 : 1;
}

int in_one_process(std::int64_t beats) {
  std::printf("no buses given: both ends in this process, on five buses in memory of 1 Mbit/s\n");
  const cca::interruption interrupted;  // ctrl-c: the controller stops the drives, then the program ends
  two_in_memory run;
  run.controller.load();
  run.controller.start();
  run.run(beats, [&](const auto& c) {
    if (const long long k = c.beat_index(); k % 1000 == 0)
      std::printf("%2lld s: %.2f m\n", k / 1000, run.robot.world.trunk_position()[0]);
    return !interrupted;
  });
  if (run.robot.world.fallen()) std::printf("the robot fell\n");
  const int result = report(run.controller) + (run.robot.world.fallen() ? 1 : 0);
  std::printf("%s\n", run.shut_down().text().c_str());
  return interrupted ? interrupted.exit_code() : result;
}

using bus_array = std::array<paced_can, buses>;
// Each end receives only the ids that the other end sends: the kernel filters all others.
template <std::size_t... Bus>
bus_array open(const options& o, std::index_sequence<Bus...>) {
  using plan = hw::robot_buses<cca::rate<1000>, board, joints>;
  const auto bus = [&o](std::size_t i, std::span<const hw::can_filter> requests,
                        std::span<const hw::can_filter> replies) {
    if (o.role == "drives") std::swap(requests, replies);
    return paced_can(o.names[i], {.replies = replies, .ours = requests, .gives_up_after = 800'000},
                     o.lock_step);
  };
  return {bus(Bus, plan::requests<Bus>, plan::replies<Bus>)...};
}
bus_array open(const options& o) { return open(o, std::make_index_sequence<buses>()); }

// A beat begins when the frames of the sensor board have come.
struct pace_of_frames {
  bus_array& bus;
  void begin() const {}
  void wait(std::int64_t now) const { wait_for(std::span(bus), {0, 0, 0, 0, board::replies.size()}, now); }
};

template <class Pace>
int as_robot(const options& o, bus_array& bus, Pace pace) {
  cca::deployed<two_environments<paced_can>> c;
  auto& drives = c.get<"robot.synchronizer">();
  drives.connect(bus[0], bus[1], bus[2], bus[3], bus[4]);
  c.load();
  c.start();
  const cca::interruption interrupted;
  bool runs = false;
  c.run(cca::for_some_beats{o.beats}, pace, [&](const auto&) {
    if (std::exchange(runs, drives.phase() == hw::motion_phase::running) || !runs) return !interrupted;
    std::puts("robot: all drives are enabled");
    std::fflush(stdout);
    return !interrupted;
  });
  const int result = report(c);
  if (c.fault()) std::printf("robot: %s\n", c.fault().reason());
  if (c.overruns() > 0)
    std::printf("robot: %lld beats took too long, %lld periods without a beat\n",
                static_cast<long long>(c.overruns()), static_cast<long long>(c.lost_periods()));
  if (!o.lock_step) std::cout << c.figures();
  // [shut down]
  std::printf("robot: %s\n", hw::shut_down(c, pace).text().c_str());
  // [shut down end]
  return interrupted ? interrupted.exit_code() : result;
}

int as_robot(const options& o) {
  auto bus = open(o);
  return o.lock_step ? as_robot(o, bus, pace_of_frames{bus}) : as_robot(o, bus, cca::at_wall_clock());
}

// Reports how the drives ended: still driven, switched off, or stopped by their watchdogs.
int as_drives(const options& o) {
  auto bus = open(o);
  far_side<paced_can> far;
  far.connect(bus[0], bus[1], bus[2], bus[3], bus[4]);
  mechanics robot(put_down());
  cca::at_speed clock = cca::at_wall_clock();
  clock.begin();
  const cca::interruption interrupted;
  bool driven = false, free = false, unfed = false;  // unfed: since the beat in which they became free
  double distance = 0;                               // the farthest: it slides back when it sinks
  int off = 0;  // beats: it still answers, so that the controller sees that they are off
  for (std::int64_t k = 1; k <= o.beats && off < 10 && !interrupted; ++k) {
    const std::int64_t now = k * in_memory<>::beat;
    if (o.lock_step) wait_for(std::span(bus), {2, 2, 2, 2, 0}, now);
    else clock.wait(now);
    far.listen(now);
    const auto laws = far.laws(now);
    free = std::none_of(laws.begin(), laws.end(),
                        [](const auto& law) { return law.stiffness > 0 || law.damping > 0; });
    if (!free || off == 0)
      unfed = std::apply([&](const auto&... drive) { return (drive.unfed(now) && ...); }, far.drives);
    driven = driven || !free;
    off = driven && free ? off + 1 : 0;
    robot.advance(laws, far.abduction);
    far.tell(robot.joints(), robot.board());
    distance = std::max(distance, robot.world.trunk_position()[0]);
    if (k % 1000 == 0)
      std::printf("drives: %2lld s: %.2f m\n", static_cast<long long>(k / 1000),
                  robot.world.trunk_position()[0]);
  }
  std::printf("drives: %s, after %.2f m\n",
              !driven         ? "never enabled"
              : free && unfed ? "no set-points: all torque-free by their watchdogs"
              : free          ? "switched off"
                              : "still driven",
              distance);
  if (interrupted) return interrupted.exit_code();
  if (driven && free && unfed) return 2;
  return driven && distance > 0.02 && !robot.world.fallen() ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  return trot::program("hardware_in_the_loop", usage, count, words,
                       [](const std::vector<std::string>& arguments) {
                         const options o = parse(arguments);
                         if (o.role.empty()) return in_one_process(o.beats);
                         return o.role == "robot" ? as_robot(o) : as_drives(o);
                       });
}
