// The times of one form, and the line of JSON that the program prints for it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace bench {

// How much to measure: `rounds` times all anew, with so many round trips after the first ones.
struct amount {
  int rounds = 5;
  std::size_t round_trips = 1000, warm_up = 100;

  // Through the system's network: discovery takes long, and so does a round trip.
  amount over_network() const {
    return {std::min(rounds, 9), std::min<std::size_t>(round_trips, 300), std::min<std::size_t>(warm_up, 20)};
  }
};

// About 10 ms a round where each has a core, more where they take turns.
inline amount amount_of(int fan_out, std::size_t bytes, bool is_quick) {
  if (is_quick) return {1, 20, 5};
  const double us = (fan_out == 1 ? 1.5 : 10.0 * fan_out) + 2e-3 * static_cast<double>(bytes) * fan_out;
  const auto round_trips = static_cast<std::size_t>(std::clamp(10'000 / us, 40.0, 10'000.0));
  const bool is_large = bytes * static_cast<std::size_t>(fan_out) > (1u << 22);  // set-up takes long
  return {is_large ? 5 : 15, round_trips, round_trips / 10 + 20};
}

// One round, in us. `set_up`: from nothing to the first message that came back.
struct round_of_times {
  std::vector<double> times;
  double set_up = 0;
  std::int64_t wrong = 0;  // messages that came back changed
};

struct figures {
  double mean = 0, p50 = 0, p99 = 0, variance = 0, jitter = 0, set_up = 0;
};

// Jitter is the mean difference between two round trips that follow each other.
inline figures figures_of(const round_of_times& round) {
  figures f;
  std::vector<double> t = round.times;
  const auto count = static_cast<double>(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    f.mean += t[i] / count;
    if (i > 0) f.jitter += std::abs(t[i] - t[i - 1]) / (count - 1);
  }
  for (const double one : t) f.variance += (one - f.mean) * (one - f.mean) / count;
  std::sort(t.begin(), t.end());
  f.p50 = t[t.size() / 2];
  f.p99 = t[t.size() * 99 / 100];
  f.set_up = round.set_up;
  return f;
}

inline double to_five_digits(double number) {
  std::ostringstream text;
  text << std::setprecision(5) << number;
  return std::stod(text.str());
}

// Of each figure the median of all rounds: what disturbs one round does not count.
inline void print(const char* transport,
                  const char* form,
                  int fan_out,
                  std::size_t bytes,
                  const std::vector<round_of_times>& rounds) {
  std::vector<figures> all;
  std::int64_t wrong = 0;
  for (const auto& round : rounds) all.push_back(figures_of(round)), wrong += round.wrong;
  const auto median = [&](double figures::* which) {
    std::nth_element(all.begin(), all.begin() + static_cast<long>(all.size() / 2), all.end(),
                     [&](const figures& a, const figures& b) { return a.*which < b.*which; });
    return all[all.size() / 2].*which;
  };
  nlohmann::ordered_json line{
      {"transport", transport}, {"form", form}, {"fan_out", fan_out}, {"bytes", bytes}};
  const std::pair<const char*, double figures::*> shown[] = {
      {"mean_us", &figures::mean},          {"p50_us", &figures::p50},       {"p99_us", &figures::p99},
      {"variance_us2", &figures::variance}, {"jitter_us", &figures::jitter}, {"set_up_us", &figures::set_up}};
  for (const auto& [name, which] : shown) line[name] = to_five_digits(median(which));
  line["rounds"] = rounds.size();
  line["round_trips"] = rounds.front().times.size();
  line["wrong"] = wrong;
  std::cout << line << std::endl;
}

}  // namespace bench
