// The board of a described robot: each reading comes to the port of its sensor, and none mixes two
// measurements.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/robot/boards/robot_fd_board.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>
#include <cca/hardware/virtual_robot.hpp>

#include "pendulum.hpp"

namespace {

namespace robots = cca::robots;

using namespace pendulum_test;

// The units of the board: the end of the rod, then the base, in the order in which they first occur.
struct pendulum {
  using body = pendulum_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  using sensors = robots::sensors<robots::gyroscope<"turning", "rod">,
                                  robots::accelerometer<"of_base">,
                                  robots::orientation_sensor<"turned", stand, "rod">,
                                  robots::accelerometer<"felt", "rod">>;
  static constexpr std::array drives{robots::joint_drive{.motor = {3, 16}, .stiffness = 20, .damping = 0.6}};
};

struct board : hw::robot_board<0x40, 0, 2, 1> {};

struct on_drive : hw::robot<pendulum, end_of_wire, swing_joint, board> {};

using xyz = cca::axes<cca::x, cca::y, cca::z>;
template <class Domain>
struct heard : cca::space<Domain, xyz, cca::rate<1000>> {};

struct probe {
  Eigen::Vector4d turned;
  Eigen::Vector3d turning, felt, of_base;
  int beats = 0;

  void process(cca::in<"turned", heard<cca::orientation<stand>>> q,
               cca::in<"turning", heard<robots::angular_velocity<bob>>> w,
               cca::in<"felt", heard<robots::specific_force<bob>>> f,
               cca::in<"of_base", heard<robots::specific_force<stand>>> b) {
    turned = q.vector(), turning = w.vector(), felt = f.vector(), of_base = b.vector();
    ++beats;
  }
};

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"robot", on_drive>,
                                 cca::node<"probe", probe>,
                                 cca::wire<"robot.turned", "probe.turned">,
                                 cca::wire<"robot.turning", "probe.turning">,
                                 cca::wire<"robot.felt", "probe.felt">,
                                 cca::wire<"robot.of_base", "probe.of_base">> {};
static_assert(cca::well_formed<architecture>);

struct lab {
  lab() {
    controller.get<"robot.synchronizer">().connect(near, near_board);
    far.connect(end, end_board);
    controller.load();
  }
  lab(const lab&) = delete;
  lab& operator=(const lab&) = delete;

  void beats(int n) {
    for (; n > 0; --n) {
      controller.step();
      bus.advance(now + 500'000), board_bus.advance(now + 500'000);
      far.listen(now + 500'000, [](std::size_t, const hw::can_frame&) {});
      motor.advance(far.laws(now + 500'000)[0], 0, 1e-3);
      far.tell({motor.now}, says);
      now += 1'000'000;
      bus.advance(now - 1), board_bus.advance(now - 1);
    }
  }
  auto& stop() { return controller.get<"robot.emergency_stop">(); }

  wire bus{}, board_bus{};
  cca::controller<architecture> controller{};
  hw::virtual_robot<end_of_wire, hw::virtual_of, board, hw::joint_list<swing_joint>> far{};
  hw::virtual_motor motor{};
  board::reading says{};
  std::int64_t now = 0;

private:
  end_of_wire near{bus.end(0)}, end{bus.end(1)}, near_board{board_bus.end(0)}, end_board{board_bus.end(1)};
};

template <class Board>
typename Board::reading some_reading() {
  typename Board::reading r;
  r.inertial[0] = {{0.6, 0, 0, 0.8}, {0.5, -1, 2}, {1, -2, 9}};
  r.inertial[1] = {{0, 0, 0, 1}, {0, 0, 0}, {0.1, 0.2, 9.81}};
  return r;
}

}  // namespace

TEST_SUITE("a robot's board") {
  TEST_CASE("inertial readings come to the ports of their sensors") {
    lab l;
    l.motor.inertia = 0.02, l.motor.friction = 0.01, l.motor.most_torque = 5;
    l.says = some_reading<board>();
    l.controller.start();
    l.beats(80);
    CHECK(l.controller.get<"robot.synchronizer">().phase() == hw::motion_phase::running);
    const probe& p = l.controller.get<"probe">();
    REQUIRE(p.beats > 0);
    CHECK(p.turned.isApprox(Eigen::Vector4d(0.6, 0, 0, 0.8), 1e-4));
    CHECK(p.turning.isApprox(Eigen::Vector3d(0.5, -1, 2), 1e-6));
    CHECK(p.felt.isApprox(Eigen::Vector3d(1, -2, 9), 1e-6));
    CHECK(p.of_base.isApprox(Eigen::Vector3d(0.1, 0.2, 9.81), 1e-3));
  }

  TEST_CASE("a unit that reports a fault stops the robot") {
    lab l;
    l.motor.inertia = 0.02, l.motor.friction = 0.01, l.motor.most_torque = 5;
    l.says = some_reading<board>();
    l.controller.start();
    l.beats(80);
    l.says.status = 3;
    l.beats(5);
    CHECK(l.stop().mode() == hw::motion_mode::damped);
    CHECK(l.stop().first_cause().rule == hw::safety_rule::sensor_board);
  }

  TEST_CASE("angular velocity and specific force of one measurement are taken together") {
    using larger = hw::robot_board<0x40, 1, 2>;
    auto r = larger::reading::untold();
    auto sent = some_reading<larger>();
    sent.loads[0] = {0.1, -0.2, 0.3, 10, -20, 30};
    const auto first = larger::frames(sent, 1), second = larger::frames(sent, 2);
    constexpr std::size_t orientation = 2, motion = 3, force = 4;  // of the first unit, after the load
    CHECK(larger::decode(first[orientation], r));
    CHECK(r.inertial[0].orientation[3] == doctest::Approx(0.8).epsilon(1e-4));
    CHECK(std::isnan(r.inertial[0].angular_velocity[0]));
    CHECK(larger::decode(first[motion], r));
    CHECK(larger::decode(second[force], r));  // of another measurement
    CHECK(std::isnan(r.inertial[0].angular_velocity[0]));
    CHECK(std::isnan(r.inertial[0].specific_force[0]));
    CHECK(larger::decode(second[motion], r));
    CHECK(larger::decode(second[force], r));
    CHECK(r.inertial[0].angular_velocity[2] == doctest::Approx(2));
    CHECK(r.inertial[0].specific_force[1] == doctest::Approx(-2));
    CHECK(std::isnan(r.inertial[1].specific_force[0]));
    CHECK(r.frames == 0);  // the other sensors are silent
    for (const hw::can_frame& f : second) larger::decode(f, r);
    CHECK(r.frames == 1);
    CHECK(r.loads[0][3] == doctest::Approx(10));
  }

  TEST_CASE("an orientation that is none is refused, and changes nothing") {
    auto r = board::reading::untold();
    auto sent = some_reading<board>();
    sent.inertial[0].orientation = {0.6, 0, 0, 0.6};
    const auto frames = board::frames(sent, 1);
    CHECK_FALSE(board::decode(frames[0], r));
    CHECK(std::isnan(r.inertial[0].orientation[0]));
  }

  TEST_CASE("in CAN FD frames, one frame is a reading") {
    using larger = hw::robot_fd_board<0x40, 1, 2>;
    auto r = larger::reading::untold();
    auto sent = some_reading<larger>();
    sent.loads[0] = {0.1, -0.2, 0.3, 10, -20, 30};
    sent.status = 5;
    const auto frames = larger::frames(sent, 1);
    for (const hw::can_frame& f : frames) CHECK(f.valid());
    CHECK(larger::decode(frames[0], r));
    CHECK(larger::decode(frames[1], r));
    CHECK(r.frames == 0);  // the second unit is silent
    CHECK(larger::decode(frames[2], r));
    CHECK(r.frames == 1);
    CHECK(r.status == 5);
    for (std::size_t i = 0; i < 6; ++i) CHECK(r.loads[0][i] == doctest::Approx(sent.loads[0][i]));
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(r.inertial[0].angular_velocity[i] == doctest::Approx(sent.inertial[0].angular_velocity[i]));
      CHECK(r.inertial[1].specific_force[i] ==
            doctest::Approx(sent.inertial[1].specific_force[i]).epsilon(1e-3));
    }
    CHECK(r.inertial[0].orientation[0] == doctest::Approx(0.6).epsilon(1e-4));
  }

  TEST_CASE("in CAN FD frames, one of another length or without an orientation changes nothing") {
    using fd = hw::robot_fd_board<0x40, 1, 1>;
    auto sent = some_reading<hw::robot_fd_board<0x40, 1, 2>>();
    fd::reading says;
    says.inertial[0] = sent.inertial[0];
    auto r = fd::reading::untold();
    auto frames = fd::frames(says, 1);
    frames[0].length = 12;
    CHECK_FALSE(fd::decode(frames[0], r));
    frames[1].data[6] = 0, frames[1].data[7] = 0;  // w of the quaternion
    CHECK_FALSE(fd::decode(frames[1], r));
    says.inertial[0].orientation.fill(std::nan(""));
    CHECK_FALSE(fd::decode(fd::frames(says, 1)[1], r));
    CHECK(r.complete == std::array<std::uint64_t, 2>{});
    CHECK(std::isnan(r.loads[0][0]));
    CHECK(std::isnan(r.inertial[0].angular_velocity[0]));
  }
}
