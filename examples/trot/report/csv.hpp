#pragma once
// A run as comma-separated values: one line every few beats, in SI units and radians. The first line has the
// names.
#include <cstdio>
#include <ostream>

#include "recording.hpp"

namespace trot {

inline void write_csv(std::ostream& file, const recording& run, std::size_t every = 5) {
  file << "time,x,y,z,roll,pitch,yaw";
  for (const char* what : {"hip", "hip_command", "knee", "knee_command", "foot_force", "contact"})
    for (const auto leg : leg_keys) file << ',' << what << '_' << leg;
  file << '\n';

  const auto number = [&](double x) {
    char text[32];
    std::snprintf(text, sizeof text, ",%.6g", x);
    file << text;
  };
  for (std::size_t i = every - 1; i < run.moments.size(); i += every) {
    const moment& m = run.moments[i];
    char time[32];
    std::snprintf(time, sizeof time, "%.3f", m.time);
    file << time;
    for (const double x : m.position) number(x);
    number(m.attitude.roll);
    number(m.attitude.pitch);
    number(m.attitude.yaw);
    for (const auto* row : {&m.hip, &m.hip_command, &m.knee, &m.knee_command, &m.foot_force})
      for (const double x : *row) number(x);
    for (const bool touching : m.contact) file << (touching ? ",1" : ",0");
    file << '\n';
  }
}

}  // namespace trot
