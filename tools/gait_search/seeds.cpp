// The trot from many disturbance seeds, on all cores: how often it falls, how fast it is, how straight, how
// far its feet slip, and how long they stand.
//
//   trot_seeds --config trot.toml --count 100 --summary seeds.json
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/runtime/interruption.hpp>

#include "../../examples/trot/report/command_line.hpp"
#include "../../examples/trot/report/parallel.hpp"
#include "../../examples/trot/report/program.hpp"
#include "../../examples/trot/report/progress.hpp"
#include "../../examples/trot/rollout.hpp"
#include "../../examples/trot/report/statistics.hpp"

namespace {

struct options {
  std::string config, summary;
  cca::sim::terrain ground = cca::sim::terrain::flat();
  std::uint64_t first = 0, count = 100;
  double seconds = 20;
};

constexpr std::string_view usage =
    "trot_seeds: the trot from many disturbances, on all cores\n"
    "\n"
    "  --config FILE     parameters (the defaults in the code)\n"
    "  --first N         the first seed (0)\n"
    "  --count N         how many (100)\n"
    "  --seconds S       of each, simulated (20)\n"
    "  --terrain T       flat, slope[:degrees] or steps[:millimetres] (flat)\n"
    "  --summary FILE    falls, speed, drift, slip and duty as one JSON object\n"
    "  --version         the version of cca\n"
    "  --help            this text\n";

options parse(const std::vector<std::string>& arguments) {
  options o;
  trot::option_reader read;
  read.text("--config", o.config);
  read.text("--summary", o.summary);
  read.value("--terrain", [&o](const std::string& text) { o.ground = trot::detail::ground(text); });
  read.whole_number("--first", o.first);
  read.whole_number("--count", o.count, 1);
  read.number("--seconds", o.seconds, 1, 3600);
  read.all(arguments);
  return o;
}

int run(const options& o) {
  const cca::interruption interrupted;  // ctrl-c: the figures are of the runs that are over
  trot::trotting start;
  if (o.config.empty()) start.load();
  else start.load(o.config);

  std::vector<trot::statistics> all(o.count);
  std::vector<char> over(o.count, 0);
  trot::progress_bar bar("seeds");
  trot::on_all_cores(
      all.size(),
      [&](std::size_t i) {
        if (interrupted) return;
        trot::trotting controller = start;
        const auto disturbance = cca::sim::disturbance::from_seed(o.first + i, o.seconds);
        all[i] = trot::evaluate(trot::roll_out(controller, o.ground, disturbance, o.seconds,
                                               [&](const cca::sim::world&, double) { return !interrupted; }));
        over[i] = !interrupted;
      },
      [&](std::size_t finished) {
        bar.show(static_cast<double>(finished) / static_cast<double>(all.size()));
      });
  bar.done();
  std::vector<std::uint64_t> seeds;
  for (std::size_t i = 0; i < over.size(); ++i)
    if (over[i]) all[seeds.size()] = all[i], seeds.push_back(o.first + i);
  all.resize(seeds.size());
  if (interrupted) std::cerr << "trot_seeds: interrupted after " << all.size() << " runs\n";
  if (all.empty()) return interrupted.exit_code();

  std::size_t falls = 0;
  double slowest = 1e9, aside = 0, roll = 0, pitch = 0, most_slip = 0;
  double speed = 0, slip = 0, friction = 0;  // means over the runs that stood
  std::array<double, 4> duty{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const trot::statistics& s = all[i];
    if (all.size() <= 20 || s.fell)
      std::printf(
          "  seed %3zu  %.3f m/s  drift %+.3f m  roll %4.1f  pitch %4.1f deg  slip %.3f m/s  duty %.2f %.2f "
          "%.2f %.2f%s\n",
          static_cast<std::size_t>(seeds[i]), s.speed, s.drift, s.max_roll * 57.2958, s.max_pitch * 57.2958,
          s.foot_slip, s.duty_factor[0], s.duty_factor[1], s.duty_factor[2], s.duty_factor[3],
          s.fell ? "  FELL" : "");
    roll = std::max(roll, s.max_roll);
    pitch = std::max(pitch, s.max_pitch);
    if (s.fell) {
      ++falls;
      continue;
    }
    speed += s.speed;
    slowest = std::min(slowest, s.speed);
    aside = std::max(aside, std::abs(s.drift) / s.distance);
    slip += s.foot_slip;
    most_slip = std::max(most_slip, s.foot_slip);
    friction += s.friction_power;
    for (std::size_t leg = 0; leg < duty.size(); ++leg) duty[leg] += s.duty_factor[leg];
  }
  const double stood = static_cast<double>(all.size() - falls),
               rate = static_cast<double>(falls) / static_cast<double>(all.size());
  if (falls == all.size()) slowest = 0;
  for (double* summed : {&speed, &slip, &friction, &duty[0], &duty[1], &duty[2], &duty[3]})
    *summed = stood > 0 ? *summed / stood : 0;
  std::printf(
      "%zu seeds, %.0f s each, %s: %zu fell (%.1f %%); speed %.3f m/s on average, %.3f at least; drift up to "
      "%.1f %%; roll up to %.1f, pitch up to %.1f deg; slip %.3f m/s on average, %.3f at most; friction %.1f "
      "W; "
      "duty %.3f %.3f %.3f %.3f\n",
      all.size(), o.seconds, o.ground.name().c_str(), falls, 100 * rate, speed, slowest, 100 * aside,
      roll * 57.2958, pitch * 57.2958, slip, most_slip, friction, duty[0], duty[1], duty[2], duty[3]);
  if (o.summary.empty()) return interrupted.exit_code();
  char text[512];
  std::snprintf(
      text, sizeof text,
      "{\"seeds\": %zu, \"falls\": %zu, \"fall_rate\": %.6g, \"mean_speed_m_s\": %.6g, "
      "\"least_speed_m_s\": %.6g, "
      "\"greatest_drift_share\": %.6g, \"mean_foot_slip_m_s\": %.6g, \"greatest_foot_slip_m_s\": %.6g, "
      "\"mean_friction_power_w\": %.6g, \"mean_duty_factors\": [%.6g, %.6g, %.6g, %.6g]}\n",
      all.size(), falls, rate, speed, slowest, aside, slip, most_slip, friction, duty[0], duty[1], duty[2],
      duty[3]);
  trot::write(o.summary, [&](std::ostream& file) { file << text; });
  return interrupted.exit_code();
}

}  // namespace

int main(int count, char** arguments) {
  return trot::program("trot_seeds", usage, count, arguments,
                       [](const std::vector<std::string>& given) { return run(parse(given)); });
}
