#pragma once
// The figures of runs: a table for people, a JSON list for programs, the bounds, and a run moment by moment.
#include <cstdio>
#include <ostream>
#include <vector>

#include "../trot/report/json.hpp"
#include "referee.hpp"

namespace touch {

// rms of the repetition, of the moved goal, of the force; the largest force; energy.
struct bounds {
  double path = 5e-3, goal = 2e-3, force = 1.5, max_force = 40, energy = 1e-3;
};

inline bool within(const result& r, const bounds& b = {}) {
  return r.path_error <= b.path && r.goal_error <= b.goal && r.force_error <= b.force &&
         r.max_force <= b.max_force && r.energy_created <= b.energy && r.recovered();
}

inline void write_heading() {
  std::printf("seed   path     goal     force    at most   yields   energy   \n");
}
inline void write_row(const result& r) {
  std::printf("%4d  %5.2f mm %5.2f mm  %5.2f N  %6.1f N  %5.0f mm  %6.3f J  %s\n", static_cast<int>(r.seed),
              1e3 * r.path_error, 1e3 * r.goal_error, r.force_error, r.max_force, 1e3 * r.yielded,
              r.energy_created,
              within(r)                        ? "recovered"
              : r.recovered()                  ? "recovered, but beyond a bound"
              : !r.reported                    ? "the push was not reported"
              : !r.returned                    ? "did not go on wiping"
              : r.last_step < plan::at<"rest"> ? "did not come to its end"
                                               : "did not rest after the stop");
}

inline void write_json(std::ostream& out, const std::vector<result>& runs) {
  trot::json list = trot::json::array();
  for (const result& r : runs)
    list.push_back({{"seed", r.seed},
                    {"path_error_mm", r.path_error * 1e3},
                    {"goal_error_mm", r.goal_error * 1e3},
                    {"force_error_n", r.force_error},
                    {"max_force_n", r.max_force},
                    {"yield_mm", r.yielded * 1e3},
                    {"energy_created_j", r.energy_created},
                    {"energy_delivered_j", r.energy_delivered},
                    {"recovered", r.recovered()},
                    {"seconds", r.seconds},
                    {"last_skill", plan::table[static_cast<std::size_t>(r.last_step)].name}});
  trot::write(out, list);
}

// The flange's position (m), the force on the tool (N), the step of the plan.
inline constexpr const char* moment_columns = "time,x,y,z,force_x,force_y,force_z,step";

template <class Controller>
void write_moment(std::ostream& out, const Controller& c, int step) {
  const auto& world = c.template get<"robot.simulator">().world();
  const Eigen::Vector3d at = world.end(0).where.at, force = force_on_tool(world);
  char line[200];
  std::snprintf(line, sizeof line, "%.3f,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g,%d\n", world.time(), at[0],
                at[1], at[2], force[0], force[1], force[2], step);
  out << line;
}

}  // namespace touch
