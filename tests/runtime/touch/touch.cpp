// The demonstrator of the compliant arm: its architecture for any arm, and what its worst user does to it.
// The runs with their bounds are those of the example.
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <doctest/doctest.h>

#include "../../../examples/touch/rollout.hpp"

namespace {

// Any arm with these ports.
struct idle_arm {
  auto sense() -> std::tuple<cca::out<"angles", touch::arm::angles>,
                             cca::out<"velocities", touch::arm::velocities>,
                             cca::out<"torques", touch::arm::torques>,
                             cca::out<"flange_load", touch::load_in_flange>> {
    using vector = touch::arm::angles::vector_type;
    return {vector(vector::Map(touch::arm::description::start.data())), vector(vector::Zero()),
            vector(vector::Zero()),
            touch::load_in_flange::vector_type(touch::load_in_flange::vector_type::Zero())};
  }
  void act(cca::in<"torque", touch::arm::torques> torque) { last = torque.vector(); }
  touch::arm::torques::vector_type last = touch::arm::torques::vector_type::Zero();
};
struct idle : touch::architecture<idle_arm> {};

using simulated = cca::controller<touch::simulated>;

double fastest(const simulated& c) {
  double most = 0;
  for (const auto& j : c.get<"robot.simulator">().world().joints())
    most = std::max(most, std::abs(j.velocity));
  return most;
}
double height(const simulated& c) { return c.get<"robot.simulator">().world().end(0).where.at[2]; }
bool wipes(int step) { return step == touch::plan::at<"wipe">; }

}  // namespace

TEST_CASE("any arm with these ports: nobody leads it, so it holds its weight and waits") {
  cca::controller<idle> c;
  c.load();
  c.start();
  c.run(cca::for_<2>{});
  CHECK(c.get<"sequencer">().steps.step() == touch::plan::at<"guided">);
  const cca::body_pose<touch::arm::body> at(
      touch::arm::angles::vector_type::Map(touch::arm::description::start.data()));
  CHECK((c.get<"robot">().last - cca::gravity_torques(at, Eigen::Vector3d(0, 0, -9.81))).norm() < 1e-9);
}

TEST_CASE(
    "the operator stops it while it wipes: it comes to rest and stays, and the table bears no more force") {
  const auto c = std::make_unique<simulated>();
  c->load();
  int after = 0;
  double most = 0, at_stop = 0;
  touch::roll_out(*c, 3, [&](simulated& now, int step) {
    if (!wipes(step) && after == 0) return true;
    if (++after == 1000) {
      now.get<"operator">().pressed = true;
      at_stop = height(now);
    }
    const auto& load = now.get<"robot.simulator">().world().load(0);
    if (after > 1300) most = std::max(most, std::hypot(load[3], load[4], load[5]));
    return after < 2000;
  });
  CHECK(after == 2000);
  CHECK(fastest(*c) < 0.01);
  CHECK(std::abs(height(*c) - at_stop) < 0.02);
  CHECK(most < 2);
}

namespace {

// A sphere that looks straight down is pressed with 10 N against a plane with that normal, and is dragged
// along.
touch::load::vector_type pressed_on(const Eigen::Vector3d& normal, const Eigen::Vector3d& friction) {
  constexpr double r = touch::arm::description::tool_radius;
  const Eigen::Vector3d contact = Eigen::Vector3d(0, 0, -r) - r * normal, force = 10 * normal + friction;
  touch::load::vector_type load;
  load << contact.cross(force), force;
  return load;
}
touch::hand::vector_type looking_down() {
  touch::hand::vector_type pose;
  pose << 0.5, 0, 0.3, 1, 0, 0, 0;
  return pose;
}

}  // namespace

TEST_CASE("the normal of the table is felt whatever the friction, and NaN is felt as nothing") {
  touch::feel f;
  const Eigen::Vector3d normal = Eigen::Vector3d(0.1, -0.15, 1).normalized();
  const Eigen::Vector3d along = normal.cross(Eigen::Vector3d::UnitX()).normalized();
  const auto feels = [&](const touch::load::vector_type& load, int k) {
    return f.process({load, k * 1'000'000, true}, {looking_down(), k * 1'000'000, true},
                     cca::beat(k, 1'000'000, 1));
  };
  int k = 0;
  for (; k < 500; ++k) {
    const auto [felt, force, status] = feels(pressed_on(normal, (k / 100 % 2 ? 3.0 : -3.0) * along), k);
    CHECK((felt.vector() - normal).norm() < 1e-9);
    CHECK(force.vector()[0] == doctest::Approx(10));
    CHECK(status.vector()[0] == cca::status_of(touch::feeling::table));
  }
  for (int end = k + 400; k < end; ++k) {
    const auto [felt, force, status] =
        feels(touch::load::vector_type::Constant(std::numeric_limits<double>::quiet_NaN()), k);
    CHECK((felt.vector() - normal).norm() < 1e-9);
    CHECK(force.vector()[0] == 0);
    if (k + 1 == end) CHECK(status.vector()[0] == cca::status_of(touch::feeling::nothing));
  }
}
