// The architecture in the simulator, and what a program says about a run.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>

#include <cca/graph/items/shows.hpp>
#include <cca/robot/body_pose.hpp>
#include <cca/robots/oncilla/legged_body.hpp>
#include <cca/sim/robot.hpp>

#include "architecture.hpp"

namespace my_robot {

struct simulated : architecture<cca::sim::robot<description>> {};
static_assert(cca::check<simulated>());  // the first mistake of the graph, in a sentence

// What recordings and pages show.
struct shown : cca::shows<cca::robots::oncilla::legged_body, "robot.angles", "robot.orientation"> {};

inline cca::sim::scene around() {
  cca::sim::scene ground;
  ground.floor = 0;  // or `ground.ground = cca::sim::terrain::steps(0.006)`
  return ground;
}

// On its feet, each joint where the gait stands, the lowest foot just above the floor.
template <class Controller>
void put_down(Controller& c) {
  const auto& p = c.template get<"gait">().p;
  std::array<double, 16> q{};  // of each leg: abduction, hip, knee, toe
  for (std::size_t leg = 0; leg < 4; ++leg) {
    const leg_shape& shape = leg < 2 ? p.front : p.hind;
    q[4 * leg + 1] = shape.hip, q[4 * leg + 2] = shape.knee;
  }
  const cca::body_pose<body> posture(Eigen::Map<const Eigen::Matrix<double, 16, 1>>(q.data()));
  double lowest = 0;
  for (const double z : {posture.tip<"left_front_leg">().at[2], posture.tip<"right_front_leg">().at[2],
                         posture.tip<"left_hind_leg">().at[2], posture.tip<"right_hind_leg">().at[2]})
    lowest = std::min(lowest, z);
  cca::sim::robot_world world(cca::sim::model_of<description>(), around());
  cca::sim::moving_frame base;
  base.where.at[2] = 0.001 + cca::robots::oncilla::body.foot_radius - lowest;
  world.place(q, std::array<double, 16>{}, base);
  c.template get<"robot.simulator">().put_down(std::move(world));
}

template <class Controller>
bool has_fallen(const Controller& c) {  // it leans by more than 30 degrees
  return c.template get<"robot.simulator">().world().frame(-1).where.turn(2, 2) < 0.87;
}

template <class Controller>
void report(const Controller& c) {
  const auto& world = c.template get<"robot.simulator">().world();
  const auto at = world.frame(-1).where.at;  // of the trunk
  std::printf("after %.1f s: %.2f m ahead, %.2f m aside, trunk %.0f mm above the ground%s\n", world.time(),
              at[0], at[1], 1000 * at[2], has_fallen(c) ? ", fallen" : "");
}

}  // namespace my_robot
