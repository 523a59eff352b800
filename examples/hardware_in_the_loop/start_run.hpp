#pragma once
// A run of the fault campaign with its fault at the start: the robot is put down in some posture, its drives
// report wrong values or none, and the program starts. Then the fault is mended, the operator sets the robot
// on its feet, and starts again.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign.hpp"

namespace hil {

template <class Run>
struct start_scenario {
  std::string fault;
  std::vector<std::string_view> refusal{};          // words of the message; empty: the start is not refused
  std::array<double, 8> outside{};                  // rad, added to the posture in which it is put down
  bool hangs = false;                               // somebody holds the robot up by its trunk
  std::vector<hw::bus_fault> script{};              // until the first start is over
  std::function<void(Run&)> begin = {}, mend = {};  // of the fault
};

template <class Run, class Joints = joints>
class start_run {
public:
  explicit start_run(const start_scenario<Run>& what)
      : s(what), script(script_of(what)), r(script, true, early) {
    found.fault = s.fault;
  }
  start_run(const start_run&) = delete;
  start_run& operator=(const start_run&) = delete;

  result go() {
    cca::sim::disturbance held;
    if (s.hangs) held.another = {.duration = 1e-3 * first_start, .force = {0, 0, 51}};
    r.put_down(put_down(s.outside), held);
    if (s.begin) s.begin(r);
    r.controller.load();
    where = positions();
    r.controller.start();
    for (; k < first_start; ++k) beat(), note();
    judge();
    if (s.mend) s.mend(r);
    if (refused() || button(r).mode() != hw::motion_mode::run) {
      r.controller.stop();
      r.put_down(put_down(), {});
      r.controller.start();
      for (std::int64_t i = 0; i < timing::restarted; ++i) beat();
    }
    found.recovered =
        button(r).mode() == hw::motion_mode::run && !r.controller.template get<"robot.rate">().approaching();
    found.sent = watcher.sent;
    found.sent_outside_limits = watcher.outside;
    return found;
  }

private:
  static std::vector<hw::bus_fault> script_of(const start_scenario<Run>& s) {
    std::vector<hw::bus_fault> script = s.script;
    for (hw::bus_fault& f : script) f.from = 0, f.until = first_start * 1'000'000;
    return script;
  }
  std::array<double, 8> positions() const {
    std::array<double, 8> all;
    const auto q = r.plant.motions();
    for (std::size_t i = 0; i < 8; ++i) all[i] = q[i].position;
    return all;
  }
  bool refused() { return synchronizer(r).refusal() != hw::safety_rule::none; }

  void beat() {
    r.controller.step();
    r.pass_millisecond();
    watcher.look(r);
  }

  void note() {
    const bool runs = synchronizer(r).phase() == hw::motion_phase::running;
    if (runs && !began) began = true, first_beat = k;
    if (detected < 0 && refused()) {
      finds(hw::text_of(synchronizer(r).failure()));
    } else if (detected < 0 && began && button(r).mode() != hw::motion_mode::run) {
      const hw::safety_event cause = button(r).first_cause();
      finds(
          std::string(hw::name_of(cause.rule)) +
          (cause.joint < 0 ? "" : ", " + std::string(Joints::names[static_cast<std::size_t>(cause.joint)])));
    }
    const auto q = r.plant.motions();
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& c = r.laws[i];
      if (began && (std::abs(c.velocity) > 0.03 ||
                    (c.stiffness > 0.2 && std::abs(c.position - former[i].position) > 0.002)))
        last_moving = k;
      leads = leads || (c.stiffness > 0.2 && std::abs(c.position - q[i].position) > 0.02);
      found.max_excursion = std::max(found.max_excursion, std::abs(q[i].position - where[i]));
      found.max_torque = std::max(found.max_torque, std::abs(q[i].torque));
      if (s.outside[i] != 0 && k >= first_beat + braking && !Joints::angle[i].holds(q[i].position))
        fastest = std::max(fastest, std::abs(q[i].velocity));
    }
    former = r.laws;
  }
  void finds(const std::string& cause) {
    detected = k;
    found.first_cause = cause;
    found.detected_by = "controller";
  }

  void judge() {
    const auto wrong = [&](const std::string& what) { found.unexpected += what + "; "; };
    if (detected >= 0) {
      found.beats_to_detect = detected;
      found.beats_to_safe = std::max<std::int64_t>(0, last_moving + 1 - detected);
    }
    for (const std::string_view words : s.refusal)
      if (found.first_cause.find(words) == std::string::npos)
        wrong("is not refused with `" + std::string(words) + "`");
    if (!s.refusal.empty() && (began || leads)) wrong("moves though its start is refused");
    if (s.refusal.empty() && detected >= 0) wrong("is stopped by `" + found.first_cause + "`");
    if (fastest > r.controller.template get<"robot.rate">().p.approach)
      wrong("enters its range with " + std::to_string(fastest) + " rad/s");
    found.fell = r.plant.world.fallen();
  }

  static constexpr std::int64_t first_start = 1500;
  // ms: until its drive is on, a joint falls freely. Then the drive brakes it.
  static constexpr std::int64_t braking = 50;
  const start_scenario<Run>& s;
  const std::vector<hw::bus_fault> script;  // the buses read it
  Run r;
  spy<Joints> watcher{};
  result found{};
  std::int64_t k = 0, detected = -1, last_moving = -1, first_beat = first_start;
  bool began = false, leads = false;
  double fastest = 0;  // rad/s, of a joint that is outside of its range
  std::array<double, 8> where{};
  std::array<hw::drive_command, 8> former{};
};

}  // namespace hil
