// Robots whose links are not as described, in both worlds: masses and lengths, and drives in a bad condition.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <cca/base/math/random_numbers.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/robots/oncilla/description.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

#include "../compiled_world/robots.hpp"
#include "close_to.hpp"

using namespace compiled_test;

namespace {

using uncertain_test::close_to;

namespace arm = robots::arm;
using oncilla_robot = robots::oncilla::description;

// Each link up to 30 % heavier or lighter.
sim::robot_world_settings other_masses(int links, int steps = 2) {
  sim::robot_world_settings s;
  cca::random_numbers random(5);
  for (int i = -1; i < links; ++i) s.body.mass_of(i) = random.between(0.7, 1.3);
  s.steps_per_beat = steps;
  return s;
}

template <class R>
struct start_state {
  numbers<R> q, dq;
  cca::placement where = cca::at(0.1, 0.2, 1) * cca::turned_about(cca::along_y, 0.4);
  std::array<double, 3> turning{1, -2, 0.5}, velocity{0.3, 0.1, -0.2};

  explicit start_state(double size) {
    laws::source random{std::mt19937_64{3}};
    q = random_numbers<R>(random, size), dq = random_numbers<R>(random, 2);
  }
  void put(sim::compiled_world<R>& w) const {
    if constexpr (cca::robots::floats<R>) w.place(q, dq, where, turning, velocity);
    else w.place(q, dq);
  }
  void put(sim::robot_world& w) const {
    if (!w.model().floats) return w.place(q, dq);
    sim::moving_frame base;
    base.where = cca::rigid{} * where;
    base.angular_velocity = Eigen::Vector3d::Map(turning.data());
    base.velocity = Eigen::Vector3d::Map(velocity.data());
    w.place(q, dq, base);
  }
};

template <class R>
void agree(int links) {
  const sim::robot_world_settings s = other_masses(links);
  sim::compiled_world<R> compiled(s), nominal;
  sim::robot_world engine(sim::model_of<R>(), {}, s);
  const start_state<R> start(0.6);
  start.put(compiled), start.put(nominal), start.put(engine);
  const Eigen::Vector3d centre = Eigen::Vector3d::Map(compiled.centre_of_mass().data());
  CHECK(close_to(compiled.mass(), engine.mass(), 1e-12));
  CHECK((centre - engine.centre_of_mass()).norm() < 1e-12);
  CHECK(close_to(compiled.energy(), engine.energy(), 1e-12));
  CHECK(std::abs(compiled.mass() - nominal.mass()) > 1e-3);
  CHECK(std::abs(compiled.energy() - nominal.energy()) > 1e-2);
}

// How much the energy changes in 0.3 s of free flight.
double drift_of_energy(const sim::robot_world_settings& s) {
  sim::compiled_world<flying_oncilla> w(s);
  start_state<flying_oncilla>(0.6).put(w);
  const double before = w.energy();
  double most = 0;
  for (int beat = 0; beat < 300; ++beat) {
    w.advance({});
    most = std::max(most, std::abs(w.energy() - before));
  }
  REQUIRE_FALSE(w.trouble());
  return most;
}

std::string refusal(auto change) {
  sim::robot_world_settings s;
  change(s);
  try {
    const sim::compiled_world<limp_arm> w(s);
  } catch (const std::invalid_argument& e) { return e.what(); }
  return "";
}

template <class R>
std::array<sim::joint_law, coordinates<R>> torque_on(std::size_t joint, double torque) {
  std::array<sim::joint_law, coordinates<R>> laws{};
  laws[joint].torque = torque;
  return laws;
}

// Both worlds of a sledge with a rod, whose joint has a motor and no spring.
struct powered_sledge : sledge {
  static constexpr std::array drives{robots::joint_drive{.motor = {2, 20}, .stops = false}};
};

struct rusty : powered_sledge {
  static constexpr std::array drives{
      robots::joint_drive{.motor = {2, 20}, .stops = false, .dry_friction = 0.1}};
};

// The speed of the rod after some beats with this torque, in this condition.
template <class World>
double speed_of_rod(World& w, double torque, const sim::drive_condition& now, int beats) {
  w.set_condition(std::array{now});
  for (int i = 0; i < beats; ++i) w.advance(torque_on<powered_sledge>(0, torque));
  return w.joints()[0].velocity;
}
auto both(auto judge) {
  sim::compiled_world<powered_sledge> compiled;
  sim::robot_world engine(sim::model_of<powered_sledge>());
  return std::array{judge(compiled), judge(engine)};
}

}  // namespace

TEST_SUITE("uncertain: bodies") {
  TEST_CASE("other masses: mass, centre and energy are the same in both worlds") {
    agree<oncilla_robot>(20);
    agree<arm::description>(7);
    agree<sledge>(1);
  }

  TEST_CASE("other masses: the compiled world moves as the engine does") {
    const auto s = other_masses(20, 8);
    sim::compiled_world<oncilla_robot> compiled(s), nominal;
    sim::robot_world engine(sim::model_of<oncilla_robot>(), {}, s);
    start_state<oncilla_robot> start(0);
    start.q = oncilla_robot::start;
    start.put(compiled), start.put(nominal), start.put(engine);
    std::array<sim::joint_law, 16> laws;
    for (std::size_t c = 0; c < 16; ++c) {
      const auto& d = oncilla_robot::drives[c];
      laws[c] = {.position = start.q[c], .stiffness = d.position_stiffness(), .damping = d.damping};
    }
    for (int i = 0; i < 200; ++i) compiled.advance(laws), nominal.advance(laws), engine.advance(laws);
    double off = 0, apart = 0;
    for (std::size_t c = 0; c < 16; ++c) {
      off = std::max(off, std::abs(compiled.joints()[c].angle - engine.joints()[c].angle));
      apart = std::max(apart, std::abs(compiled.joints()[c].angle - nominal.joints()[c].angle));
    }
    MESSAGE("largest difference ", off, " rad, from the robot as described ", apart, " rad");
    CHECK(off < 1e-4);
    CHECK(apart > 20 * off);
  }

  TEST_CASE("other masses keep the energy in free flight") {
    const double varied = drift_of_energy(other_masses(20)), half = drift_of_energy(other_masses(20, 4)),
                 nominal = drift_of_energy({});
    MESSAGE(varied, " J, with half the step ", half, " J, as described ", nominal, " J");
    CHECK(varied < 5 * nominal);
    CHECK(half < 0.3 * varied);
  }

  TEST_CASE("factors near 1 give nearly the robot as described, which has no such equations") {
    sim::robot_world_settings s;
    for (int link = -1; link < 20; ++link) s.body.mass_of(link) = 1 + 1e-9;
    sim::compiled_world<flying_oncilla> plain, near(s);
    const start_state<flying_oncilla> start(0.6);
    start.put(plain), start.put(near);
    for (int i = 0; i < 100; ++i) plain.advance({}), near.advance({});
    REQUIRE_FALSE(near.trouble());
    double off = 0;
    for (std::size_t c = 0; c < 16; ++c)
      off = std::max(off, std::abs(plain.joints()[c].angle - near.joints()[c].angle));
    CHECK(off < 1e-7);
    CHECK(off > 0);
  }

  TEST_CASE("a longer link reaches farther in the engine, and compiled physics refuses it") {
    sim::robot_world_settings s;
    const sim::robot_world nominal(sim::model_of<arm::description>(), {}, s);
    for (int i = -1; i < 7; ++i) s.body.length_of(i) = 1.1;
    const sim::robot_world longer(sim::model_of<arm::description>(), {}, s);
    const Eigen::Vector3d base = nominal.frame(-1).where.at;
    CHECK((longer.end("arm").where.at - base - 1.1 * (nominal.end("arm").where.at - base)).norm() < 1e-12);
    CHECK(close_to(longer.mass(), nominal.mass()));
    CHECK(refusal([](auto& one) { one.body.length_of(2) = 1.1; }) ==
          "cca::sim::compiled_world: the lengths of links are constants of its code, so `body.length` of the "
          "settings must be 1; cca::sim::robot_world takes others");
  }

  TEST_CASE("masses that no link has are refused") {
    CHECK(refusal([](auto& s) { s.body.mass_of(0) = 0; }).find("a factor of the mass of a link") !=
          std::string::npos);
    CHECK(refusal([](auto& s) { s.body.mass_of(0) = -1; }).find("above 0") != std::string::npos);
    CHECK(refusal([](auto& s) {
            s.body.length_of(0) = std::nan("");
          }).find("a factor of the length of a link") != std::string::npos);
    CHECK_THROWS_AS(refusal([](auto& s) { s.body.mass_of(64) = 1; }), std::out_of_range);
    CHECK(refusal([](auto&) {}).empty());
  }

  TEST_CASE("dry friction holds a joint up to its torque, and brakes it beyond") {
    const auto held = both([](auto& w) { return speed_of_rod(w, 0.09, {.dry_friction = 0.1}, 500); });
    const auto moving = both([](auto& w) { return speed_of_rod(w, 0.11, {.dry_friction = 0.1}, 50); });
    const auto free = both([](auto& w) { return speed_of_rod(w, 0.01, {}, 50); });
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(std::abs(held[i]) < 1e-5);
      CHECK(moving[i] > 0.1);
      CHECK(close_to(moving[i], free[i], 1e-3));  // what is left of the torque
    }
    // A rod that turns stops, and stays.
    const auto stopped = both([](auto& w) {
      speed_of_rod(w, 0.5, {}, 5);
      const double before = w.joints()[0].velocity, after = speed_of_rod(w, 0, {.dry_friction = 0.1}, 400);
      return before > 0.5 && std::abs(after) < 1e-6;
    });
    CHECK(stopped[0]);
    CHECK(stopped[1]);
  }

  TEST_CASE("strength, supply and friction change what a motor can do") {
    for (const double speed : both([](auto& w) { return speed_of_rod(w, 1e3, {}, 3000); }))
      CHECK(close_to(speed, 20, 0.01));  // its no-load speed
    for (const double speed : both([](auto& w) { return speed_of_rod(w, 1e3, {.supply = 0.8}, 3000); }))
      CHECK(close_to(speed, 16, 0.01));
    for (const double speed : both([](auto& w) { return speed_of_rod(w, 1e3, {.strength = 0.5}, 3000); }))
      CHECK(close_to(speed, 20, 0.01));
    // 0.1 N m against 0.05 N m s/rad.
    for (const double speed : both([](auto& w) { return speed_of_rod(w, 0.1, {.friction = 0.05}, 3000); }))
      CHECK(close_to(speed, 2, 0.01));
    const auto torques = both([](auto& w) {
      speed_of_rod(w, 1e3, {.strength = 0.5}, 1);
      return w.joints()[0].torque;
    });
    for (const double torque : torques) CHECK(close_to(torque, 1, 0.01));
  }

  TEST_CASE("a condition that no drive can be in is ignored, and a saved state has its condition") {
    const double none = std::nan("");
    const auto kept = both([&](auto& w) {
      speed_of_rod(w, 0, {.friction = 0.05}, 1);
      for (const sim::drive_condition& bad :
           {sim::drive_condition{.strength = -1}, {.supply = 0}, {.friction = none}, {.dry_friction = -0.1}})
        w.set_condition(std::array{bad});
      const auto saved = w.save();
      w.set_condition(std::array{sim::drive_condition{}});
      w.restore(saved);
      for (int i = 0; i < 3000; ++i) w.advance(torque_on<powered_sledge>(0, 0.1));
      return w.joints()[0].velocity;
    });
    for (const double speed : kept) CHECK(close_to(speed, 2, 0.01));
    CHECK(std::is_trivially_copyable_v<sim::compiled_world<powered_sledge>>);
  }

  TEST_CASE("dry friction in a description acts in both worlds") {
    sim::compiled_world<rusty> compiled;
    sim::robot_world engine(sim::model_of<rusty>());
    for (int i = 0; i < 200; ++i)
      compiled.advance(torque_on<rusty>(0, 0.09)), engine.advance(torque_on<rusty>(0, 0.09));
    CHECK(std::abs(compiled.joints()[0].velocity) < 1e-5);
    CHECK(std::abs(engine.joints()[0].velocity) < 1e-5);
  }
}
