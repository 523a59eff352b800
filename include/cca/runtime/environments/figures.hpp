// How an environment kept up with the clock since start().
#pragma once

#include <cstdint>
#include <iomanip>
#include <ostream>
#include <string_view>
#include <vector>

#include <cca/runtime/environments/exchange/histogram.hpp>

namespace cca {

// In a wall-clock run; in a fast run nothing is counted.
struct environment_figures {
  std::string_view name;
  histogram wake_up;  // from when a beat should begin until it began, ns
  histogram beat;     // how long a beat took, ns
  std::int64_t overruns = 0, lost_periods = 0;
  struct channel {
    std::string_view from;
    std::int64_t late = 0;  // beats that began before the samples were there
  };
  std::vector<channel> channels;
};

// One line for each environment, in microseconds.
inline std::ostream& operator<<(std::ostream& to, const std::vector<environment_figures>& all) {
  const auto put = [&](const histogram& h) {
    for (const double part : {0.5, 0.99, 0.999}) to << std::setw(9) << h.quantile(part) / 1000;
    to << std::setw(9) << h.most() / 1000;
  };
  to << std::left << std::setw(16) << "environment" << std::right << std::setw(9) << "beats"
     << "   wake-up [us] p50      p99    p99.9     most      beat [us] p50      p99    p99.9     most"
     << " overruns     late\n";
  for (const auto& e : all) {
    to << std::left << std::setw(16) << e.name << std::right << std::setw(9) << e.beat.count() << std::setw(9)
       << ' ';
    put(e.wake_up);
    to << std::setw(9) << ' ';
    put(e.beat);
    std::int64_t late = 0;
    for (const auto& channel : e.channels) late += channel.late;
    to << std::setw(9) << e.overruns << std::setw(9) << late << '\n';
  }
  return to;
}

}  // namespace cca
