// Starting and stopping a robot: what must be measured before it moves, and that it stops until each drive
// has confirmed. On eight Damiao drives with a watchdog of 4 ms, and plain motors.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <doctest/doctest.h>

#include <cca/config.hpp>

#include "../../../examples/hardware_in_the_loop/robot.hpp"
#include "../../laws/robot_lab.hpp"

namespace {

namespace hw = cca::hardware;
namespace oncilla = cca::robots::oncilla;
using laws::lab_end;

// Posture and abduction that a test sets, and a fault when it says so.
struct poses {
  auto process() -> std::tuple<cca::out<"angles", oncilla::leg_angles>,
                               cca::out<"abduction", oncilla::abduction_angles>,
                               cca::fault> {
    return {angles, oncilla::abduction_angles::vector_type::Constant(abduction),
            broken ? cca::fault("the test says so") : cca::fault()};
  }
  oncilla::leg_angles::vector_type angles = [] {
    oncilla::leg_angles::vector_type v;
    for (std::size_t i = 0; i < 8; ++i)
      v[static_cast<Eigen::Index>(i)] = laws::middle_of<hil::joints>(i) + 0.15;
    return v;
  }();
  double abduction = 0;
  bool broken = false;
};

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"poses", poses>,
                                 cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                                 cca::node<"spread", cca::limiter<oncilla::abduction_angles>>,
                                 cca::node<"robot", hil::oncilla<lab_end>>,
                                 cca::wire<"poses.angles", "limits.command">,
                                 cca::wire<"poses.abduction", "spread.command">,
                                 cca::wire<"limits.safe", "robot.command">,
                                 cca::wire<"spread.safe", "robot.abduction">> {};

struct lab : laws::robot_lab<hil::oncilla<lab_end>, architecture, hil::virtual_damiao> {
  explicit lab(bool one_shot = true) : robot_lab(one_shot) {
    controller.load();
    heard = [this](std::size_t bus, const hw::can_frame& f) {
      std::array<double, 4> targets;
      abduction_frames += bus == hil::board::bus && hil::board::abducted(f, targets);
    };
  }
  void run() {
    controller.start();
    beats(500);
    REQUIRE(phase() == hw::motion_phase::running);
    REQUIRE(stop().mode() == hw::motion_mode::run);
    REQUIRE(enabled_count() == 8);
  }
  poses& wanted() { return controller.get<"poses">(); }
  int abduction_frames = 0;
};

// Another node holds bus 0 for 2 ms: with frames of the highest priority, back to back.
void hold_bus(lab& l) {
  std::array<hw::can_frame, 15> noise;
  noise.fill({.id = hw::standard(0), .length = 8});
  l.wires[0].end(2).send(noise);
}

}  // namespace

TEST_SUITE("stopping") {
  TEST_CASE(
      "stop() damps, then disables, until each drive has confirmed - also while another node holds a bus") {
    for (const bool one_shot : {true, false}) {
      CAPTURE(one_shot);
      lab l(one_shot);
      l.run();
      hold_bus(l);
      l.rest_of_beat();
      hold_bus(l);
      l.controller.stop();
      l.rest_of_beat();
      l.beats(10);
      CHECK(l.stiffest() == 0);
      CHECK(l.least_damping() > 0.3);  // none is free
      l.beats(900);
      CHECK(l.least_damping() > 0.3);
      CHECK(l.synchronizer().stopping());
      l.beats(100);
      CHECK_FALSE(l.synchronizer().stopping());
      CHECK(l.enabled_count() == 0);
      for (std::size_t i = 0; i < 8; ++i) CHECK_FALSE(l.synchronizer().unconfirmed(i));
    }
  }

  TEST_CASE("a frame that disables is lost: it is sent again") {
    lab l;
    l.run();
    l.controller.stop();
    l.beats(hw::stop_sequence<8>::damping_beats - 1);
    REQUIRE(l.enabled_count() == 8);
    for (int k = 0; k < 3; ++k) {
      l.controller.step();
      hold_bus(l);  // it wins the arbitration against the frames of the controller
      l.rest_of_beat();
    }
    l.beats(30);
    CHECK(l.enabled_count() == 0);
    CHECK_FALSE(l.synchronizer().stopping());
  }

  TEST_CASE("a component's fault: the drives are damped beyond their watchdog, then disabled") {
    lab l;
    l.run();
    l.wanted().broken = true;
    l.beat();
    REQUIRE(l.controller.state() == cca::state::faulted);
    for (int k = 0; k < 900; ++k) {
      l.beat();
      REQUIRE(l.stiffest() == 0);
      REQUIRE(l.least_damping() > 0.3);
      REQUIRE(l.enabled_count() == 8);
    }
    l.beats(200);
    CHECK(l.enabled_count() == 0);
    CHECK_FALSE(l.synchronizer().stopping());
    l.wanted().broken = false;
    l.controller.resume();
    l.beats(100);
    CHECK(l.enabled_count() == 0);  // resuming alone moves nothing
    l.controller.stop();
    l.run();
  }

  TEST_CASE(
      "idling, as where a run waits for others, damps drives that move - the next beat drives them again") {
    lab l;
    l.run();
    for (int k = 0; k < 200; ++k) {
      l.synchronizer().on_idle();
      l.rest_of_beat();
      if (k < 5) continue;  // the last set points stay for three beats
      REQUIRE(l.stiffest() == 0);
      REQUIRE(l.least_damping() > 0.3);
      REQUIRE(l.enabled_count() == 8);
    }
    CHECK(l.phase() == hw::motion_phase::running);
    l.beats(10);
    CHECK(l.stop().mode() == hw::motion_mode::run);
    CHECK(l.stiffest() > 0);
  }

  TEST_CASE("shut_down: the whole sequence in one line - a drive that never confirms is reported by name") {
    lab l;
    l.run();
    const std::int64_t last = cca::detail::stop_progress;
    const auto good = hw::shut_down(l.controller, l.pace());
    CHECK(cca::detail::stop_progress > last);  // a second SIGINT lets it go on
    CHECK(good.complete());
    CHECK(good.text() ==
          "all drives are off; confirmed by: left_front_hip, right_front_hip, left_hind_hip, right_hind_hip, "
          "left_front_knee, right_front_knee, left_hind_knee, right_hind_knee");
    CHECK(good.beats > 1000);
    CHECK(good.beats < 1100);
    CHECK(l.enabled_count() == 0);

    l.run();
    std::get<6>(l.far.drives).go_silent(true);
    l.wanted().broken = true;
    l.beat();
    const auto bad = hw::shut_down(l.controller, l.pace());
    CHECK_FALSE(bad.complete());
    REQUIRE(bad.unconfirmed == std::vector<std::string>{"left_hind_knee"});
    CHECK(
        bad.text() ==
        "not confirmed to be off: left_hind_knee; switch the supply of the drives off; confirmed by: "
        "left_front_hip, right_front_hip, left_hind_hip, right_hind_hip, left_front_knee, right_front_knee, "
        "right_hind_knee");
    CHECK(bad.beats < 1600);
    CHECK(hw::shut_down(l.controller, l.pace()).beats == 0);  // there is nothing left to do
  }

  TEST_CASE("a tripped emergency stop goes the same way") {
    lab l;
    l.run();
    l.stop().press();
    l.beats(900);
    CHECK(l.enabled_count() == 8);
    CHECK(l.least_damping() > 0.3);
    l.beats(200);
    CHECK(l.enabled_count() == 0);
    CHECK(l.stop().first_cause().rule == hw::safety_rule::pressed);
    CHECK(l.stop().mode() == hw::motion_mode::damped);
  }

  TEST_CASE("a start during a stop waits until the drives are off, and then begins") {
    lab l;
    l.run();
    l.controller.stop();
    l.beats(5);
    l.controller.start();
    bool was_off = false;
    for (int k = 0; k < 60; ++k) {
      l.beat();
      was_off = was_off || l.enabled_count() == 0;
    }
    CHECK(was_off);
    CHECK(l.phase() == hw::motion_phase::running);
  }
}

TEST_SUITE("the pressed emergency stop") {
  TEST_CASE("nothing is enabled while it is pressed, nor by a start") {
    lab l;
    l.stop().press();
    std::get<3>(l.far.drives).go_silent(true);
    l.controller.start();
    for (int k = 0; k < 900; ++k) {
      l.beat();
      REQUIRE(l.enabled_count() == 0);
    }
    CHECK(l.synchronizer().refusal() == hw::safety_rule::pressed);
    CHECK(hw::text_of(l.synchronizer().failure()) ==
          "the emergency stop is pressed: release it, then start again");
    l.controller.stop();
    l.controller.start();  // the button is not released by a start
    std::get<3>(l.far.drives).go_silent(false);
    l.beats(100);
    CHECK(l.enabled_count() == 0);
    l.stop().release();
    l.beats(100);
    CHECK(l.enabled_count() == 0);
    l.controller.stop();
    l.run();
  }

  TEST_CASE(
      "no abduction target goes out while it is pressed, the drives are not enabled or the robot stops") {
    lab l;
    l.wanted().abduction = 0.3;
    std::get<3>(l.far.drives).go_silent(true);
    l.controller.start();
    l.beats(300);
    CHECK(l.abduction_frames == 0);  // the drives are not enabled yet
    std::get<3>(l.far.drives).go_silent(false);
    l.plant.abducted = {0.1, 0.1, 0.1, 0.1};
    l.beats(20);
    REQUIRE(l.phase() == hw::motion_phase::running);
    CHECK(l.abduction_frames > 0);
    CHECK(l.far.abduction[0] > 0.1);  // from where it is, by 2 mrad a beat
    CHECK(l.far.abduction[0] <= 0.1 + 0.002 * l.abduction_frames + 1e-4);
    l.beats(300);
    CHECK(l.far.abduction[0] == doctest::Approx(0.3).epsilon(0.01));
    l.stop().press();
    l.beats(1);
    const int frames = l.abduction_frames;
    l.wanted().abduction = -0.3;
    l.beats(2000);
    l.synchronizer().start();
    l.beats(500);
    CHECK(l.abduction_frames == frames);
    CHECK(l.far.abduction[0] == doctest::Approx(0.3).epsilon(0.01));
  }
}

TEST_SUITE("starting") {
  TEST_CASE("a joint that is farther outside than the tolerance: refused, with joint, angle and range") {
    lab l;
    l.plant.put(0, hil::joints::angle[0].upper + 0.6);
    l.controller.start();
    for (int k = 0; k < 200; ++k) {
      l.beat();
      REQUIRE(l.stiffest() == 0);
    }
    CHECK(l.synchronizer().refusal() == hw::safety_rule::range);
    CHECK(hw::text_of(l.synchronizer().failure()) ==
          "left_front_hip is at 2.500 rad, outside of its range -1.200 to 1.900 rad by more than 0.50 rad: "
          "turn it "
          "back by hand, or correct its offset");
    CHECK(l.enabled_count() == 0);
    l.plant.put(0, 1);
    l.controller.stop();
    l.run();
  }

  TEST_CASE("a joint that turns faster than its axis allows: refused, with joint and speed") {
    for (const double speed : {20.0, 30.0, -20.0}) {
      CAPTURE(speed);
      lab l;
      l.plant.put(4, hil::joints::angle[4].lower + 0.2);
      l.plant.motors[4].now.velocity = speed;
      l.plant.motors[4].inertia = 1;  // goes on turning
      l.controller.start();
      for (int k = 0; k < 100; ++k) {
        l.beat();
        REQUIRE(l.phase() < hw::motion_phase::begins);
        REQUIRE(l.stiffest() == 0);
      }
      CHECK(l.synchronizer().refusal() == hw::safety_rule::rate);
      const std::string text = hw::text_of(l.synchronizer().failure());
      CAPTURE(text);
      CHECK(text.starts_with(speed > 0 ? "left_front_knee turns at " : "left_front_knee turns at -"));
      CHECK(
          text.ends_with(" rad/s, faster than its axis allows (-16.000 to 16.000 rad/s): stop its motion, "
                         "then start again"));
      CHECK(std::abs(l.synchronizer().failure().angle - speed) < 0.1 * std::abs(speed));
      l.plant.motors[4].inertia = 0.01;
      l.plant.put(4, hil::joints::angle[4].lower + 0.2);
      l.controller.stop();
      l.run();
    }
  }

  TEST_CASE("a joint that turns as fast as its axis allows is started") {
    lab l;
    l.plant.put(4, hil::joints::angle[4].lower + 0.1);
    l.plant.motors[4].now.velocity = 15;
    l.controller.start();
    for (int k = 0; k < 60 && l.phase() < hw::motion_phase::begins; ++k) l.beat();
    CHECK(l.phase() == hw::motion_phase::running);
    CHECK(l.plant.motors[4].now.velocity > 10);
  }

  TEST_CASE("a soft stop while a joint comes in from outside holds it where it is") {
    for (const double outside : {0.1, 0.3, 0.45}) {
      CAPTURE(outside);
      lab l;
      l.plant.put(0, hil::joints::angle[0].upper + outside);
      l.controller.start();
      while (l.phase() != hw::motion_phase::running) l.beat();
      l.beats(20);
      const double where = l.plant.motors[0].now.position;
      REQUIRE(where > hil::joints::angle[0].upper);
      l.stop().stop_softly();
      double fastest = 0;
      for (int k = 0; k < 90; ++k) {
        l.beat();
        REQUIRE(l.stop().mode() == hw::motion_mode::soft);
        if (k > 10) fastest = std::max(fastest, std::abs(l.plant.motors[0].now.velocity));
        if (l.laws[0].stiffness > 0.2) CHECK(std::abs(l.laws[0].position - where) < 0.03);
      }
      CHECK(fastest < 1);
      CHECK(std::abs(l.plant.motors[0].now.position - where) < 0.05);
    }
  }

  TEST_CASE("a joint that is a little outside enters its range no faster than `approach`") {
    for (const double outside : {0.1, 0.3, 0.45})
      for (const double load : {0.0, 1.0, -1.0}) {
        CAPTURE(outside);
        CAPTURE(load);
        lab l;
        for (std::size_t i = 0; i < 2; ++i) {
          l.plant.put(0, hil::joints::angle[0].upper + outside);
          l.plant.put(1, hil::joints::angle[1].lower - outside);
        }
        l.controller.start();
        double fastest = 0, first_torque = -1;
        for (int k = 0; k < 1500; ++k) {
          l.beat();
          const bool entering = l.plant.motors[0].now.position > hil::joints::angle[0].upper ||
                                l.plant.motors[1].now.position < hil::joints::angle[1].lower;
          for (const std::size_t i : {0u, 1u}) {
            if (entering) fastest = std::max(fastest, std::abs(l.plant.motors[i].now.velocity));
            if (first_torque < 0 && l.laws[i].stiffness > 0)
              first_torque = std::abs(l.plant.motors[i].now.torque);
          }
          if (l.phase() == hw::motion_phase::running)
            for (const std::size_t i : {0u, 1u})
              l.plant.motors[i].now.velocity += load * 1e-3;  // something pulls at it
        }
        CHECK(l.phase() == hw::motion_phase::running);
        CHECK(fastest < 2);
        CHECK(first_torque < 0.6);
        CHECK(l.plant.motors[0].now.position == doctest::Approx(l.wanted().angles[0]).epsilon(0.05));
      }
  }

  TEST_CASE(
      "a velocity that is not the change of the angle trips: its sign, its size, or that it is frozen") {
    for (const double scale : {-1.0, 2.2, 0.0}) {
      CAPTURE(scale);
      lab l;
      l.run();
      for (std::size_t i = 0; i < 4; ++i) l.wanted().angles[static_cast<Eigen::Index>(i)] += 1;
      l.speed_scale[2] = scale;
      l.beats(150);
      CHECK(l.stop().mode() == hw::motion_mode::damped);
      CHECK(l.stop().first_cause().rule == hw::safety_rule::implausible);
      CHECK(l.stop().first_cause().joint == 2);
    }
  }

  TEST_CASE("so does it refuse a start, also where the joint has turned a little and rests now") {
    for (const int turns : {1100, 15}) {  // ms
      CAPTURE(turns);
      lab l;
      l.speed_scale[1] = -1;
      l.plant.motors[1].now.velocity = 3, l.plant.motors[1].friction = 0;
      l.controller.start();
      l.beats(turns);
      l.plant.motors[1].now.velocity = 0;
      CHECK((l.synchronizer().refusal() == hw::safety_rule::none) == (turns == 15));  // it has not failed yet
      l.beats(1100);
      CHECK(l.phase() == hw::motion_phase::stopped);
      CHECK(l.synchronizer().refusal() == hw::safety_rule::implausible);
      CHECK(hw::text_of(l.synchronizer().failure()) ==
            "right_front_hip: the velocity that its drive reports is not the change of its angle: check the "
            "sign and the range of the velocity");
    }
  }

  TEST_CASE("the calibration is latched by start: a change while running is refused, and changes nothing") {
    lab l;
    l.run();
    auto other = l.synchronizer().p;
    other.offset[0] = 0.5;
    CHECK_THROWS_WITH_AS(l.controller.set<"robot.synchronizer">(other),
                         doctest::Contains("robot.synchronizer.offset: start() has latched the calibration"),
                         cca::refused);
    CHECK_THROWS_WITH_AS(l.controller.set("robot.synchronizer.offset[0]", 0.5),
                         doctest::Contains("robot.synchronizer.offset: start() has latched the calibration"),
                         cca::refused);
    l.synchronizer().p = other;  // past the check
    double most = 0;
    for (int k = 0; k < 50; ++k) {
      l.beat();
      most = std::max(most, std::abs(l.plant.motors[0].now.torque));
    }
    CHECK(most < 0.5);
    CHECK(l.stop().mode() == hw::motion_mode::run);
    l.synchronizer().p.offset[0] = 0;
    hw::shut_down(l.controller, l.pace());
    l.controller.set<"robot.synchronizer">(other);
    CHECK(l.synchronizer().p.offset[0] == 0.5);
  }
}
