#pragma once
// The figures of a run as a short table for people and as one JSON object for programs.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <ostream>
#include <string>

#include "json.hpp"
#include "recording.hpp"
#include "statistics.hpp"

namespace trot {

struct costs {
  double real_time_factor = 0;  // simulated time / real time, controller and physics
  double controller_ns_per_beat = 0;
  double physics_ns_per_beat = 0;
};

struct circumstances {
  std::optional<std::uint64_t> seed;  // none: no disturbance
  std::string terrain;
  std::string engine = "ode";
};

namespace detail {

inline std::string formatted(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

inline double in_degrees(double radians) { return radians * 57.29577951308232; }

}  // namespace detail

// Without costs, where they were not measured.
inline void write_table(std::ostream& out, const statistics& s, const std::optional<costs>& c) {
  using detail::formatted, detail::in_degrees;
  const auto row = [&](const char* name, const std::string& value) {
    out << "  " << name << std::string(22 - std::char_traits<char>::length(name), ' ') << value << '\n';
  };
  row("distance", formatted("%.2f m", s.distance) + formatted(" in %.1f s", s.seconds) +
                      (s.fell ? ", then it fell" : ""));
  row("speed", formatted("%.3f m/s", s.speed) + formatted(" (%.3f m/s once it trots)", s.cruise));
  row("sideways drift",
      formatted("%+.3f m", s.drift) +
          formatted(" (%.1f %%)", s.distance > 0 ? 100 * std::abs(s.drift) / s.distance : 0));
  row("stride frequency", formatted("%.2f Hz", s.stride_frequency));
  std::string duty;
  for (std::size_t i = 0; i < 4; ++i)
    duty += (i ? ", " : "") + std::string(leg_names[i]) + formatted(" %.2f", s.duty_factor[i]);
  row("duty factor", duty);
  std::string slip;
  for (std::size_t i = 0; i < 4; ++i)
    slip += (i ? ", " : " (") + std::string(leg_names[i]) + formatted(" %.2f", s.slip_of_foot[i]);
  row("foot slip", formatted("%.3f m/s", s.foot_slip) + slip + ")");
  row("friction power", formatted("%.1f W", s.friction_power));
  row("trunk", "roll up to " + formatted("%.1f deg", in_degrees(s.max_roll)) +
                   formatted(", pitch up to %.1f deg", in_degrees(s.max_pitch)));
  row("cost of transport",
      formatted("%.2f (positive mechanical work / weight / distance)", s.cost_of_transport));
  if (!c) return;
  row("real-time factor", formatted("%.1f", c->real_time_factor));
  row("a beat", formatted("controller %.0f ns, ", c->controller_ns_per_beat) +
                    formatted("physics %.0f ns", c->physics_ns_per_beat));
}

inline void write_json(std::ostream& out,
                       const statistics& s,
                       const std::optional<costs>& c,
                       const circumstances& where) {
  using detail::in_degrees;
  const auto measured = [&](double costs::* figure) { return c ? json((*c).*figure) : json(); };
  const auto of_legs = [](const std::array<double, 4>& numbers) {
    json object;
    for (std::size_t i = 0; i < 4; ++i) object[std::string(leg_keys[i])] = numbers[i];
    return object;
  };
  write(out, json{{"speed_m_s", s.speed},
                  {"cruise_speed_m_s", s.cruise},
                  {"distance_m", s.distance},
                  {"drift_m", s.drift},
                  {"seconds", s.seconds},
                  {"fell", s.fell},
                  {"max_roll_deg", in_degrees(s.max_roll)},
                  {"max_pitch_deg", in_degrees(s.max_pitch)},
                  {"stride_frequency_hz", s.stride_frequency},
                  {"duty_factor", of_legs(s.duty_factor)},
                  {"foot_slip_m_s", s.foot_slip},
                  {"slip_of_foot_m_s", of_legs(s.slip_of_foot)},
                  {"friction_power_w", s.friction_power},
                  {"cost_of_transport", s.cost_of_transport},
                  {"real_time_factor", measured(&costs::real_time_factor)},
                  {"controller_ns_per_beat", measured(&costs::controller_ns_per_beat)},
                  {"physics_ns_per_beat", measured(&costs::physics_ns_per_beat)},
                  {"seed", where.seed ? json(*where.seed) : json()},
                  {"terrain", where.terrain},
                  {"engine", where.engine}});
}

}  // namespace trot
