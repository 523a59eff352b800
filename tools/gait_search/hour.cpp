// The trot for an hour of simulated time, on flat ground, up a slope, down a slope and up steps: whether it
// falls, how far it comes, and how much memory the program has. Three pushes a minute.
//
// It ends with 1 if the robot falls, or if the memory grows after the first minute.
//
//   trot_hour --config trot.toml --summary hour.json
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <unistd.h>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../../examples/trot/report/engine.hpp"
#include "../../examples/trot/report/file.hpp"
#include "../../examples/trot/report/json.hpp"
#include "../../examples/trot/report/progress.hpp"
#include "../../examples/trot/rollout.hpp"

namespace {

struct compiled_trot : trot::architecture<cca::sim::compiled_oncilla> {};

struct options {
  std::string config, summary;
  std::vector<std::string> grounds{"flat", "slope:6", "slope:-6", "steps:6"};
  double seconds = 3600;
  std::uint64_t seed = 0;
  trot::engine engine = trot::engine::ode;
};

void offer(cca::command_line& line, options& o) {
  line.text("--config FILE", o.config, "parameters (the defaults in the code)");
  line.value(
      "--terrain T",
      [&o](const std::string& text) {
        cca::sim::terrain::named(text);
        o.grounds = {text};
      },
      "one ground only: flat, slope[:degrees] or steps[:millimetres]");
  line.number("--seconds S", o.seconds, 1, 86400, "on each ground, simulated (3600)");
  line.whole_number("--seed N", o.seed, 0, "the disturbances (0)");
  trot::offer_engine(line, o.engine);
  line.text("--summary FILE", o.summary, "falls, way and memory as one JSON array");
  cca::offer_descriptions<trot::trotting>(line, [&o](trot::trotting& c) {
    if (!o.config.empty()) cca::read_parameters(c, o.config);
  });
}

// What the program has in memory now, MB.
double memory() {
  std::ifstream pages("/proc/self/statm");
  double all = 0, resident = 0;
  pages >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

struct result {
  std::string ground;
  double seconds = 0, distance = 0, climbed = 0;   // s, m
  double slowest_minute = 1e9;                     // m/s
  double memory_at_first = 0, memory_at_last = 0;  // MB, after the first minute and at the end
  bool fell = false;

  // A byte leaked in each beat is 3.6 MB in an hour; what the system counts may vary by some pages.
  bool memory_grew() const { return memory_at_last > memory_at_first + 1; }
};

template <class Controller>
result run(const Controller& start,
           const options& o,
           const std::string& ground,
           const cca::interruption& interrupted) {
  constexpr double minute = 60;
  Controller controller = start;
  const auto shape = cca::sim::terrain::named(ground);
  auto& simulator = controller.template get<"robot.simulator">();
  const auto disturbance_from = [&](int minutes) {
    auto d = cca::sim::disturbance::from_seed(o.seed + static_cast<std::uint64_t>(minutes), minute);
    for (auto& push : d.pushes) push.start += minute * minutes;
    return d;
  };
  const auto first = disturbance_from(0);
  simulator.put_down(trot::world_of<Controller>(shape.with_friction(first.friction),
                                                trot::put_down(controller.template get<"gait">().p, first)),
                     first);
  const cca::sim::vector3 began = simulator.world().trunk_position();
  result r{.ground = ground};
  trot::progress_bar bar(ground);
  double last_x = began[0];
  controller.start();
  const auto beats = std::llround(o.seconds * 1000), beats_a_minute = std::llround(minute * 1000);
  for (long long k = 1; k <= beats && !r.fell && !interrupted && controller.step(); ++k) {
    const auto& world = simulator.world();
    r.fell = world.fallen();
    if (k % beats_a_minute != 0) continue;
    const int minutes = static_cast<int>(k / beats_a_minute);
    const double x = world.trunk_position()[0];
    r.slowest_minute = std::min(r.slowest_minute, (x - last_x) / minute);
    last_x = x;
    r.memory_at_last = memory();
    if (minutes == 1) r.memory_at_first = r.memory_at_last;
    simulator.disturb(disturbance_from(minutes));
    bar.show(static_cast<double>(k) / static_cast<double>(beats), "");
  }
  bar.done();
  r.seconds = simulator.world().time();
  r.distance = simulator.world().trunk_position()[0] - began[0];
  r.climbed = simulator.world().trunk_position()[2] - began[2];
  if (r.seconds < minute) r.slowest_minute = r.distance / r.seconds;
  return r;
}

template <class Trot>
int run(const options& o) {
  const cca::interruption interrupted;  // ctrl-c: the figures are of what it has walked
  cca::controller<Trot> start;
  if (o.config.empty()) start.load();
  else start.load(o.config);
  trot::json all = trot::json::array();
  bool fell = false, grew = false;
  for (const std::string& ground : o.grounds) {
    if (interrupted) break;
    const result r = run(start, o, ground, interrupted);
    fell = fell || r.fell;
    grew = grew || r.memory_grew();
    std::printf(
        "%-8s %s after %.0f s: %.0f m, %+.1f m high, %.3f m/s, in the slowest minute %.3f; "
        "%.1f MB after a minute, %.1f MB at the end%s\n",
        r.ground.c_str(), r.fell ? "FELL" : "stands", r.seconds, r.distance, r.climbed,
        r.distance / r.seconds, r.slowest_minute, r.memory_at_first, r.memory_at_last,
        r.memory_grew() ? ": IT GROWS" : "");
    std::fflush(stdout);
    all.push_back({{"terrain", r.ground},
                   {"fell", r.fell},
                   {"seconds", r.seconds},
                   {"distance_m", r.distance},
                   {"climbed_m", r.climbed},
                   {"slowest_minute_m_s", r.slowest_minute},
                   {"memory_after_a_minute_mb", r.memory_at_first},
                   {"memory_at_the_end_mb", r.memory_at_last}});
  }
  if (!o.summary.empty()) trot::write(o.summary, [&](std::ostream& file) { trot::write(file, all); });
  if (interrupted) std::cerr << "trot_hour: interrupted\n";
  return interrupted ? interrupted.exit_code() : fell || grew ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
  options o;
  cca::command_line line("the trot for an hour, on flat ground, up a slope, down a slope and up steps");
  offer(line, o);
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? run<compiled_trot>(o) : run<trot::simulated_trot>(o);
  });
}
