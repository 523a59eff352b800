// The described Oncilla on virtual drives of the MIT protocol, with the simulator's robot behind them: the
// trot of the examples walks with it as in the simulator, and a stop ends with all drives disabled.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/robot/boards/robot_fd_board.hpp>
#include <cca/hardware/virtual_mit.hpp>
#include <cca/hardware/virtual_hardware.hpp>
#include <cca/sim/compiled/plant.hpp>
#include <cca/sim/robot/plant.hpp>

#include "../any_robot/described_oncilla.hpp"

namespace oncilla_on_drives {

namespace hw = cca::hardware;
using namespace described_oncilla_test;

// Two drives on each of six buses of 1 Mbit/s: those of a leg's plane on one, the abductions of front and
// hind legs on two more. The board has CAN FD frames and a bus of its own. The gains are the description's.
// [oncilla on drives]
struct dm8006 {
  static constexpr std::string_view name = "DM8006";
  static constexpr auto limits =
      cca::limits{cca::angle{-12.5, 12.5}, cca::velocity{-45, 45}, cca::torque{-20, 20},
                  cca::stiffness{0, 500}, cca::damping{0, 5}};
};
template <class Axis, std::uint32_t Number, std::size_t Bus, hw::mounting Mounting, hw::joint_servo Servo>
using on_bus =
    hw::joint<Axis, hw::mit_drive<dm8006, Number, 0x10, hw::mit_firmware::damiao>, Mounting, Servo, Bus>;

inline constexpr hw::joint_servo at_abduction{.stiffness = 80, .damping = 0.8, .safe_damping = 1},
    at_hip{.stiffness = 30, .damping = 0.375, .safe_damping = 1},
    at_knee{.stiffness = 80, .damping = 0.4, .safe_damping = 0.4};
inline constexpr hw::mounting turned{.sign = -1, .offset = 0.1}, straight{.offset = -0.1}, bent{.offset = 1};

struct left_front_abduction : on_bus<oncilla::left_front_abduction, 1, 4, turned, at_abduction> {};
struct left_front_hip : on_bus<oncilla::left_front_hip, 2, 0, turned, at_hip> {};
struct left_front_knee : on_bus<oncilla::left_front_knee, 3, 0, bent, at_knee> {};
struct right_front_abduction : on_bus<oncilla::right_front_abduction, 4, 4, straight, at_abduction> {};
struct right_front_hip : on_bus<oncilla::right_front_hip, 5, 1, straight, at_hip> {};
struct right_front_knee : on_bus<oncilla::right_front_knee, 6, 1, bent, at_knee> {};
struct left_hind_abduction : on_bus<oncilla::left_hind_abduction, 7, 5, turned, at_abduction> {};
struct left_hind_hip : on_bus<oncilla::left_hind_hip, 8, 2, turned, at_hip> {};
struct left_hind_knee : on_bus<oncilla::left_hind_knee, 9, 2, bent, at_knee> {};
struct right_hind_abduction : on_bus<oncilla::right_hind_abduction, 10, 5, straight, at_abduction> {};
struct right_hind_hip : on_bus<oncilla::right_hind_hip, 11, 3, straight, at_hip> {};
struct right_hind_knee : on_bus<oncilla::right_hind_knee, 12, 3, bent, at_knee> {};
struct board : hw::robot_fd_board<0x40, 4, 1, 6> {};  // four feet and the trunk, on bus 6

using joints = hw::joint_list<left_front_abduction,
                              left_front_hip,
                              left_front_knee,
                              right_front_abduction,
                              right_front_hip,
                              right_front_knee,
                              left_hind_abduction,
                              left_hind_hip,
                              left_hind_knee,
                              right_hind_abduction,
                              right_hind_hip,
                              right_hind_knee>;
template <class Bus>
struct robot : hw::robot<oncilla::description, Bus, joints, board> {};
// [oncilla on drives end]

}  // namespace oncilla_on_drives

using namespace oncilla_on_drives;

namespace {

using on_virtual_buses = robot<hw::virtual_bus_end>;
struct trot_on_drives : trot_of<on_virtual_buses> {};
static_assert(cca::well_formed<trot_on_drives>);

// A damiao drive stops after 4 ms without a set point.
template <class Drive>
struct virtual_damiao : hw::virtual_mit<Drive, 4'000'000> {};

// `World`: what the robot is simulated in, as of sim::robot.
template <class World = sim::robot_world>
struct lab {
  static constexpr std::size_t count = joints::count;
  using plant = sim::plant<oncilla::description, World>;
  static_assert(count == 12 &&
                hw::virtual_hardware<on_virtual_buses, plant>::buses == 7);

  explicit lab(typename plant::world_type&& on_ground) {
    far.plant.hold = sim::held_by::stand;  // until all drives have been enabled
    far.plant.put_down(std::move(on_ground));
    controller.load();
  }
  void beat() { controller.step(), far.step(); }
  auto& synchronizer() { return controller.template get<"robot.body.synchronizer">(); }
  auto& stop() { return controller.template get<"robot.body.emergency_stop">(); }
  std::size_t enabled() const { return far.enabled_count(); }

  // Until the drives follow the controller.
  void run() {
    controller.start();
    for (int k = 0; k < 300 && synchronizer().phase() != hw::motion_phase::running; ++k) beat();
    REQUIRE(synchronizer().phase() == hw::motion_phase::running);
    REQUIRE(enabled() == count);
  }

  cca::controller<trot_on_drives> controller{};
  hw::virtual_hardware<on_virtual_buses, plant, virtual_damiao> far{
      controller.template get<"robot.body.synchronizer">()};
};

sim::robot_world standing() {
  const auto disturbance = sim::disturbance::from_seed(3, 8);
  cca::controller<trot_on_drives> c;
  c.load();
  return put_down(trot::put_down(c.get<"gait">().p, disturbance),
                  on(sim::terrain::flat().with_friction(disturbance.friction)));
}
// The same place in compiled physics.
sim::compiled_world<oncilla::description> compiled_standing() {
  const sim::robot_world there = standing();
  sim::compiled_world<oncilla::description> w(there.around());
  std::array<double, oncilla::description::drives.size()> q{};
  for (std::size_t c = 0; c < q.size(); ++c) q[c] = there.joints()[c].angle;
  const sim::moving_frame base = there.frame(-1);
  w.place(q, {}, cca::at(base.where.at[0], base.where.at[1], base.where.at[2]), {},
          {base.velocity[0], base.velocity[1], base.velocity[2]});
  return w;
}

}  // namespace

TEST_SUITE("the described oncilla on drives") {
  TEST_CASE_TEMPLATE("the trot walks, and nothing trips", World, sim::robot_world, sim::compiled) {
    lab<World> l([] {
      if constexpr (std::is_same_v<World, sim::compiled>) return compiled_standing();
      else return standing();
    }());
    l.run();
    const walk w = walked_in(l.far.plant.world(), 8, [&] { l.beat(); });
    MESSAGE(w.speed, " m/s, slip ", w.slip, ", aside ", w.aside);
    CHECK(!w.fell);
    CHECK(w.speed > 0.55);
    CHECK(w.slip < 0.15);
    CHECK(l.stop().mode() == hw::motion_mode::run);
    CHECK(l.stop().first_cause().rule == hw::safety_rule::none);
    CHECK(l.enabled() == lab<World>::count);
  }

  TEST_CASE("stopped in the middle of a step it is damped, and then no drive is enabled") {
    lab<> l(standing());
    l.run();
    for (int k = 0; k < 2500; ++k) l.beat();
    l.controller.stop();
    for (int k = 0; k < 100; ++k) l.beat();
    CHECK(l.enabled() == lab<>::count);  // they damp
    for (int k = 0; k < 2000; ++k) l.beat();
    CHECK(l.enabled() == 0);
    for (std::size_t i = 0; i < lab<>::count; ++i) CHECK(!l.synchronizer().unconfirmed(i));
  }

  TEST_CASE("a board that falls silent stops it") {
    lab<> l(standing());
    l.run();
    for (int k = 0; k < 500; ++k) l.beat();
    l.far.far.board_silent = true;
    for (int k = 0; k < 12; ++k) l.beat();
    CHECK(l.stop().first_cause().rule == hw::safety_rule::sensor_board);
    CHECK(l.stop().mode() != hw::motion_mode::run);
  }
}
