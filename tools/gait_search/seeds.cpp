// The trot from many disturbance seeds, on all cores: how often it falls, how fast it is, how straight, how
// far its feet slip, and how long they stand. With --bounds it ends with 1 if a run misses one of
// report/bounds.hpp.
//
//   trot_seeds --config trot.toml --count 20 --terrain slope:6 --bounds --summary seeds.json
//   trot_seeds --engine compiled --uncertain    each robot and ground differs from its description
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../../examples/trot/report/bounds.hpp"
#include "../../examples/trot/report/command_line.hpp"
#include "../../examples/trot/report/engine.hpp"
#include "../../examples/trot/report/file.hpp"
#include "../../examples/trot/report/finished_runs.hpp"
#include "../../examples/trot/report/json.hpp"
#include "../../examples/trot/report/statistics.hpp"
#include "../../examples/trot/idle_robot.hpp"
#include "../../examples/trot/own_run.hpp"
#include "../../examples/trot/rollout.hpp"
#include "../../examples/trot/uncertain.hpp"

namespace {

using described = cca::controller<trot::architecture<trot::idle_robot>>;

struct options {
  std::string config, summary;
  cca::sim::terrain ground = cca::sim::terrain::flat();
  std::uint64_t first = 0, count = 100;
  double seconds = 20;
  bool bounds = false, uncertain = false;
  trot::engine engine = trot::engine::ode;
};

void offer(cca::command_line& line, options& o) {
  line.text("--config FILE", o.config, "parameters (the defaults in the code)");
  line.whole_number("--first N", o.first, 0, "the first seed (0)");
  line.whole_number("--count N", o.count, 1, "how many (100)");
  line.number("--seconds S", o.seconds, 1, 3600, "of each, simulated (20)");
  trot::offer_terrain(line, o.ground);
  trot::offer_engine(line, o.engine);
  line.flag("--uncertain", o.uncertain, "robots and grounds differ from their description, in each run");
  line.text("--summary FILE", o.summary,
            "falls, speed, drift, slip and duty, of all and of each, as one JSON object");
  line.flag("--bounds", o.bounds, "ends with 1 if a run falls, is slow, slips, or stands too long or short");
  cca::offer_descriptions<described>(line, [&o](described& c) {
    if (!o.config.empty()) cca::read_parameters(c, o.config);
  });
}

template <class World>
int run(const options& o) {
  const cca::interruption interrupted;  // ctrl-c: the figures are of the runs that are over
  using controller = cca::controller<trot::uncertain_trot<trot::beside<World>>>;
  controller start;
  if (o.config.empty()) start.load();
  else start.load(o.config);

  struct run_of_seed {
    std::uint64_t seed;
    trot::statistics figures;
  };
  const std::vector<run_of_seed> all =
      trot::finished_runs("trot_seeds", o.count, interrupted, [&](std::size_t i) {
        const std::uint64_t seed = o.first + i;
        const auto begin = [&, seed](controller& of) {
          return trot::on_drawn_ground(
              of, o.uncertain ? trot::drawn_uncertainty(seed) : cca::sim::uncertainty{},
              cca::sim::disturbance::from_seed(seed, o.seconds), o.ground,
              [&](auto& c, const auto& ground, const auto& disturbance, const auto& settings) {
                return trot::run_in_steps(c, trot::begin(c, ground, disturbance, o.seconds, settings),
                                          o.seconds, [&interrupted] { return !interrupted; });
              });
        };
        return trot::run_of(start, begin, [seed](const trot::recording& run, const controller&) {
          return run_of_seed{seed, trot::evaluate(run)};
        });
      });

  const double commanded = start.template get<"gait">().p.duty;
  std::size_t falls = 0, beyond = 0;
  trot::json runs = trot::json::array();
  double slowest = 1e9, slowest_cruise = 1e9, most_off_duty = 0, aside = 0, roll = 0, pitch = 0,
         most_slip = 0;
  double speed = 0, cruise = 0, slip = 0, friction = 0;  // means over the runs that stood
  std::array<double, 4> duty{};
  for (const auto& [seed, s] : all) {
    const double off_duty = trot::farthest_off_duty(s, commanded);
    const bool kept = trot::keeps(s, commanded);
    beyond += !kept;
    runs.push_back({{"seed", seed},
                    {"fell", s.fell},
                    {"speed_m_s", s.speed},
                    {"cruise_speed_m_s", s.cruise},
                    {"foot_slip_m_s", s.foot_slip},
                    {"duty_factors", s.duty_factor},
                    {"farthest_off_duty", off_duty},
                    {"within_bounds", kept}});
    if (all.size() <= 20 || s.fell)
      std::printf(
          "  seed %3zu  %.3f m/s, cruise %.3f  drift %+.3f m  roll %4.1f  pitch %4.1f deg  slip %.3f m/s  "
          "duty "
          "%.2f %.2f %.2f %.2f%s%s\n",
          static_cast<std::size_t>(seed), s.speed, s.cruise, s.drift, s.max_roll * 57.2958,
          s.max_pitch * 57.2958, s.foot_slip, s.duty_factor[0], s.duty_factor[1], s.duty_factor[2],
          s.duty_factor[3], s.fell ? "  FELL" : "", kept ? "" : "  beyond the bounds");
    roll = std::max(roll, s.max_roll);
    pitch = std::max(pitch, s.max_pitch);
    if (s.fell) {
      ++falls;
      continue;
    }
    speed += s.speed;
    slowest = std::min(slowest, s.speed);
    cruise += s.cruise;
    slowest_cruise = std::min(slowest_cruise, s.cruise);
    most_off_duty = std::max(most_off_duty, off_duty);
    aside = std::max(aside, std::abs(s.drift) / s.distance);
    slip += s.foot_slip;
    most_slip = std::max(most_slip, s.foot_slip);
    friction += s.friction_power;
    for (std::size_t leg = 0; leg < duty.size(); ++leg) duty[leg] += s.duty_factor[leg];
  }
  const double stood = static_cast<double>(all.size() - falls),
               rate = all.empty() ? 0 : static_cast<double>(falls) / static_cast<double>(all.size());
  if (falls == all.size()) slowest = slowest_cruise = 0;
  for (double* summed : {&speed, &cruise, &slip, &friction, &duty[0], &duty[1], &duty[2], &duty[3]})
    *summed = stood > 0 ? *summed / stood : 0;
  std::printf(
      "%zu seeds, %.0f s each, %s%s: %zu fell (%.1f %%), %zu beyond the bounds; speed %.3f m/s on average, "
      "%.3f "
      "at least; cruise %.3f, %.3f at least; drift up to %.1f %%; roll up to %.1f, pitch up to %.1f deg; "
      "slip "
      "%.3f m/s on average, %.3f at most; friction %.1f W; duty %.3f %.3f %.3f %.3f, up to %.3f off\n",
      all.size(), o.seconds, o.ground.name().c_str(), o.uncertain ? ", uncertain" : "", falls, 100 * rate,
      beyond, speed, slowest, cruise, slowest_cruise, 100 * aside, roll * 57.2958, pitch * 57.2958, slip,
      most_slip, friction, duty[0], duty[1], duty[2], duty[3], most_off_duty);
  const int outcome = interrupted ? interrupted.exit_code() : o.bounds && beyond > 0 ? 1 : 0;
  if (o.summary.empty()) return outcome;
  const trot::json summary{{"seeds", all.size()},
                           {"engine", trot::name_of(o.engine)},
                           {"uncertain", o.uncertain},
                           {"falls", falls},
                           {"fall_rate", rate},
                           {"beyond_bounds", beyond},
                           {"mean_speed_m_s", speed},
                           {"least_speed_m_s", slowest},
                           {"mean_cruise_speed_m_s", cruise},
                           {"least_cruise_speed_m_s", slowest_cruise},
                           {"greatest_drift_share", aside},
                           {"mean_foot_slip_m_s", slip},
                           {"greatest_foot_slip_m_s", most_slip},
                           {"mean_friction_power_w", friction},
                           {"mean_duty_factors", duty},
                           {"commanded_duty_factor", commanded},
                           {"farthest_off_duty", most_off_duty},
                           {"runs", runs}};
  trot::write(o.summary, [&](std::ostream& file) { trot::write(file, summary); });
  return outcome;
}

}  // namespace

int main(int count, char** words) {
  options o;
  cca::command_line line("the trot from many disturbances, on all cores");
  offer(line, o);
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? run<cca::sim::compiled_oncilla_world>(o)
                                              : run<cca::sim::world>(o);
  });
}
