// What a world is put down with: a plan of pushes, which it follows wherever its state comes from, and a
// scene, whose numbers are judged. None of them ends the process.
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

#include <cca/robots/description.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/sim/robot.hpp>

#include "flagged.hpp"
#include "lost_engine.hpp"

using namespace any_robot_test;

namespace {

namespace sim = cca::sim;
namespace robots = cca::robots;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

struct puck : flagged {
  static constexpr std::array shapes{robots::on_base(robots::sphere(0.1))};
};
using node = sim::simulated_robot<puck>;

sim::robot_world weightless() {
  sim::robot_world_settings s;
  s.engine.gravity = 0;
  return sim::robot_world(sim::model_of<puck>(), {}, s);
}

// A beat of a node that no controller drives is one of physics, too.
void run(node& robot, int beats) {
  for (int k = 0; k < beats; ++k) robot.on_idle();
}
double speed(const node& robot) { return robot.world().frame(-1).velocity[1]; }

sim::push_plan pushes(double start, double duration, double force) {
  return {{{{.start = start, .duration = duration, .force = {0, force, 0}}}}};
}

sim::robot_world in(const sim::scene& s) { return sim::robot_world(sim::model_of<puck>(), s); }

sim::robot_world on(const sim::terrain& ground) {
  sim::scene s;
  s.ground = ground;
  return in(s);
}

// The text with which a world is refused, or "".
std::string refusal(const std::function<void()>& make) {
  try {
    make();
  } catch (const std::invalid_argument& e) { return e.what(); } catch (const std::out_of_range& e) {
    return e.what();
  }
  return "";
}
std::string refusal_of_box(const std::array<double, 3>& size, const cca::placement& where = {}) {
  return refusal([&] {
    sim::scene s;
    s.add(sim::fixed_box{{1, 1, 1}, cca::at(5, 0, 0)});
    s.add(sim::fixed_box{size, where});
    in(s);
  });
}
std::string refusal_of_contact(double stiffness, double damping, double friction) {
  return refusal([&] {
    sim::scene s;
    s.contact = {stiffness, damping, friction};
    in(s);
  });
}
std::string refusal_of_ball(const sim::ball& b) {
  return refusal([&] {
    sim::scene s;
    s.add(b);
    in(s);
  });
}
std::string refusal_of_settings(const std::function<void(sim::robot_world_settings&)>& change) {
  return refusal([&] {
    sim::robot_world_settings s;
    change(s);
    const sim::robot_world w(sim::model_of<puck>(), {}, s);
  });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_SUITE("put down") {
  TEST_CASE("a world that is put down during a push is pushed by its plan from its own start") {
    node fresh, again;
    fresh.put_down(weightless(), pushes(0, 0.2, 2));
    again.put_down(weightless(), pushes(0, 0.2, 2));
    run(again, 50);
    again.put_down(weightless(), pushes(0, 0.2, 2));
    for (node* robot : {&fresh, &again}) run(*robot, 100);
    CHECK(speed(fresh) == doctest::Approx(0.2).epsilon(1e-6));
    CHECK(speed(again) == speed(fresh));
    again.put_down(weightless());  // now without a plan
    run(again, 10);
    CHECK(speed(again) == 0);
  }

  TEST_CASE("a world that is restored, or assigned, goes on with the plan: no push is lost, none stays") {
    for (const int at : {10, 20, 30, 50, 60})  // before, at and in the push, at its end, and after it
      for (const int between : {0, 15, 300})
        for (const bool assigned : {false, true}) {
          CAPTURE(at);
          CAPTURE(between);
          node robot;
          robot.put_down(weightless(), pushes(0.0195, 0.03, 2));
          run(robot, at);
          const sim::robot_world copy = robot.world();
          const sim::robot_state saved = robot.world().save();
          run(robot, between);
          if (assigned) robot.world() = copy;
          else robot.world().restore(saved);
          run(robot, 100);
          CHECK(speed(robot) == doctest::Approx(0.06).epsilon(1e-6));
        }
  }

  TEST_CASE("a state that was saved in a push of one plan, restored under another: the other plan counts") {
    node robot;
    robot.put_down(weightless(), pushes(0, 1, 2));
    run(robot, 10);
    const sim::robot_state saved = robot.world().save();
    robot.disturb({});
    run(robot, 10);
    robot.world().restore(saved);
    run(robot, 100);
    CHECK(speed(robot) == doctest::Approx(0.02).epsilon(1e-6));
    robot.world().push({0, 1, 0});  // what a program pushes is its own, and stays
    run(robot, 100);
    CHECK(speed(robot) == doctest::Approx(0.12).epsilon(1e-6));
  }

  TEST_CASE("a scene whose numbers can't be is refused when its world is made, with what and where") {
    CHECK(has(refusal_of_box({1, no_number, 1}), "the size of box 1 of the scene along y is nan m"));
    CHECK(has(refusal_of_box({1, 1, -1}), "along z is -1 m: it must be above 0"));
    CHECK(has(refusal_of_box({0, 1, 1}), "along x is 0 m"));
    CHECK(has(refusal_of_box({infinity, 1, 1}), "along x is inf m"));
    CHECK(has(refusal_of_box({1, 1, 1}, cca::at(0, 0, no_number)),
              "the place of box 1 of the scene along z is nan m"));
    CHECK(has(refusal_of_box({1, 1, 1}, {{}, {0, 0, 0, 0}}), "quaternion of box 1 of the scene is 0"));
    CHECK(refusal_of_box({1, 1, 1}, {{}, {0, 0, 0, 2}}).empty());  // the engine makes one of length 1
    CHECK(has(refusal_of_ball({.radius = 0}), "the radius of ball 0 of the scene is 0 m"));
    CHECK(has(refusal_of_ball({.mass = -1}), "the mass of ball 0 of the scene is -1 kg"));
    CHECK(has(refusal_of_ball({.position = {no_number, 0, 0}}),
              "the place of ball 0 of the scene along x is nan m"));
    CHECK(
        has(refusal_of_ball({.velocity = {0, infinity, 0}}), "the velocity of ball 0 of the scene along y"));
    CHECK(has(refusal_of_ball({.radius = 1e-200}), "the physics engine can't make a world of these numbers"));
    CHECK(has(refusal_of_contact(40e3, 200, -1), "the friction of contacts is -1: it must be"));
    CHECK(has(refusal_of_contact(40e3, 200, no_number), "the friction of contacts is nan"));
    CHECK(has(refusal_of_contact(-1, 200, 1), "the stiffness of contacts is -1 N/m"));
    CHECK(has(refusal_of_contact(1, no_number, 1), "the damping of contacts is nan N s/m"));
    CHECK(has(refusal_of_contact(0, 0, 1), "the stiffness plus damping of contacts is 0"));
    CHECK(refusal_of_contact(0, 1, 0).empty());
    sim::scene low;
    low.floor = no_number;
    CHECK(has(refusal([&] { in(low); }), "the height of the floor is nan m: it must be a finite number"));
    CHECK(has(refusal_of_settings([](auto& s) { s.engine.erp = no_number; }),
              "`erp` is nan: it must be from 0 to 1"));
    CHECK(has(refusal_of_settings([](auto& s) { s.engine.cfm = -1; }), "`cfm` is -1"));
    CHECK(has(refusal_of_settings([](auto& s) { s.engine.gravity = no_number; }), "gravity is nan m/s^2"));
    CHECK(has(refusal_of_settings([](auto& s) { s.mount = cca::at(no_number, 0, 0); }),
              "the mount of the robot"));
    CHECK(
        has(refusal_of_settings([](auto& s) { s.plausible.speed = no_number; }), "what is plausible is nan"));
    CHECK(refusal_of_settings([](auto& s) { s.engine.correcting_speed = infinity; }).empty());
    sim::robot_model m = sim::model_of<puck>();
    m.shapes[0].form.size[0] = -1;
    CHECK(has(refusal([&] { const sim::robot_world w(m); }), "a size of shape 0"));
  }

  TEST_CASE("a terrain that no ground has is refused where it is made") {
    using sim::terrain;
    for (const double run : {0.0, -1.0, 1e-9, no_number, infinity})
      CHECK(
          has(refusal([&] { terrain::steps(0.006, run, terrain::endless, 0); }), "the run of the steps is"));
    CHECK(has(refusal([] { terrain::steps(no_number); }), "the rise of the steps is nan m"));
    CHECK(has(refusal([] { terrain::steps(0.006, 1, 3, -infinity); }), "the start of the steps is -inf m"));
    for (const double pitch : {no_number, infinity, 1.6, -1.6})
      CHECK(has(refusal([&] { terrain::slope(pitch); }), "the pitch of the slope is"));
    CHECK(has(refusal([] { terrain::slope(0.1, no_number); }), "the start of the slope is nan m"));
    for (const double friction : {no_number, infinity, -infinity, -1.0})
      CHECK(has(refusal([&] { terrain::flat().with_friction(friction); }), "the friction of the ground is"));
    sim::robot_world fine = on(terrain::steps(0.006, 0.01, terrain::endless, 0).with_friction(0));
    for (int k = 0; k < 20; ++k) fine.advance(std::array{sim::joint_law{}});
    CHECK(!fine.trouble());
  }

  TEST_CASE("a number that nothing has is answered with how many there are - a box moves to a place") {
    sim::robot_world none = weightless();
    CHECK(has(refusal([&] { none.move(3, {}); }), "there is no box 3: this world has none"));
    sim::scene s;
    s.add(sim::fixed_box{{1, 1, 1}, cca::at(5, 0, 0)});
    sim::robot_world one = in(s);
    CHECK(has(refusal([&] { one.move(1, {}); }), "there is no box 1: this world has one, number 0"));
    const auto before = one.hash();
    CHECK(has(refusal([&] { one.move(0, cca::at(0, no_number, 0)); }),
              "the place of box 0 of the scene along y is nan m"));
    CHECK(one.hash() == before);
    one.move(0, cca::at(6, 0, 0));
    CHECK(one.hash() != before);
    CHECK(has(refusal([&] { one.pull(7, {0, 0, 1}); }), "there is no part 7: this world has one, number 0"));
    CHECK(has(refusal([&] { (void)one.contact(1); }), "there is no shape of the robot 1"));
    CHECK(has(refusal([&] { (void)one.end(2); }), "there is no part 2"));
    CHECK(has(refusal([&] { (void)one.frame(2); }), "there is no link 2"));
    CHECK(has(refusal([&] { (void)one.ball_position(0); }), "there is no ball 0: this world has none"));
    CHECK(has(refusal([&] { (void)one.tension(0); }), "there is no spring 0"));
  }

  // So far away a double has no metres any more: a strip of the ground ends before it begins, and the engine
  // refuses its length while contacts are looked for.
  TEST_CASE("an assertion of the engine in the search for contacts ends the beat, not the process") {
    [[maybe_unused]] lost_engine its_memory;
    sim::robot_world w = on(sim::terrain::steps(0, 7.8, sim::terrain::endless, 0));
    for (int k = 0; k < 100 && !w.trouble(); ++k) {
      sim::moving_frame base;
      base.where.at = {1.79e16 + 2.0 * k, 0, -0.05};
      w.place(std::array{0.0}, std::array{0.0}, base);
      w.advance(std::array{sim::joint_law{}});
    }
    CHECK(w.trouble().what == sim::implausible::engine);
    CHECK(w.trouble_text() == "the physics engine gives up: no step has a solution");
  }
}
