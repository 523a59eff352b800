// What a trace shows, as tables: for each loop and each of its components how often it fired and how long it
// took. In microseconds, as seen by the monotonic clock; a percentile is rounded up by at most an eighth.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <ios>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/runtime/environments/exchange/histogram.hpp>

namespace cca {

struct trace_summary {
  struct durations {
    histogram all;
    std::int64_t sum = 0;  // ns

    void add(std::int64_t ns) {
      all.add(ns);
      sum += ns;
    }
    double mean() const {
      return all.count() > 0 ? static_cast<double>(sum) / static_cast<double>(all.count()) : 0;
    }
  };
  struct component {
    std::string path;
    std::string_view phase;  // process; of a resource node sense or act
    durations firings;
  };
  struct environment {
    std::string name;
    durations beats, waits;  // waits: in beats, for other environments
    std::int64_t overruns = 0, late = 0, lost_beats = 0, lost_marks = 0;
    std::vector<component> components;  // in the order of their numbers

    // Of the time of all beats.
    double share(const component& one) const {
      return beats.sum > 0 ? static_cast<double>(one.firings.sum) / static_cast<double>(beats.sum) : 0;
    }
  };
  std::vector<environment> environments;
};

namespace detail {

inline void print_durations(std::ostream& to,
                            int width,
                            std::string_view name,
                            const trace_summary::durations& d) {
  to << std::left << std::setw(width) << name << std::right << std::setw(10) << d.all.count() << std::setw(10)
     << d.mean() / 1000 << std::setw(10) << static_cast<double>(d.all.quantile(0.99)) / 1000 << std::setw(10)
     << static_cast<double>(d.all.most()) / 1000;
}

inline std::string name_of_row(const trace_summary::component& one) {
  return one.phase == "process" ? one.path : one.path + " (" + std::string(one.phase) + ")";
}

inline void print_components(std::ostream& to, int width, const trace_summary::environment& e) {
  std::vector<const trace_summary::component*> rows;
  for (const auto& one : e.components)
    if (one.firings.all.count() > 0) rows.push_back(&one);
  std::ranges::sort(rows, [](const auto* a, const auto* b) {
    return a->firings.sum != b->firings.sum ? a->firings.sum > b->firings.sum : a < b;
  });
  for (const auto* one : rows) {
    print_durations(to, width, "  " + name_of_row(*one), one->firings);
    to << std::setw(10) << 100 * e.share(*one) << " %\n";
  }
}

}  // namespace detail

// A line for each environment, and below it one for each component that fired, the costliest first.
inline std::ostream& operator<<(std::ostream& to, const trace_summary& all) {
  std::size_t longest = 20;
  for (const auto& e : all.environments)
    for (const auto& one : e.components) longest = std::max(longest, detail::name_of_row(one).size() + 2);
  const int width = static_cast<int>(longest) + 1;
  const std::ios::fmtflags flags = to.flags();
  const auto precision = to.precision();
  to << std::left << std::setw(width) << "environment, component" << std::right << std::setw(10) << "firings"
     << std::setw(10) << "mean [us]" << std::setw(10) << "p99" << std::setw(10) << "most" << "  of the beat\n"
     << std::fixed << std::setprecision(2);
  for (const auto& e : all.environments) {
    detail::print_durations(to, width, e.name, e.beats);
    to << "  " << e.overruns << " overruns, " << e.late << " late\n";
    detail::print_components(to, width, e);
    if (e.waits.all.count() > 0) {
      detail::print_durations(to, width, "  (waits for others)", e.waits);
      to << '\n';
    }
    if (e.lost_beats > 0) to << "  " << e.lost_beats << " beats are missing: the file was too slow\n";
    if (e.lost_marks > 0) to << "  " << e.lost_marks << " marks are missing\n";
  }
  to.flags(flags);
  to.precision(precision);
  return to;
}

}  // namespace cca
