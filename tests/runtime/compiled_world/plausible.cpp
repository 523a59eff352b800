// A compiled world that can't be right any more: the bounds of the engine's world, and the same body first.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <array>
#include <map>
#include <vector>

#include <cca/sim/robot/world/robot_world.hpp>

#include "robots.hpp"

using namespace compiled_test;

namespace {

struct walking : robots::oncilla::description {};

// A slider on a turning arm.
struct post : cca::frame<"post"> {};
struct carriage : cca::frame<"carriage"> {};
struct turn : cca::dimension<"turn"> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}};
};
struct slide : cca::dimension<"slide"> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}};
};
struct crane_chain : cca::serial_chain<post, carriage, cca::axes<turn, slide>> {
  static constexpr std::array joints{cca::revolute(cca::along_z),
                                     cca::prismatic(cca::along_x, cca::at(0.3, 0, 0.1))};
  static constexpr auto tip = cca::at(0, 0, 0.05);
  static constexpr std::array links{
      cca::link_inertia{1, {0.1, 0.02, 0}, {0.01, 0.02, 0.03, 0.001, 0.002, 0}},
      cca::link_inertia{0.5, {0, 0.03, 0.1}, {0.003, 0.002, 0.001, 0, 0, 0.0005}}};
};
struct crane {
  struct body : cca::body<post, cca::part<"arm", crane_chain>> {};
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr robots::joint_drive drive{.motor = {10, 100}, .stops = false};
  static constexpr std::array drives{drive, drive};
};

template <class R>
void compare(double size, std::map<sim::implausible, int>& seen) {
  laws::source random{std::mt19937_64{7}};
  for (int k = 0; k < 150; ++k) {
    sim::robot_world_settings s;
    s.plausible = sim::plausible_bounds::none();
    if (k % 3 == 0) s.plausible.speed = random(0.1, 1.5) * size;
    if (k % 3 == 1) s.plausible.turn = random(0.5, 4) * size * 5e-4;
    if (k % 3 == 2) s.plausible.energy = random(0.02, 0.6) * size * size;
    sim::compiled_world<R> w(s);
    sim::robot_world e(sim::model_of<R>(), {}, s);
    const auto q = random_numbers<R>(random, 0.5), dq = random_numbers<R>(random, size);
    if constexpr (robots::floats<R>) {
      const std::array<double, 3> turning{random(-1, 1), random(-1, 1), random(-1, 1)},
          speed{random(-1, 1), random(-1, 1), random(-1, 1)};
      const cca::placement there = random_place(random);
      w.place(q, dq, there, turning, speed);
      e.place(
          q, dq,
          {cca::rigid{} * there, Eigen::Vector3d::Map(turning.data()), Eigen::Vector3d::Map(speed.data())});
    } else {
      w.place(q, dq);
      e.place(q, dq);
    }
    ++seen[w.trouble().what];
    REQUIRE(w.trouble().what == e.trouble().what);
    CHECK(w.trouble().body == e.trouble().body);
    CHECK(w.trouble().value == doctest::Approx(e.trouble().value).epsilon(1e-9));
    CHECK(w.trouble().bound == doctest::Approx(e.trouble().bound));
    CHECK(w.trouble_text() == e.trouble_text());
  }
}

}  // namespace

TEST_SUITE("compiled world: plausible") {
  TEST_CASE("the first body that is too fast is that of the engine's world") {
    std::map<sim::implausible, int> seen;
    compare<walking>(3, seen);
    compare<robots::arm::description>(3, seen);
    compare<crane>(3, seen);
    for (const auto what : {sim::implausible::nothing, sim::implausible::speed, sim::implausible::turning,
                            sim::implausible::energy})
      CHECK(seen[what] > 20);
  }

  TEST_CASE("in a run, too: what was right before stays") {
    sim::robot_world_settings s;
    s.plausible.energy = 20;
    sim::compiled_world<crane> w(s);
    const std::array pushed{sim::joint_law{.torque = 1}, sim::joint_law{.torque = 5}};
    double last = 0;
    int beats = 0;
    for (; beats < 5000 && !w.trouble(); ++beats) last = w.energy(), w.advance(pushed);
    REQUIRE(w.trouble().what == sim::implausible::energy);
    CHECK(w.trouble().value == doctest::Approx(20).epsilon(0.02));
    CHECK(w.energy() == last);
    CHECK(w.trouble_text().find("slide") != std::string::npos);
    w.place({0, 0}, {0, 0});
    CHECK(!w.trouble());
  }
}
