// One robot with several families of drives: moteus on CAN FD, ODrive, CiA 402 with its SYNC, MIT. Eight
// plain motors are its mechanics.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/oncilla.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>
#include <cca/hardware/virtual_robot.hpp>

namespace {

namespace hw = cca::hardware;
namespace sim = cca::sim;

struct n1 {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.02;
};
struct epos {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 65536, torque = 2;
};
inline constexpr hw::joint_servo servo{.stiffness = 20, .damping = 0.5};

template <class Axis, class Drive, std::size_t Bus, hw::mounting Mounting = hw::mounting{}>
using joint = hw::joint<Axis, Drive, Mounting, servo, Bus>;
inline constexpr hw::mounting turned{.gear = 2, .sign = -1, .offset = 0.3};
template <std::uint32_t Node, hw::odrive_mode Mode>
using odrive = hw::odrive<Node, Mode, hw::odrive_firmware::v0_6, 1'000'000>;

// [families]
struct left_front_hip : joint<sim::left_front_hip, hw::moteus<n1, 1>, 0, turned> {};
struct right_front_hip : joint<sim::right_front_hip, hw::moteus<n1, 2>, 0> {};
struct left_hind_hip : joint<sim::left_hind_hip, odrive<1, hw::odrive_mode::position>, 1> {};
struct right_hind_hip : joint<sim::right_hind_hip, odrive<2, hw::odrive_mode::torque>, 1, turned> {};
struct left_front_knee : joint<sim::left_front_knee, hw::cia402<epos, 1, hw::cia402_mode::position>, 2> {};
struct right_front_knee : joint<sim::right_front_knee, hw::cia402<epos, 2, hw::cia402_mode::torque>, 2> {};
struct left_hind_knee : joint<sim::left_hind_knee, hw::mit_drive<hw::ak60_6, 1>, 3> {};
struct right_hind_knee
    : joint<sim::right_hind_knee, hw::mit_drive<hw::ak60_6, 2, 0, hw::mit_firmware::damiao>, 3> {};
struct board : hw::sensor_board<0x40, 4> {};
// [families end]

using joints = hw::joint_list<left_front_hip,
                              right_front_hip,
                              left_hind_hip,
                              right_hind_hip,
                              left_front_knee,
                              right_front_knee,
                              left_hind_knee,
                              right_hind_knee>;
using wire = hw::memory_bus<2, 16>;

struct robot : hw::oncilla<wire::end_type,
                           left_front_hip,
                           right_front_hip,
                           left_hind_hip,
                           right_hind_hip,
                           left_front_knee,
                           right_front_knee,
                           left_hind_knee,
                           right_hind_knee,
                           board> {};

using plan = hw::robot_buses<cca::rate<1000>, board, joints>;
static_assert(plan::load<0> < 0.6);
static_assert(plan::load<2> > 0.75 && plan::load<2> < 0.9);                  // SYNC counts once
static_assert(plan::requests<2>.count == 4 && plan::replies<2>.count == 8);  // with NMT and SYNC
static_assert(hw::cycle_ends<3, left_front_knee, right_front_knee>()[2].size() == 1);

constexpr std::size_t count = joints::count;
constexpr double start_at(std::size_t i) { return (joints::angle[i].lower + joints::angle[i].upper) / 2; }
constexpr double step = 0.15;

struct posture {
  auto process() -> cca::out<"angles", sim::leg_angles> {
    sim::leg_angles::vector_type v;
    for (std::size_t i = 0; i < count; ++i) v[static_cast<Eigen::Index>(i)] = start_at(i) + step;
    return v;
  }
};

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"posture", posture>,
                                 cca::node<"limits", cca::limiter<sim::leg_angles>>,
                                 cca::node<"robot", robot>,
                                 cca::wire<"posture.angles", "limits.command">,
                                 cca::wire<"limits.safe", "robot.command">> {};

class lab {
public:
  lab() {
    for (std::size_t i = 0; i < count; ++i) {
      motors[i].now.position = start_at(i);
      if (is_pulled(i)) motors[i].friction = 0.3;
    }
    controller.get<"robot.synchronizer">().connect(near[0], near[1], near[2], near[3], near[4]);
    far.connect(ends[0], ends[1], ends[2], ends[3], ends[4]);
    controller.load();
  }
  lab(const lab&) = delete;
  lab& operator=(const lab&) = delete;

  void beats(int n) {
    for (; n > 0; --n) {
      controller.step();
      go_to(now + 500'000);
      far.listen(now + 500'000,
                 [this](std::size_t, const hw::can_frame& f) { syncs += f == hw::canopen_sync(); });
      laws = far.laws(now + 500'000);
      std::array<hw::drive_motion, count> motions;
      for (std::size_t i = 0; i < count; ++i) {
        motors[i].advance(laws[i], spring(i), 1e-3);
        motions[i] = motors[i].now;
        if (without_speed[i]) motions[i].velocity = std::numeric_limits<double>::quiet_NaN();
      }
      far.tell(motions, {});
      go_to((now += 1'000'000) - 1);
    }
  }
  auto& stop() { return controller.get<"robot.emergency_stop">(); }
  auto& synchronizer() { return controller.get<"robot.synchronizer">(); }
  // A drive that takes torque alone is damped by torque against its speed.
  bool all_give_way() const {
    for (std::size_t i = 0; i < count; ++i) {
      const auto& c = laws[i];
      const double speed = motors[i].now.velocity;
      const bool brakes =
          c.torque * speed <= 0 && std::abs(c.torque) <= servo.safe_damping * std::abs(speed) + 0.1;
      if (c.stiffness != 0 || !(brakes || std::abs(c.torque) <= 0.01) ||
          std::abs(c.velocity * c.damping) > 0.05)
        return false;
    }
    return true;
  }
  // One bit for each enabled drive.
  unsigned enabled() const {
    unsigned bits = 0, bit = 1;
    std::apply([&](const auto&... drive) { ((bits |= drive.enabled() ? bit : 0u, bit <<= 1), ...); },
               far.drives);
    return bits;
  }
  template <class F>
  void of_drive(std::size_t which, F f) {
    std::size_t i = 0;
    std::apply([&](auto&... drive) { ((i++ == which ? f(drive) : void()), ...); }, far.drives);
  }
  bool all_there() const {
    for (std::size_t i = 0; i < count; ++i)
      if (std::abs(motors[i].now.position - start_at(i) - step) > 0.03) return false;
    return true;
  }

  std::array<wire, 5> wires;
  cca::controller<architecture> controller{};
  hw::virtual_robot<wire::end_type, hw::virtual_of, board, joints> far{};
  std::array<hw::virtual_motor, count> motors{};
  std::array<hw::drive_command, count> laws{};
  std::array<bool, count> without_speed{};
  std::int64_t now = 0;
  int syncs = 0;

private:
  // A cable pulls the robot's knees against a spring.
  static constexpr bool is_pulled(std::size_t i) { return joints::torque[i].lower >= 0; }
  double spring(std::size_t i) const { return is_pulled(i) ? 2 * (start_at(i) - motors[i].now.position) : 0; }
  void go_to(std::int64_t time) {
    for (auto& w : wires) w.advance(time);
  }
  std::array<wire::end_type, 5> near{wires[0].end(0), wires[1].end(0), wires[2].end(0), wires[3].end(0),
                                     wires[4].end(0)};
  std::array<wire::end_type, 5> ends{wires[0].end(1), wires[1].end(1), wires[2].end(1), wires[3].end(1),
                                     wires[4].end(1)};
};

}  // namespace

TEST_SUITE("families of drives") {
  TEST_CASE("a robot with all families is enabled, and each joint goes softly to its command") {
    lab l;
    l.controller.start();
    double fastest = 0;
    for (int k = 0; k < 2000; ++k) {
      l.beats(1);
      for (const auto& m : l.motors) fastest = std::max(fastest, std::abs(m.now.velocity));
    }
    CHECK(l.synchronizer().phase() == hw::motion_phase::running);
    CHECK(l.stop().mode() == hw::motion_mode::run);
    CHECK(l.stop().first_cause().rule == hw::safety_rule::none);
    CHECK(l.all_there());
    CHECK(fastest < 3);
    CHECK(l.syncs >= 1990);  // one a beat for both drives on this bus
    CHECK(l.syncs <= 2000);
    for (auto& w : l.wires) CHECK(w.end(0).counters().dropped_full == 0);
    l.controller.stop();
    l.beats(3);
    CHECK(l.all_give_way());
  }

  TEST_CASE(
      "if a drive of any family fails, falls silent or reboots, all give way, and a start brings them back") {
    const auto check = []<std::size_t Drive>(std::index_sequence<Drive>, std::uint32_t code) {
      CAPTURE(Drive);
      lab l;
      auto& drive = std::get<Drive>(l.far.drives);
      l.controller.start();
      l.beats(1200);
      REQUIRE(l.stop().mode() == hw::motion_mode::run);
      REQUIRE(l.all_there());
      const auto recovers = [&](hw::safety_rule rule, int joint) {
        CHECK(l.stop().mode() == hw::motion_mode::damped);
        CHECK(l.stop().first_cause().rule == rule);
        CHECK(l.stop().first_cause().joint == joint);
        CHECK(l.all_give_way());
        CHECK_MESSAGE(l.laws[1].damping > 0,
                      "a moteus damps by its brake, since a set point without stiffness does not damp it");
        drive.clear();
        l.beats(50);
        CHECK(l.all_give_way());
        l.controller.stop();
        l.controller.start();
        l.beats(1500);
        CHECK(l.stop().mode() == hw::motion_mode::run);
        CHECK(l.all_there());
      };
      drive.fail(code);
      l.beats(110);  // an ODrive reports it in its next heartbeat
      recovers(hw::safety_rule::drive_fault, static_cast<int>(Drive));
      drive.go_silent(true);
      l.beats(6);
      CHECK_MESSAGE(l.stop().mode() == hw::motion_mode::damped, "three beats of silence are enough");
      l.beats(64);  // meanwhile the drive's own watchdog runs out
      recovers(hw::safety_rule::silent, static_cast<int>(Drive));
      drive.reboot(l.now, 100'000'000);
      l.beats(200);
      recovers(hw::safety_rule::silent, static_cast<int>(Drive));
    };
    check(std::index_sequence<0>(), 38);
    check(std::index_sequence<2>(), 0x1000);
    check(std::index_sequence<3>(), 0x1000);
    check(std::index_sequence<4>(), 0x2310);
    check(std::index_sequence<5>(), 0x2310);
    check(std::index_sequence<6>(), 2);
  }

  TEST_CASE("pressed, the emergency stop lets no drive of any family be enabled, nor does a start") {
    for (std::size_t missing = 0; missing < count; ++missing) {
      CAPTURE(missing);
      lab l;
      l.of_drive(missing, [](auto& d) { d.go_silent(true); });
      l.stop().press();
      l.controller.start();
      for (int k = 0; k < 900; ++k) {
        l.beats(1);
        REQUIRE(l.enabled() == 0);
        REQUIRE(l.all_give_way());
      }
      CHECK(l.synchronizer().refusal() == hw::safety_rule::pressed);
      l.controller.stop();
      l.controller.start();  // does not release the button
      l.of_drive(missing, [](auto& d) { d.go_silent(false); });
      for (int k = 0; k < 200; ++k) {
        l.beats(1);
        REQUIRE(l.enabled() == 0);
      }
      if (missing % 3 != 0) continue;
      l.stop().release();
      l.beats(100);
      CHECK(l.enabled() == 0);  // nor does the release alone enable anything
      l.controller.stop();
      l.controller.start();
      l.beats(1500);
      CHECK(l.stop().mode() == hw::motion_mode::run);
      CHECK(l.all_there());
    }
  }

  // Of each family one drive at least holds its position when the button is pressed: the start waits for the
  // missing one.
  TEST_CASE("pressed while drives are being enabled, those that are already enabled are disabled") {
    unsigned were_enabled = 0;
    for (std::size_t missing = 0; missing < count; ++missing) {
      CAPTURE(missing);
      lab l;
      l.of_drive(missing, [](auto& d) { d.go_silent(true); });
      l.controller.start();
      l.beats(300);
      REQUIRE(l.synchronizer().phase() == hw::motion_phase::enabling);
      were_enabled |= l.enabled();
      CHECK(std::popcount(l.enabled()) >= 7);
      l.stop().press();
      l.beats(10);
      CHECK(l.enabled() == 0);
      CHECK(l.all_give_way());
      l.of_drive(missing, [](auto& d) { d.go_silent(false); });
      for (int k = 0; k < 900; ++k) {
        l.beats(1);
        REQUIRE(l.enabled() == 0);
        REQUIRE(l.all_give_way());
      }
      CHECK(l.synchronizer().refusal() == hw::safety_rule::pressed);
    }
    CHECK(were_enabled == 0xFF);
  }

  TEST_CASE("a drive that no longer reports its velocity trips after three answers, and all give way") {
    for (const std::size_t drive : {2u, 3u}) {
      CAPTURE(drive);
      lab l;
      l.controller.start();
      l.beats(1200);
      REQUIRE(l.stop().mode() == hw::motion_mode::run);
      l.without_speed[drive] = true;
      l.beats(5);
      CHECK(l.stop().mode() == hw::motion_mode::damped);
      CHECK(l.stop().first_cause().rule == hw::safety_rule::implausible);
      CHECK(l.stop().first_cause().joint == static_cast<int>(drive));
      l.beats(5);
      CHECK(l.all_give_way());
      l.without_speed[drive] = false;
      l.controller.stop();
      l.controller.start();
      l.beats(1500);
      CHECK(l.stop().mode() == hw::motion_mode::run);
      CHECK(l.all_there());
    }
  }

  TEST_CASE("a drive that does not report its velocity is not enabled") {
    lab l;
    l.without_speed[2] = true;
    l.controller.start();
    l.beats(1000);
    CHECK(l.synchronizer().refusal() == hw::safety_rule::enabling);
    CHECK(l.synchronizer().phase() == hw::motion_phase::stopped);
    l.beats(3);
    CHECK(l.all_give_way());
  }

  TEST_CASE("a CANopen drive whose frames of velocity are lost trips, and is not started without them") {
    std::array<hw::bus_fault, 1> lost{{{.what = hw::bus_trouble::lose,
                                        .from = 1'200'000'000,
                                        .end = 0,
                                        .frames = hw::can_filter{hw::standard(0x281)}}}};
    lab late;
    late.wires[2] = wire({.script = lost});
    late.controller.start();
    late.beats(1200);
    REQUIRE(late.stop().mode() == hw::motion_mode::run);
    late.beats(5);
    CHECK(late.stop().mode() == hw::motion_mode::damped);
    CHECK(late.stop().first_cause().rule == hw::safety_rule::implausible);
    CHECK(late.stop().first_cause().joint == 4);

    lost[0].from = 0;
    lab never;
    never.wires[2] = wire({.script = lost});
    never.controller.start();
    never.beats(1000);
    CHECK(never.synchronizer().refusal() == hw::safety_rule::enabling);
    CHECK(hw::text_of(never.synchronizer().failure()) ==
          "left_front_knee: its drive does not report its velocity");
  }
}
