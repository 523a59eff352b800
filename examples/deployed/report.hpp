#pragma once
// The figures of all forms, each compared with the loop: a table for people, JSON for programs.
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

#include "../combination_of_skills/summary.hpp"
#include "../trot/report/json.hpp"
#include "forms.hpp"

namespace deployed {

struct compared_form {
  outcome what;
  record::comparison with_loop;

  // In a wall-clock run only the beats count before the first sample that was late: from then on the results
  // may differ.
  compared_form(outcome one, const outcome& loop)
      : what(std::move(one)), with_loop(loop.seen.compare(what.seen, what.exact_beats)) {}

  bool is_good() const { return with_loop.different == 0 && what.failure.empty(); }
};

inline void print_heading() {
  std::printf("%-14s %-20s %7s %12s %10s %9s %6s %9s %13s\n", "form", "pace", "beats", "compared",
              "different", "ball", "late", "overruns", "wake-up p99");
}

inline void print(const compared_form& one) {
  const outcome& o = one.what;
  std::printf("%-14s %-20s %7lld %12lld %10lld %9s %6lld", o.form.c_str(), o.pace.c_str(),
              static_cast<long long>(o.beats), static_cast<long long>(one.with_loop.compared),
              static_cast<long long>(one.with_loop.different), distance_of(o.judged).c_str(),
              static_cast<long long>(o.late));
  if (o.pace == wall_clock)
    std::printf(" %9lld %10.0f us", static_cast<long long>(o.overruns), o.wake_p99_us);
  std::printf("\n");
  std::fputs(o.figures.c_str(), stdout);
  if (const auto& first = one.with_loop.first)
    std::printf("  the first difference: %s in beat %lld\n", std::string(first->output).c_str(),
                static_cast<long long>(first->beat));
  if (!o.failure.empty()) std::printf("  failed:%s\n", o.failure.c_str());
  std::fflush(stdout);
}

inline void write_json(std::ostream& out, const std::vector<compared_form>& forms) {
  trot::json list = trot::json::array();
  for (const auto& [o, compared] : forms) {
    trot::json one{{"form", o.form},
                   {"pace", o.pace},
                   {"beats", o.beats},
                   {"samples_compared", compared.compared},
                   {"different", compared.different},
                   {"reach_error_mm", o.judged.reach_error * 1e3},
                   {"worst_reach_error_mm", o.judged.worst_error * 1e3},
                   {"speed_after_m_s", o.judged.speed_after},
                   {"fell", o.judged.fell},
                   {"late", o.late}};
    if (o.pace == wall_clock) {
      one["compared_beats"] = o.exact_beats;
      one["overruns"] = o.overruns;
      one["lost_periods"] = o.lost_periods;
      one["wake_p99_us"] = o.wake_p99_us;
    }
    if (compared.first)
      one["first_difference"] = {{"output", compared.first->output}, {"beat", compared.first->beat}};
    if (!o.failure.empty()) one["failure"] = o.failure;
    list.push_back(one);
  }
  trot::write(out, list);
}

}  // namespace deployed
