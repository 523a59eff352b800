#pragma once
// The Oncilla as a described robot under the trot of the examples: between their ports, at its start, and how
// it walked.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <cca/cca.hpp>
#include <cca/robots/oncilla/description.hpp>
#include <cca/sim/robot.hpp>

#include "../../../examples/trot/rollout.hpp"

namespace described_oncilla_test {

namespace oncilla = cca::robots::oncilla;
namespace robots = cca::robots;
namespace sim = cca::sim;

using described = oncilla::description;
using all_angles = robots::angles<described>;
using all_axes = robots::measured_axes_of<described>;
constexpr sim::oncilla_model numbers{};

// From the ports of the described robot to those of the Oncilla that the trot uses.
struct hips_and_knees {
  auto process(cca::in<"all", all_angles> all) -> cca::out<"angles", oncilla::leg_angles> {
    return part(all.vector(), oncilla::leg_axes());
  }

private:
  template <class... Axes>
  static oncilla::leg_angles::vector_type part(const all_angles::vector_type& all, cca::axes<Axes...>) {
    return oncilla::leg_angles::vector_type{all[all_axes::index_of<Axes>]...};
  }
};

// [all joints]
struct all_joints {
  static constexpr bool preserves_limits = true;

  auto process(cca::in<"command", oncilla::leg_angles> wanted) -> cca::out<"position", all_angles> {
    return whole(wanted.vector(), all_axes());
  }

private:
  template <class... Axes>
  static all_angles::vector_type whole(const oncilla::leg_angles::vector_type& wanted, cca::axes<Axes...>) {
    return all_angles::vector_type{one<Axes>(wanted)...};
  }
  template <class Axis>
  static double one(const oncilla::leg_angles::vector_type& wanted) {
    if constexpr (oncilla::leg_axes::contains<Axis>) return wanted[oncilla::leg_axes::index_of<Axis>];
    else return 0;  // no abduction
  }
};

template <class Robot>
struct described_oncilla : cca::graph<cca::rate<1000>,
                                      cca::node<"body", Robot>,
                                      cca::node<"joints", all_joints>,
                                      cca::node<"legs", hips_and_knees>,
                                      cca::wire<"joints.position", "body.position">,
                                      cca::wire<"body.angles", "legs.all">,
                                      cca::expose<"joints.command", "command">,
                                      cca::expose<"legs.angles", "angles">,
                                      cca::expose<"body.orientation", "orientation">> {};
// [all joints end]

template <class Robot>
struct trot_of : trot::architecture<described_oncilla<Robot>> {};

// The coordinates of a posture.
inline std::vector<double> coordinates(const sim::initial_posture& posture) {
  std::vector<double> q;
  for (const sim::leg_posture& leg : posture.legs) q.insert(q.end(), {leg.abduction, leg.hip, leg.knee, 0.0});
  return q;
}

// Level, the lowest foot just above the ground.
template <class R = described>
sim::robot_world put_down(const sim::initial_posture& posture,
                          const sim::scene& around,
                          const sim::robot_world_settings& settings = {}) {
  double lowest = 0;
  for (const sim::leg_posture& leg : posture.legs)
    lowest = std::min(lowest, sim::foot_position(numbers, {leg.hip, leg.knee}).z);
  sim::robot_world w(sim::model_of<R>(), around, settings);
  sim::moving_frame base;
  base.where.at[2] = -lowest + numbers.foot_radius + 0.001 + numbers.trunk_above_hips;
  base.velocity = Eigen::Vector3d::Map(posture.trunk_velocity.data());
  const std::vector<double> q = coordinates(posture);
  w.place(q, std::vector<double>(q.size(), 0.0), base);
  return w;
}

inline sim::scene on(const sim::terrain& ground) {
  sim::scene s;
  s.ground = ground;
  return s;
}

struct walk {
  double speed = 0;  // m/s, after two seconds
  double slip = 0;   // m/s, of the feet, weighted by load, after two seconds
  double aside = 0;  // m
  bool fell = false;
};

// `step()` makes a beat; the first two seconds don't count.
template <class World, class Step>
walk walked_in(const World& world, double seconds, Step step) {
  walk w;
  double begun_at = 0;
  sim::contact_account begun;
  const auto feet = [&world] {
    sim::contact_account sum;
    for (std::size_t leg = 0; leg < 4; ++leg) sum = sum + world.contact_at_end(leg);
    return sum;
  };
  const auto beats = static_cast<std::size_t>(1000 * seconds);
  for (std::size_t k = 0; k < beats && !w.fell; ++k) {
    step();
    const sim::moving_frame trunk = world.frame(-1);
    w.fell = trunk.where.turn.col(2)[2] < std::cos(oncilla::degrees(30));
    if (k == 2000) begun_at = trunk.where.at[0], begun = feet();
  }
  const sim::contact_account walked = feet() - begun;
  const Eigen::Vector3d at = world.frame(-1).where.at;
  w.speed = (at[0] - begun_at) / (seconds - 2);
  w.slip = walked.slip / walked.load;
  w.aside = at[1];
  return w;
}

}  // namespace described_oncilla_test
