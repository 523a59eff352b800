// The controller of the trot moves virtual drives around the simulated Oncilla, over CAN buses.
//
//   hardware_in_the_loop [--seconds N]
//       both ends in this process, on buses in memory
//   hardware_in_the_loop --role drives --buses vcan0,...,vcan4
//       the far end: drives, sensor board, mechanics
//   hardware_in_the_loop --role robot --buses vcan0,...,vcan4
//       the controller, in a second process; it is the program for a real robot
//   ... --pace lock-step
//       for all: on a machine that is too slow for real time; for a live twin (docs/door.md)
//   hardware_in_the_loop --replay run.mcap
//       computes a recording of it again, and compares
//
// Exit code 0: nothing tripped and, where the program can see it, the robot came forward and has not fallen.
// Role `drives`: 2 if all drives stopped by their watchdogs.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/runtime/signals/write_if_possible.hpp>
#include <cca/cca.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/main.hpp>
#include <cca/robots/oncilla/legged_body.hpp>
#include <cca/runtime/interruption.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>                // offers --record
#include <cca/record/replay_option.hpp>  // offers --replay
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

#include "lock_step.hpp"
#include "two_environments.hpp"

namespace {

using namespace hil;

struct wishes {
  std::string role;
  bool lock_step = false;
  std::vector<std::string> names;
  cca::run_settings run{.seconds = 5};  // of the controller

  void offer(cca::command_line& line) {
    line.number("--seconds S", run.seconds, 0.001, 36000, "how long (5)");
    line.one_of(
        "--role R", [this](std::size_t i) { role = i == 0 ? "robot" : "drives"; },
        std::array{"robot", "drives"},
        "robot or drives: one of two processes, on the buses of --buses; without it both\n"
        "are in this process, on buses in memory");
    line.value(
        "--buses A,B,C,D,E", [this](const std::string& text) { split(text); }, "the five CAN interfaces");
    line.one_of("--pace P", lock_step, std::array{"wall-clock", "lock-step"},
                "wall-clock or lock-step (wall-clock)");
    line.texts("--config FILE", run.configs, "parameters of the controller");
    line.flag("--paused", run.paused, "waits before its first beat until it is told to go on");
    line.flag("--quiet", run.quiet, "prints no figures");
    line.text("--record FILE", run.record, "records all ports of the controller into this MCAP file");
    line.text("--page FILE", run.page, "records into this HTML file, which any browser shows");
    line.text("--trace FILE", run.trace, "writes when each component fires, for ui.perfetto.dev");
    line.one_of(
        "--on-fault W", [this](std::size_t i) { run.on_fault = i == 0 ? "end" : "hold"; },
        std::array{"end", "hold"}, "end, or hold: until it is told to resume or to start anew (end)");
  }
  void refuse_contradictions() const {
    if (role.empty() != names.empty())
      throw cca::command_line_error("--role and --buses come together: the role, and five CAN interfaces");
    if (role == "drives" && (run.door || !(run.record.empty() && run.page.empty() && run.trace.empty())))
      throw cca::command_line_error(
          "--record, --page, --trace and --door: of the controller, not of the drives");
  }

private:
  void split(const std::string& text) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(',', from), text.size());
      names.push_back(text.substr(from, to - from));
      from = to + 1;
    }
    if (names.size() != buses)
      throw cca::command_line_error("--buses " + text + ": expected the names of five CAN interfaces");
  }
};

// How the run has ended, noted before the robot is shut down.
struct run_end {
  bool runs = false;
  hw::safety_event cause{};

  template <class Controller>
  static run_end of(Controller& c) {
    const auto& stop = c.template get<"robot.emergency_stop">();
    return {stop.mode() == hw::motion_mode::run, stop.first_cause()};
  }
  std::string text() const {
    if (runs) return "robot: runs, nothing tripped\n";
    std::string all = "robot: stopped; first cause: " + std::string(hw::name_of(cause.rule));
    if (cause.joint >= 0) all += " of " + std::string(joints::names[static_cast<std::size_t>(cause.joint)]);
    return all + ", beat " + std::to_string(cause.beat) + '\n';
  }
};

// It can be looked at.
template <class Bus>
struct observed
    : two_environments<Bus>,
      cca::recordable,
      cca::traceable,
      cca::shows<cca::robots::oncilla::legged_body, "robot.angles", "robot.synchronizer.orientation"> {};

// Both ends in this process.
struct in_one_process : cca::robot_program<observed<memory_end>> {
  explicit in_one_process(const wishes& o) {
    settings = o.run;
    if (!settings.door || o.lock_step) settings.speed.reset();  // the buses have virtual time
    is_watched = settings.door && o.lock_step;
    offers.push_back(
        {.name = "push",
         .help = "pushes the trunk",
         .arguments = {{"forward", 10, -60, 60, "N"}, {"left", 0, -60, 60, "N"}},
         .begin = [this](controller_type&, std::span<const double> n) { far.push({n[0], n[1], 0}); },
         .end = [this](controller_type&) { far.push({0, 0, 0}); }});
    offers.push_back({.name = "put_down",
                      .help = "in a pause: lifts it and puts it down as at its start, for a start anew",
                      .begin = [this](controller_type&, auto) { far.put_down(hil::put_down(), {}); },
                      .only_at_rest = true});
  }

  void prepare(controller_type& c) override {
    far.connect(c);
    std::printf("no buses given: both ends in this process, on five buses in memory of 1 Mbit/s\n");
  }
  bool between(controller_type& c) override {
    if (is_watched) wait_for_clock();
    far.pass_millisecond();
    if (c.beat_index() % 1000 == 0)
      std::printf("%2lld s: %.2f m\n", static_cast<long long>(c.beat_index() / 1000),
                  far.world().trunk_position()[0]);
    return true;
  }
  void rests(controller_type&) override { far.pass_millisecond(); }
  void stop(controller_type& c) override {
    const run_end end = run_end::of(c);
    const bool has_fallen = far.world().fallen();
    const auto off = far.shut_down(c);
    if (has_fallen) std::printf("the robot fell\n");
    std::fputs(end.text().c_str(), stdout);
    std::printf("robot: %s\n", off.text().c_str());
    std::printf("drives: %s\n", far.are_free() ? "switched off" : "still driven");
    result = (end.runs ? 0 : 1) + (has_fallen ? 1 : 0);
    if (!far.are_free()) result = 1;
  }
  int finish(controller_type&) override { return result; }

private:
  // Who looks, pushes and tunes sees it as fast as it would walk, or slower. What was late is not caught up.
  void wait_for_clock() {
    using namespace std::chrono_literals;
    next_beat = std::max(next_beat + 1ms, std::chrono::steady_clock::now());
    std::this_thread::sleep_until(next_beat);
  }

  memory_buses far;
  bool is_watched = false;
  std::chrono::steady_clock::time_point next_beat{};
  int result = 0;
};

using bus_array = std::array<paced_can, buses>;
// Each end receives only the ids that the other end sends: the kernel filters all others.
template <std::size_t... Bus>
bus_array open_buses(const wishes& o, std::index_sequence<Bus...>) {
  using plan = hw::robot_buses<cca::rate<1000>, board, joints>;
  const auto bus = [&o](std::size_t i, std::span<const hw::can_filter> requests,
                        std::span<const hw::can_filter> replies) {
    if (o.role == "drives") std::swap(requests, replies);
    return paced_can(o.names[i], {.replies = replies, .ours = requests, .gives_up_after = 800'000},
                     o.lock_step);
  };
  return {bus(Bus, plan::requests<Bus>, plan::replies<Bus>)...};
}
bus_array open_buses(const wishes& o) { return open_buses(o, std::make_index_sequence<buses>()); }

// The controller on CAN interfaces: the program for a real robot.
struct on_buses : cca::robot_program<observed<paced_can>> {
  explicit on_buses(const wishes& o) : bus(open_buses(o)), lock_step(o.lock_step) {
    settings = o.run;
    if (lock_step) settings.speed.reset();  // it waits for frames, not for the clock
  }

  void prepare(controller_type& c) override {
    c.get<"robot.synchronizer">().connect(bus[0], bus[1], bus[2], bus[3], bus[4]);
  }
  void started(controller_type& c) override { wait_for_frames(c); }
  bool between(controller_type& c) override {
    const bool ran = runs_now;
    runs_now = c.get<"robot.synchronizer">().phase() == hw::motion_phase::running;
    if (runs_now && !ran) cca::write_if_possible(STDOUT_FILENO, "robot: all drives are enabled\n");
    wait_for_frames(c);
    return true;
  }
  void stop(controller_type& c) override {
    const run_end end = run_end::of(c);
    cca::write_if_possible(STDOUT_FILENO,
                           end.text());  // at once: the buses may be gone before the drives are off
    // [shut down]
    const hw::shut_down_report off = hw::shut_down(c, robots_pace{bus, lock_step});  // then it may be told
    std::printf("robot: %s\n", off.text().c_str());
    // [shut down end]
    if (c.overruns() > 0)
      std::printf("robot: %lld beats took too long, %lld periods without a beat\n",
                  static_cast<long long>(c.overruns()), static_cast<long long>(c.lost_periods()));
    result = end.runs ? 0 : 1;
  }
  int finish(controller_type&) override { return result; }

private:
  static void wait_for_board(bus_array& bus, std::int64_t now) {
    wait_for(std::span(bus), {0, 0, 0, 0, board::replies.size()}, now);
  }
  void wait_for_frames(const controller_type& c) {
    if (lock_step) wait_for_board(bus, c.beat_index() * controller_type::period());
  }
  struct robots_pace {
    bus_array& bus;
    bool lock_step;
    cca::at_speed clock = cca::at_wall_clock();
    void begin() { clock.begin(); }
    void wait(std::int64_t now) {
      if (lock_step) wait_for_board(bus, now);
      else clock.wait(now);
    }
  };

  bus_array bus;
  bool lock_step;
  bool runs_now = false;
  int result = 0;
};

// Reports how the drives ended: still driven, switched off, or stopped by their watchdogs.
int as_drives(const wishes& o) {
  auto bus = open_buses(o);
  far_side<paced_can> far;
  far.connect(bus[0], bus[1], bus[2], bus[3], bus[4]);
  mechanics robot(put_down());
  const std::int64_t beats = std::llround(1000 * *o.run.seconds);
  cca::at_speed clock = cca::at_wall_clock();
  clock.begin();
  const cca::interruption interrupted;
  bool driven = false, free = false, unfed = false;  // unfed: since the beat in which they became free
  double distance = 0;                               // the farthest: it slides back when it sinks
  int off = 0;  // beats: it still answers, so that the controller sees that they are off
  for (std::int64_t k = 1; k <= beats && off < 10 && !interrupted; ++k) {
    const std::int64_t now = k * memory_buses::beat;
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
    robot.move_servos(far.abduction);
    robot.advance(laws);
    far.tell(robot.motions(), robot.board());
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
  wishes o;
  cca::command_line line("the trot moves virtual drives around the simulated Oncilla, over CAN buses");
  o.offer(line);
  using controller = in_one_process::controller_type;
  cca::offer_replay<controller>(line, o.run);
  cca::offer_door<controller>(line, o.run);
  cca::offer_descriptions<controller>(line, [&o](controller& c) {
    for (const std::string& file : o.run.configs) cca::read_parameters(c, file);
  });
  return cca::run_program(count, words, line, [&] {
    o.refuse_contradictions();
    if (o.role == "drives") return as_drives(o);
    const auto run = [&](auto&& robot) { return cca::run_robot(robot, cca::program_name(count, words)); };
    return o.role == "robot" ? run(on_buses(o)) : run(in_one_process(o));
  });
}
