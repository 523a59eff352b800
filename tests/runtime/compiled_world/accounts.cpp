// What contacts have done in a compiled world: load, slip and the work of friction, by laws and beside the
// engine.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <cca/sim/robot/world/robot_world.hpp>

#include "robots.hpp"

using namespace compiled_test;

namespace {

struct walking : robots::oncilla::description {};
// Two cables with dampers, and two springs that push, too.
struct sprung : robots::oncilla::description {
  static constexpr auto line_springs = [] {
    auto all = robots::oncilla::description::line_springs;
    for (std::size_t i = 0; i < all.size(); ++i) all[i].damping = 30, all[i].only_pulls = i < 2;
    return all;
  }();
};

template <class World>
sim::contact_account of_sledge(const World& w) {
  return w.contact_of_base();
}
sim::compiled_world<sledge> thrown(const std::array<double, 3>& turning, const std::array<double, 3>& speed) {
  auto w = on_slope(0, 0.5);
  const auto place = w.frame(-1).where.at;
  w.place({0}, {0}, cca::at(place[0], place[1], place[2]), turning, speed);
  return w;
}

// Hips and knees follow sines of 4 Hz.
std::array<sim::joint_law, 16> treading(int beat) {
  std::array<sim::joint_law, 16> laws;
  for (std::size_t c = 0; c < 16; ++c) {
    const auto& d = walking::drives[c];
    const double side = c / 4 % 3 == 0 ? 1 : -1, phase = 0.025 * beat;
    const double swing = c % 4 == 1   ? 0.25 * side * std::sin(phase)
                         : c % 4 == 2 ? 0.3 * (1 - std::cos(phase))
                                      : 0;
    laws[c] = {
        .position = walking::start[c] + swing, .stiffness = d.position_stiffness(), .damping = d.damping};
  }
  return laws;
}

}  // namespace

TEST_SUITE("compiled world: accounts") {
  TEST_CASE("what a sledge loses while it slides, friction has taken") {
    struct start {
      std::array<double, 3> turning, speed;
    };
    for (const auto& [turning, speed] :
         {start{{0, 0, 0}, {2, 0, 0}}, start{{0, 0, 0}, {1, -1.5, 0}}, start{{0, 0, 6}, {1, 0.5, 0}}}) {
      auto w = thrown(turning, speed);
      const double before = w.energy() + w.spring_energy();
      run(w, 150);
      const double lost = before - w.energy() - w.spring_energy(), taken = of_sledge(w).friction_work;
      MESSAGE("lost ", lost, " J, friction ", taken, " J");
      CHECK(lost > 1);
      CHECK(taken == doctest::Approx(lost).epsilon(1e-3));
    }
  }

  TEST_CASE("until it rests, too") {
    auto w = thrown({0, 0, 0}, {1, 0.5, 0});
    const double before = w.energy();
    run(w, 1000);
    CHECK(speed(w) < 1e-9);
    MESSAGE("lost ", before - w.energy(), " J, friction ", of_sledge(w).friction_work, " J");
    CHECK(of_sledge(w).friction_work == doctest::Approx(before - w.energy()).epsilon(1e-3));
  }

  TEST_CASE("load is force over time, slip is load times speed, and each shape has its own") {
    auto w = thrown({0, 0, 0}, {2, 0, 0});
    const double from = w.frame(-1).where.at[0];
    run(w, 200);
    const sim::contact_account a = of_sledge(w);
    const double weight = mass * gravity, way = w.frame(-1).where.at[0] - from;
    CHECK(a.load == doctest::Approx(0.2 * weight).epsilon(1e-3));
    CHECK(a.pressing == doctest::Approx(weight).epsilon(5e-3));
    CHECK(a.slip == doctest::Approx(weight * way).epsilon(5e-3));
    CHECK(a.friction_work == doctest::Approx(0.5 * a.slip).epsilon(2e-3));
    CHECK(a.touching == doctest::Approx(0.2).epsilon(1e-9));
    CHECK(a.contacts == 3);
    double sum = 0;
    for (std::size_t shape = 0; shape < 3; ++shape) {
      CHECK(w.contact(shape).contacts == 1);
      sum += w.contact(shape).load;
    }
    CHECK(sum == doctest::Approx(a.load));
    CHECK(w.contact(0).load >
          w.contact(1).load);  // friction brakes below the mass: the front is pressed down
    CHECK(w.contact_at_end("rod").load == 0);
    CHECK_THROWS_AS(static_cast<void>(w.contact(3)), std::out_of_range);
    CHECK_THROWS_AS(static_cast<void>(w.contact_at_end("mast")), std::out_of_range);
  }

  TEST_CASE("a sledge that sticks on a slope slips by nothing and loses nothing") {
    auto w = on_slope(0.5, 0.75);
    run(w, 1000);
    const auto before = of_sledge(w);
    run(w, 1000);
    const auto now = of_sledge(w) - before;
    CHECK(now.load == doctest::Approx(mass * gravity * std::cos(0.5)).epsilon(1e-6));
    CHECK(now.slip < 1e-8);
    CHECK(std::abs(now.friction_work) < 1e-8);
    CHECK(now.touching == doctest::Approx(1));
  }

  TEST_CASE("a sledge on a slope has the accounts that it has in the engine") {
    for (const double pitch : {0.5, 0.8}) {
      auto w = on_slope(pitch, 0.4);
      sim::robot_world e(sim::model_of<sledge>(), hill_of(pitch, 0.4));
      sim::moving_frame base;
      base.where = cca::rigid{} * on_hill(pitch);
      e.place(std::vector{0.0}, std::vector{0.0}, base);
      run(w, 600), run(e, 600);
      const auto a = of_sledge(w), b = of_sledge(e);
      MESSAGE("load ", a.load, " ", b.load, ", slip ", a.slip, " ", b.slip, ", work ", a.friction_work, " ",
              b.friction_work);
      CHECK(a.load == doctest::Approx(b.load).epsilon(2e-3));
      CHECK(a.slip == doctest::Approx(b.slip).epsilon(1e-2));
      CHECK(a.friction_work == doctest::Approx(b.friction_work).epsilon(1e-2));
      CHECK(a.touching == doctest::Approx(b.touching));
      CHECK(a.contacts == b.contacts);
      CHECK(w.ground_height(0) == doctest::Approx(10 * std::tan(pitch)));
      CHECK(w.ground_height(0) == doctest::Approx(e.ground_height(0)));
    }
  }

  TEST_CASE("an Oncilla that treads has them, too, at each foot - its motors pay for them") {
    sim::scene room;
    room.floor = 0;
    sim::compiled_world<walking> w(room);
    sim::robot_world e(sim::model_of<walking>(), room);
    w.place(walking::start, {}, cca::at(0, 0, 0.18), {}, {});
    sim::moving_frame base;
    base.where.at = Eigen::Vector3d(0, 0, 0.18);
    e.place(walking::start, std::vector<double>(16, 0.0), base);
    const auto energy = [&] { return w.energy() + w.spring_energy(); };
    const auto height = [&] { return w.centre_of_mass()[2]; };
    const double before = energy();
    double was_at = 0;
    for (int i = 0; i < 2000; ++i) was_at = height(), w.advance(treading(i)), e.advance(treading(i));
    REQUIRE(!w.trouble());
    double load = 0, taken = 0;
    for (const std::string foot : {"left_front_leg", "right_front_leg", "left_hind_leg", "right_hind_leg"}) {
      const auto a = w.contact_at_end(foot), b = e.contact_at_end(foot);
      MESSAGE(foot, ": load ", a.load, " ", b.load, ", slip ", a.slip, " ", b.slip, ", work ",
              a.friction_work, " ", b.friction_work, ", touching ", a.touching, " ", b.touching);
      CHECK(a.load == doctest::Approx(b.load).epsilon(0.25));
      CHECK(a.touching == doctest::Approx(b.touching).epsilon(0.25));
      CHECK(a.slip > 0.5 * b.slip);
      CHECK(a.slip < 2 * b.slip);
      CHECK(a.friction_work == doctest::Approx(0.75 * a.slip).epsilon(0.1));
      load += a.load, taken += a.friction_work;
    }
    // What the ground carries is the weight and the change of the momentum.
    const double rises = (height() - was_at) / 1e-3;
    CHECK(load == doctest::Approx(w.mass() * (2 * gravity + rises)).epsilon(2e-3));
    const double motors = 2 * w.positive_work() - w.absolute_work();
    MESSAGE("motors ", motors, " J, friction ", taken, " J, energy ", energy() - before, " J");
    CHECK(taken > 5);
    CHECK(taken < motors + before - energy());  // joints, cables and landing feet take the rest
  }

  TEST_CASE("a spring or cable pulls as in the engine") {
    sim::compiled_world<sprung> w;
    sim::robot_world e(sim::model_of<sprung>());
    laws::source random{std::mt19937_64{5}};
    double most = 0, least = 0;
    for (int k = 0; k < 20; ++k) {
      auto q = random_numbers<sprung>(random, 0.3), dq = random_numbers<sprung>(random, 5);
      for (std::size_t c = 0; c < q.size(); ++c) q[c] += sprung::start[c];
      w.place(q, dq, {}, {0, 0, 1}, {1, 0, 0});
      sim::moving_frame base;
      base.velocity = {1, 0, 0}, base.angular_velocity = {0, 0, 1};
      e.place(q, dq, base);
      for (std::size_t i = 0; i < sprung::line_springs.size(); ++i) {
        CHECK(w.tension(i) == doctest::Approx(e.tension(i)).epsilon(1e-9));
        most = std::max(most, w.tension(i)), least = std::min(least, w.tension(i));
      }
    }
    CHECK(most > 1);
    CHECK(least < -1);
    CHECK_THROWS_AS(static_cast<void>(w.tension(100)), std::out_of_range);
  }
}
