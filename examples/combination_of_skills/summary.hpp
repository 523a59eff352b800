#pragma once
// The figures of runs: a table of one run for people, a JSON list of many for programs.
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "../trot/report/json.hpp"
#include "rollout.hpp"

namespace skills {

struct finished_run {
  circumstances where;
  result what;
};

// Success: within 5 mm, in 3 s, without a fall.
inline constexpr double allowed_error = 0.005, allowed_time = 3.0;
inline bool succeeded(const result& r) {
  return !r.fell && r.last == plan::at<"trot on"> && r.touched() && r.worst_error <= allowed_error &&
         r.reach_time <= allowed_time;
}

namespace detail {

inline std::string formatted(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

}  // namespace detail

inline std::string_view to_string(outcome how) {
  constexpr std::array<std::string_view, 4> names{"not begun", "going on", "done", "timed out"};
  return names[static_cast<std::size_t>(how)];
}

inline void write_table(std::ostream& out, const circumstances& c, const result& r) {
  using detail::formatted;
  out << "  skill            begins     takes   joints off   status\n";
  for (std::size_t i = 0; i < r.skills.size(); ++i) {
    const episode& s = r.skills[i];
    const std::string_view name = plan::table[i].name;
    if (s.how == outcome::not_begun) continue;
    const bool open = s.how == outcome::going_on;
    out << "  " << name << std::string(15 - name.size(), ' ') << formatted("%6.2f s", s.begin)
        << formatted("  %6.2f s", (open ? r.seconds : s.end) - s.begin)
        << (std::isfinite(s.error) ? formatted("   %6.3f rad", s.error) : std::string(13, ' ')) << "   "
        << (open && r.fell                     ? "fell"
            : open && i + 1 == r.skills.size() ? "done"
                                               : std::string(to_string(s.how)))
        << '\n';
  }
  out << "  ball (" << target_names[static_cast<std::size_t>(c.where)] << ", "
      << paw_names[static_cast<std::size_t>(c.paw)] << " paw): ";
  if (r.touched())
    out << formatted("%.2f mm", r.reach_error * 1e3)
        << formatted(" off (at most %.2f mm)", r.worst_error * 1e3)
        << formatted(", reached in %.2f s", r.reach_time) << formatted("; after a push of %.0f N ", c.push)
        << formatted("%.2f mm off", r.error_after_push * 1e3)
        << formatted(" (at most %.2f mm)\n", r.worst_after_push * 1e3);
  else out << "not reached\n";
  out << formatted("  trotted on at %.3f m/s", r.speed_after) << (r.fell ? "; FELL\n" : "\n");
}

inline void write_json(std::ostream& out, const std::vector<finished_run>& runs) {
  trot::json list = trot::json::array();
  for (const auto& [c, r] : runs)
    list.push_back({{"seed", c.seed ? trot::json(*c.seed) : trot::json()},
                    {"paw", paw_names[static_cast<std::size_t>(c.paw)]},
                    {"target", target_names[static_cast<std::size_t>(c.where)]},
                    {"reach_error_mm", r.reach_error * 1e3},
                    {"worst_reach_error_mm", r.worst_error * 1e3},
                    {"reach_time_s", r.reach_time},
                    {"push_n", c.push},
                    {"worst_error_after_push_mm", r.worst_after_push * 1e3},
                    {"fell", r.fell},
                    {"speed_after_m_s", r.speed_after},
                    {"seconds", r.seconds},
                    {"last_skill", plan::table[static_cast<std::size_t>(r.last)].name}});
  trot::write(out, list);
}

}  // namespace skills
