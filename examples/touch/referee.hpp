#pragma once
// What a run is judged by, from the true state of the world.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <cca/base/math.hpp>
#include <cca/robot/body_dynamics.hpp>
#include <cca/robot/body_pose.hpp>

#include "architecture.hpp"
#include "scene.hpp"

namespace touch {

struct result {
  std::uint64_t seed = 0;
  double path_error = std::nan("");   // m, rms of the repetition, from the movement that was shown
  double goal_error = std::nan("");   // m, from the goal that was moved
  double force_error = std::nan("");  // N, rms of the force along the table's normal while wiping
  double max_force = 0;               // N, of the table on the tool
  double yielded = 0;                 // m, by the push
  double energy_created = 0;          // J, beyond what the guard's tank held
  double energy_delivered = 0;        // J, by the controller without gravity, at most
  double seconds = 0;
  int last_step = 0;
  bool reported = false;  // the push was reported
  bool returned = false;  // and wiping went on with the wanted force
  bool stopped = false;   // at the operator's stop it came to rest, damped

  bool recovered() const { return reported && returned && stopped && last_step == plan::at<"rest">; }
};

class referee {
public:
  referee(std::uint64_t seed, double tank) : held(tank) { r.seed = seed; }

  // After a beat in which the arm went from `before` to `after`.
  template <class Controller, class World>
  void note(
      const Controller& c, const World& world, const scene& s, int step, double in_step, bool is_stopped) {
    note_energy(world);
    r.max_force = std::max(r.max_force, force_on_tool(world).norm());
    const Eigen::Vector3d at = world.end(0).where.at;
    const auto& shown = c.template get<"recorder">().movement();
    if (step == plan::at<"repeat">) note_path(at, shown, in_step);
    if (last == plan::at<"repeat elsewhere"> && step != last && !shown.empty())
      r.goal_error = (at - shown.back().template head<3>() - s.shift).norm();
    if (wipes(step) && step != plan::at<"return">) note_force(world, s, step, in_step);
    if (step == plan::at<"yield">) {
      if (last != step) pushed_from = at;
      r.reported = true;
      r.yielded = std::max(r.yielded, (at - pushed_from).head<2>().norm());
    }
    if (step == plan::at<"lift"> && last == plan::at<"wipe on"> && late_count > 0)
      r.returned = cca::math::sqrt(late_force / late_count) < 1.5;
    if (is_stopped) {
      double fastest = 0;
      for (const auto& j : world.joints()) fastest = std::max(fastest, std::abs(j.velocity));
      r.stopped = fastest < 0.01;
    }
    last = r.last_step = step;
    r.seconds = world.time();
  }

  result end() const {
    result all = r;
    if (path_count > 0) all.path_error = cca::math::sqrt(path / path_count);
    if (force_count > 0) all.force_error = cca::math::sqrt(force / force_count);
    all.energy_created = std::max(0.0, all.energy_delivered - held);
    return all;
  }

private:
  template <class Movement>
  void note_path(const Eigen::Vector3d& at, const Movement& shown, double time) {
    const double place = time / recorder::interval;
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 >= shown.size()) return;
    const double share = place - static_cast<double>(i);
    const Eigen::Vector3d wanted =
        (1 - share) * shown[i].template head<3>() + share * shown[i + 1].template head<3>();
    path += (at - wanted).squaredNorm();
    path_count += 1;
  }
  template <class World>
  void note_force(const World& world, const scene& s, int step, double in_step) {
    const double off = force_on_tool(world).dot(s.normal(step == plan::at<"wipe"> ? in_step : 10)) - 10;
    force += off * off;
    force_count += 1;
    if (step == plan::at<"wipe on"> && in_step > 1) late_force += off * off, late_count += 1;
  }
  template <class World>
  void note_energy(const World& world) {
    vector q, torque;
    for (int i = 0; i < q.size(); ++i) {
      q[i] = world.joints()[static_cast<std::size_t>(i)].angle;
      torque[i] = world.joints()[static_cast<std::size_t>(i)].torque;
    }
    if (has_before) {
      const cca::body_pose<arm::body> middle(vector(0.5 * (q + before)));
      const vector weight = cca::gravity_torques(middle, Eigen::Vector3d(0, 0, -9.81));
      energy += (torque - weight).dot(q - before);
      r.energy_delivered = std::max(r.energy_delivered, energy);
    }
    before = q;
    has_before = true;
  }

  using vector = arm::angles::vector_type;
  result r;
  double held, path = 0, force = 0, late_force = 0, energy = 0;
  double path_count = 0, force_count = 0, late_count = 0;
  int last = 0;
  bool has_before = false;
  vector before = vector::Zero();
  Eigen::Vector3d pushed_from{};
};

}  // namespace touch
