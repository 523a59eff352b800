#pragma once
// The figures of a run as a short table for people and as one JSON object for programs.
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>

#include "recording.hpp"
#include "statistics.hpp"

namespace trot {

struct costs {
  double real_time_factor = 0;  // simulated time / real time, controller and physics
  double controller_ns_per_beat = 0;
  double physics_ns_per_beat = 0;
};

struct circumstances {
  std::string seed, terrain;  // seed: a number, or null
};

namespace detail {

inline std::string formatted(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

inline double in_degrees(double radians) { return radians * 57.29577951308232; }

}  // namespace detail

inline void write_table(std::ostream& out, const statistics& s, const costs& c) {
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
  row("real-time factor", formatted("%.1f", c.real_time_factor));
  row("a beat", formatted("controller %.0f ns, ", c.controller_ns_per_beat) +
                    formatted("physics %.0f ns", c.physics_ns_per_beat));
}

inline void write_json(std::ostream& out, const statistics& s, const costs& c, const circumstances& where) {
  using detail::formatted, detail::in_degrees;
  const auto number = [](double x) { return std::isfinite(x) ? formatted("%.6g", x) : std::string("null"); };
  const auto field = [&](const char* name, const std::string& value) {
    out << ",\n  \"" << name << "\": " << value;
  };
  out << "{\n  \"speed_m_s\": " << number(s.speed);
  field("cruise_speed_m_s", number(s.cruise));
  field("distance_m", number(s.distance));
  field("drift_m", number(s.drift));
  field("seconds", number(s.seconds));
  field("fell", s.fell ? "true" : "false");
  field("max_roll_deg", number(in_degrees(s.max_roll)));
  field("max_pitch_deg", number(in_degrees(s.max_pitch)));
  field("stride_frequency_hz", number(s.stride_frequency));
  std::string duty;
  for (std::size_t i = 0; i < 4; ++i)
    duty += (i ? ", \"" : "\"") + std::string(leg_keys[i]) + "\": " + number(s.duty_factor[i]);
  field("duty_factor", "{" + duty + "}");
  field("foot_slip_m_s", number(s.foot_slip));
  std::string slip;
  for (std::size_t i = 0; i < 4; ++i)
    slip += (i ? ", \"" : "\"") + std::string(leg_keys[i]) + "\": " + number(s.slip_of_foot[i]);
  field("slip_of_foot_m_s", "{" + slip + "}");
  field("friction_power_w", number(s.friction_power));
  field("cost_of_transport", number(s.cost_of_transport));
  field("real_time_factor", number(c.real_time_factor));
  field("controller_ns_per_beat", number(c.controller_ns_per_beat));
  field("physics_ns_per_beat", number(c.physics_ns_per_beat));
  field("seed", where.seed);
  field("terrain", "\"" + where.terrain + "\"");
  out << "\n}\n";
}

}  // namespace trot
