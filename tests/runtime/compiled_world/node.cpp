// A robot in compiled physics as a node: the ports and results of the one in the engine, and the trot of the
// examples.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include <cca/cca.hpp>
#include <cca/sim/compiled/robot.hpp>
// Before anything else brings it:
#ifdef _ODE_ODE_H_
#error "compiled physics includes the engine"
#endif
#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/robot.hpp>

#include "../any_robot/described_oncilla.hpp"
#include "robots.hpp"

namespace laws {
std::size_t allocations();  // in tests/laws/allocations.cpp
}

using namespace compiled_test;

namespace {

namespace arm = robots::arm;
namespace oncilla = robots::oncilla;

struct waving {
  auto process(cca::beat now) -> cca::out<"angles", arm::angles> {
    const double way = 0.1 * (1 - std::cos(6e-9 * static_cast<double>(now.time())));
    arm::angles::vector_type q;
    for (Eigen::Index i = 0; i < 7; ++i)
      q[i] = arm::description::start[static_cast<std::size_t>(i)] + (i % 2 ? way : -way);
    return q;
  }
};
template <class Robot>
struct moved : cca::graph<cca::node<"targets", waving>,
                          cca::node<"limits", cca::limiter<arm::angles>>,
                          cca::node<"robot", Robot>,
                          cca::wire<"targets.angles", "limits.command">,
                          cca::wire<"robot.angles", "limits.measured">,
                          cca::wire<"limits.safe", "robot.position">> {};
struct moved_in_engine : moved<sim::robot<arm::description>> {};
struct moved_in_compiled : moved<sim::robot<arm::description, sim::compiled>> {};
static_assert(cca::well_formed<moved_in_compiled>);
static_assert(cca::embodied<arm::body, sim::robot<arm::description, sim::compiled>>);

struct compiled_trot : trot::architecture<sim::robot<oncilla::as_built, sim::compiled>> {};
// Where the gait stands, the lowest foot just above the ground.
cca::controller<compiled_trot> ready(const sim::terrain& ground) {
  cca::controller<compiled_trot> c;
  c.load();
  const sim::initial_posture posture = trot::put_down(c.get<"gait">().p, {});
  double lowest = 0;
  std::array<double, 16> q{};
  for (std::size_t leg = 0; leg < 4; ++leg) {
    const auto& l = posture.legs[leg];
    q[4 * leg] = l.abduction, q[4 * leg + 1] = l.hip, q[4 * leg + 2] = l.knee;
    lowest = std::min(lowest, sim::foot_position(sim::oncilla_model{}, {l.hip, l.knee}).z);
  }
  // [node]
  sim::scene around;
  around.ground = ground;
  sim::compiled_world<oncilla::as_built> world(around);
  world.place(q, {}, cca::at(0, 0, 0.033 - lowest), {}, {});
  c.get<"robot.simulator">().put_down(std::move(world));
  // [node end]
  return c;
}

template <class State>
bool same_bits(const State& a, const State& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST_SUITE("compiled world: node") {
  TEST_CASE("an arm in an architecture moves as in the engine") {
    cca::controller<moved_in_engine> engine;
    cca::controller<moved_in_compiled> compiled;
    engine.load(), compiled.load();
    engine.start(), compiled.start();
    double worst = 0, way = 0;
    for (int k = 0; k < 1000; ++k) {
      REQUIRE(engine.step());
      REQUIRE(compiled.step());
      const auto& a = engine.get<"robot.simulator">().world().joints();
      const auto& b = compiled.get<"robot.simulator">().world().joints();
      for (std::size_t i = 0; i < 7; ++i) {
        worst = std::max(worst, std::abs(a[i].angle - b[i].angle));
        way = std::max(way, std::abs(b[i].angle - arm::description::start[i]));
      }
    }
    MESSAGE("largest difference: ", worst, " rad");
    CHECK(worst < 2e-3);
    CHECK(way > 0.15);
  }

  TEST_CASE("the Oncilla trots, a copy goes on with the same bits, and nothing allocates") {
    auto c = ready(sim::terrain::flat());
    c.start();
    for (int k = 0; k < 2000; ++k) REQUIRE(c.step());
    const auto& world = c.get<"robot.simulator">().world();
    const double from = world.frame(-1).where.at[0];
    auto copy = c;
    const std::size_t before = laws::allocations();
    for (int k = 0; k < 4000; ++k) REQUIRE(c.step());
    CHECK(laws::allocations() == before);
    const double speed = (world.frame(-1).where.at[0] - from) / 4;
    MESSAGE("speed ", speed, " m/s, height ", world.frame(-1).where.at[2], " m");
    CHECK(speed > 0.7);
    CHECK(speed < 0.8);
    CHECK(world.frame(-1).where.turn(2, 2) > 0.9);
    for (int k = 0; k < 4000; ++k) copy.step();
    CHECK(same_bits(world.save().motion, copy.get<"robot.simulator">().world().save().motion));
  }

  TEST_CASE("sensors read a robot at rest") {
    sim::scene around;
    around.floor = 0;
    sim::compiled_world<oncilla::description> w(around);
    w.place(oncilla::description::start, {}, cca::at(0, 0, 0.2), {}, {});
    std::array<sim::joint_law, 16> laws;
    for (std::size_t c = 0; c < 16; ++c) {
      const auto& d = oncilla::description::drives[c];
      laws[c] = {.position = oncilla::description::start[c],
                 .stiffness = d.position_stiffness(),
                 .damping = d.damping};
    }
    for (int i = 0; i < 30000; ++i) w.advance(laws);
    const auto& unit = w.inertial("acceleration");
    const Eigen::Vector3d force = Eigen::Vector3d::Map(unit.specific_force.data());
    CHECK((w.frame(-1).where.turn * force - Eigen::Vector3d(0, 0, 9.81)).norm() < 1e-4);
    CHECK(Eigen::Vector3d::Map(unit.angular_velocity.data()).norm() < 1e-5);
    const Eigen::Vector4d turn = Eigen::Vector4d::Map(unit.orientation.data());
    CHECK((cca::rotation::matrix(turn) - w.frame(-1).where.turn).norm() < 1e-12);
  }

  TEST_CASE("a fault names what is wrong, and the world stands still") {
    auto c = ready(sim::terrain::flat());
    c.start();
    c.step();
    auto& world = c.get<"robot.simulator">().world();
    const double knee = world.joints()[2].angle, work = world.absolute_work(), time = world.time();
    world.push({1e12, 0, 0});
    for (int k = 0; k < 3; ++k) c.step();
    REQUIRE(c.state() == cca::state::faulted);
    CHECK(std::string(c.fault().reason()).find("first at the base") != std::string::npos);
    CHECK(world.joints()[2].angle == knee);
    CHECK(world.absolute_work() == work);
    CHECK(world.time() == time);
    const double there = world.frame(-1).where.at[0];
    c.step();
    CHECK(world.frame(-1).where.at[0] == there);
  }
}
