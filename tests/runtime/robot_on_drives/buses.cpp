// The buses that a robot on drives is connected to: what it refuses before it starts.
#include <string>

#include <doctest/doctest.h>

#include <cca/hardware/robot/drive_synchronizer.hpp>
#include <cca/hardware/robot/start_failure.hpp>

#include "pendulum.hpp"

namespace {

using namespace pendulum_test;

// The first joint on bus 0, the second on bus 1.
struct turn : swing {};
struct turn_joint : hw::joint<turn,
                              hw::cia402<geared_motor, 2, hw::cia402_mode::torque>,
                              hw::mounting{},
                              hw::joint_servo{},
                              1> {};
struct synchronizer
    : hw::drive_synchronizer<end_of_wire, hw::no_board, hw::joint_list<swing_joint, turn_joint>> {
  using hw::drive_synchronizer<end_of_wire, hw::no_board, hw::joint_list<swing_joint, turn_joint>>::read;
};

std::string refusal_of(synchronizer& s, end_of_wire& first, end_of_wire& second) {
  try {
    s.connect(first, second);
  } catch (const cca::refused& why) { return why.what(); }
  return "";
}

}  // namespace

TEST_SUITE("buses of a robot on drives") {
  TEST_CASE("one bus can't stand for two numbers") {
    wire left{}, right{};
    end_of_wire one = left.end(0), other = right.end(0);
    synchronizer s;
    CHECK(refusal_of(s, one, one) ==
          "robot.drives: bus 0 and bus 1 that are connected are the same bus: connect one for each number, "
          "or give the joints on it one number");
    CHECK(refusal_of(s, one, other).empty());
  }

  TEST_CASE("a start without buses is refused at once, and says so") {
    synchronizer s;
    s.on_start();
    s.read(cca::beat{0, 1'000'000, 1});
    REQUIRE(s.failure());
    CHECK(text_of(s.failure()) == "no bus is connected: call `connect` first");
  }
}
