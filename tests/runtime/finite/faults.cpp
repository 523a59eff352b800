// A dead encoder reports NaN: the servo gives no torque from that beat on, and the robot stops.
#include <cca/cca.hpp>
#include <cca/robot/unreadable_fault.hpp>
#include <cca/motor/dmp_discrete.hpp>
#include <cca/motor/pid.hpp>

#include "../robot/joints.hpp"

#include <doctest/doctest.h>

using namespace robot_test;

namespace {

// Two joints with a mass each, which drift when a torque lasts.
struct heavy_leg {
  auto sense() -> cca::out<"angles", leg_angles> {
    leg_angles::vector_type told = at;
    if (broken) told[1] = no_number;
    return told;
  }
  void act(cca::in<"torques", leg_torques> to) {
    speed += 1e-3 * to.vector();
    at += 1e-3 * speed;
    torque = to.vector();
  }
  void on_fault() { ++stops; }
  leg_angles::vector_type at{0.1, -0.9}, speed{0, 0};
  leg_torques::vector_type torque{0, 0};
  bool broken = false;
  int stops = 0;
};
struct wish {
  auto process(cca::beat) -> cca::out<"angles", leg_angles> { return leg_angles::vector_type{0.5, -0.5}; }
};

// [fault]
template <int Firings>
struct served : cca::graph<cca::node<"wish", wish>,
                           cca::node<"servo", cca::pid<leg_angles, leg_torques>, cca::timed<1>>,
                           cca::node<"check", cca::fault_when_unreadable<cca::input_status_port, Firings>>,
                           cca::node<"limits", cca::limiter<leg_torques>>,
                           cca::node<"leg", heavy_leg>,
                           cca::wire<"wish.angles", "servo.reference">,
                           cca::wire<"leg.angles", "servo.measured">,
                           cca::wire<"servo.status", "check.status">,
                           cca::wire<"servo.command", "limits.command">,
                           cca::wire<"limits.safe", "leg.torques">> {};
// [fault end]

template <class Graph>
cca::controller<Graph> started() {
  cca::controller<Graph> c;
  c.load();
  c.start();
  return c;
}

}  // namespace

TEST_CASE("without a measurement the servo gives no torque, and the robot stops after the stated firings") {
  auto c = started<served<5>>();
  c.run(cca::for_beats<20>{});
  CHECK(c.get<"leg">().torque.norm() > 0);
  c.get<"leg">().broken = true;
  for (int k = 0; k < 4; ++k) c.step();
  CHECK(c.state() == cca::state::started);
  CHECK(c.get<"leg">().torque.norm() == 0);
  c.step();
  CHECK(c.state() == cca::state::faulted);
  CHECK(std::string(c.fault().reason()) == "an input is NaN or infinite");
  CHECK(c.fault_path() == "check");
  CHECK(c.get<"leg">().stops == 1);
}

TEST_CASE("a single wrong number need not stop it") {
  auto c = started<served<5>>();
  for (int k = 0; k < 2000; ++k) {
    c.get<"leg">().broken = k % 10 == 3;
    c.step();
  }
  CHECK(c.state() == cca::state::started);
}

namespace {

struct start_and_goal : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
template <int Every>
struct slow_reach : cca::graph<cca::rate<1000>,
                               cca::node<"wish", wish>,
                               cca::node<"reach", cca::dmp_discrete<start_and_goal, 5>, cca::timed<Every>>,
                               cca::wire<"wish.angles", "reach.goal", cca::latest>> {};

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace

TEST_CASE("a bound that follows from the rate is checked on load and on changes, and named") {
  cca::controller<slow_reach<100>> slow;
  CHECK(words_of([&] { slow.load(); }).empty());  // 1 s, 10 Hz: 12.5 / 16 * 0.1 s = 0.08 s
  auto wanted = slow.get<"reach">().p;
  wanted.duration = 0.05;
  CHECK(
      words_of([&] { slow.set<"reach">(wanted); }) ==
      "reach: `duration` is 0.05, but at 10 Hz it must be at least 0.078125: run the node faster, or change "
      "it");
  CHECK(slow.get<"reach">().p.duration == 1.0);
  cca::controller<slow_reach<10>> fast;
  fast.get<"reach">().p.duration = 0.05;
  CHECK(words_of([&] { fast.load(); }).empty());
  cca::controller<slow_reach<100>> set_before;
  set_before.get<"reach">().p.duration = 0.05;
  CHECK(words_of([&] { set_before.load(); }).find("at 10 Hz") != std::string::npos);
}
