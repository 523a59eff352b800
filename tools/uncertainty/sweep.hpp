#pragma once
// How much of each kind of uncertainty a program bears: each alone, in growing amounts, from many seeds, on
// all cores, until most runs fail. Printed as rows of a Markdown table.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <cca/main/command_line.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/sim/rollouts.hpp>

#include "../../examples/trot/report/engine.hpp"
#include "kinds.hpp"

namespace uncertain {

// Of one run: it did what it is for, if badly; it was as good as its own judge asks of the ideal robot.
struct verdict {
  bool goes_on = false, is_good = false;
};

struct options {
  std::uint64_t first = 0, count = 10;
  double seconds = 10;
  std::string only;  // kinds with this in their name
  trot::engine engine = trot::engine::compiled;

  void offer(cca::command_line& line) {
    line.whole_number("--first N", first, 0, "the first seed (" + std::to_string(first) + ")");
    line.whole_number("--seeds N", count, 1, "how many (10)");
    line.number("--seconds S", seconds, 3, 3600, "of each run, where it has no end of its own (10)");
    line.text("--only KIND", only, "only kinds with this in their name");
    line.one_of("--engine E", engine, trot::engine_names,
                "the physics: ode, the Open Dynamics Engine, or compiled (compiled)");
  }
};

struct counted {
  double amount;
  std::size_t going, good;
};

// How many runs are so, for the amounts for which not all are.
inline std::string counts(const std::vector<counted>& all, std::size_t counted::* of, std::size_t runs) {
  std::string text;
  char part[48];
  for (const counted& one : all) {
    if (one.*of == runs) continue;
    std::snprintf(part, sizeof part, "%s%g: %d", text.empty() ? "" : ", ", one.amount,
                  static_cast<int>(one.*of));
    text += part;
  }
  return text;
}
// The largest amount up to which all runs are so; in brackets, if it is the largest that was tried.
inline std::string held(const std::vector<counted>& all, std::size_t counted::* of, std::size_t runs) {
  std::string text = "none";
  char part[32];
  for (const counted& one : all) {
    if (one.*of < runs) return text;
    std::snprintf(part, sizeof part, "%g", one.amount);
    text = part;
  }
  return "(" + text + ")";
}

// judge(uncertainty, seed) is a verdict; it is called from several threads.
template <class Judge>
int sweep(const options& o, const Judge& judge) {
  const cca::interruption interrupted;
  const auto tried = [&](const kind* of, double amount) {
    const auto runs = cca::sim::rollouts(o.count,
                                         [&](std::size_t i) {
                                           uncertainty u{};
                                           u.seed = static_cast<std::int64_t>(o.first + i);
                                           if (of) of->set(u, amount);
                                           return judge(u, o.first + i);
                                         },
                                         {.stops = [&] { return bool(interrupted); }});
    counted sum{amount, 0, 0};
    for (const verdict& v : runs) sum.going += v.goes_on, sum.good += v.goes_on && v.is_good;
    return sum;
  };
  if (std::ranges::none_of(kinds(), [&](const kind& k) { return k.name.find(o.only) != k.name.npos; }))
    throw cca::command_line_error("--only " + o.only + ": no kind of uncertainty has this in its name");
  const counted ideal = tried(nullptr, 0);
  std::printf("nothing uncertain: %zu of %d go on, %zu within the bounds (%s)\n\n", ideal.going,
              static_cast<int>(o.count), ideal.good, trot::name_of(o.engine).c_str());
  std::printf(
      "| kind | unit | all within bounds to | fewer | all go on to | fewer |\n|---|---|---|---|---|---|\n");
  for (const kind& k : kinds()) {
    if (k.name.find(o.only) == k.name.npos) continue;
    if (o.engine == trot::engine::compiled && !k.in_compiled_physics) continue;
    std::vector<counted> all;
    for (const double amount : k.amounts) {
      all.push_back(tried(&k, amount));
      if (interrupted) return interrupted.exit_code();
      if (2 * all.back().going < o.count) break;
    }
    std::printf("| %s | %s | %s | %s | %s | %s |\n", std::string(k.name).c_str(), std::string(k.unit).c_str(),
                held(all, &counted::good, o.count).c_str(), counts(all, &counted::good, o.count).c_str(),
                held(all, &counted::going, o.count).c_str(), counts(all, &counted::going, o.count).c_str());
    std::fflush(stdout);
  }
  return 0;
}

// The friction that a disturbance has drawn, times the uncertain factor.
inline cca::sim::terrain ground_under(const uncertainty& u, double friction) {
  return cca::sim::drawn_ground(u, cca::sim::terrain::flat().with_friction(friction));
}

}  // namespace uncertain
