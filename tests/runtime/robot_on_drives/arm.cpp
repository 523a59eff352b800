// The arm on virtual drives of two families, with the simulator's arm behind them: the laws of its safety
// chain.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <type_traits>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/limiter.hpp>

#include <cca/hardware/virtual_hardware.hpp>
#include <cca/sim/compiled/plant.hpp>
#include <cca/sim/robot/plant.hpp>

#include "../../../examples/touch/drives.hpp"

namespace {

namespace hw = cca::hardware;
namespace arm = cca::robots::arm;
using vector = arm::torques::vector_type;
constexpr std::size_t count = 7;

// The torques of gravity hold the arm, unless a test says otherwise; and a fault when it says so.
struct torques {
  std::optional<vector> instead;
  bool broken = false;

  auto process(cca::in<"gravity", arm::torques> gravity, cca::beat)
      -> std::tuple<cca::out<"torques", arm::torques>, cca::fault> {
    return {instead ? *instead : gravity.vector(), broken ? cca::fault("the test says so") : cca::fault()};
  }
};

// Without a limiter before the robot: its own guards are judged.
template <class Robot>
struct architecture
    : cca::graph<cca::rate<1000>,
                 cca::node<"gravity", cca::gravity_compensation<arm::body, arm::angles, arm::torques>>,
                 cca::node<"torques", torques, cca::timed<1>>,
                 cca::node<"limits", cca::unlimited<arm::torques>>,
                 cca::node<"robot", Robot>,
                 cca::wire<"robot.angles", "gravity.angles">,
                 cca::wire<"gravity.torques", "torques.gravity">,
                 cca::wire<"torques.torques", "limits.command">,
                 cca::wire<"limits.safe", "robot.torque">> {};
struct on_canopen : architecture<touch::on_canopen::robot<hw::virtual_bus_end>> {
  using graph = on_canopen;
  using robot = touch::on_canopen::robot<hw::virtual_bus_end>;
  using world = cca::sim::robot_world;
};
struct on_moteus : architecture<touch::on_moteus::robot<hw::virtual_bus_end>> {
  using graph = on_moteus;
  using robot = touch::on_moteus::robot<hw::virtual_bus_end>;
  using world = cca::sim::robot_world;
};
// The same controller and drives; what moves is compiled.
struct compiled_on_canopen {
  using graph = on_canopen;
  using robot = on_canopen::robot;
  using world = cca::sim::compiled;
};
static_assert(std::is_same_v<cca::sim::plant<arm::description, cca::sim::compiled>::world_type,
                             cca::sim::compiled_world<arm::description>>);
static_assert(cca::well_formed<on_canopen> && cca::well_formed<on_moteus>);
static_assert(cca::embodied<arm::body, touch::on_canopen::robot<hw::virtual_bus_end>>);

// The torque that a frame asks of a drive, N m at the joint; nothing: it asks for none.
template <class J>
std::optional<double> asked(const hw::can_frame& f) {
  using D = typename J::drive;
  if constexpr (requires { typename D::request; }) {
    typename D::request q;
    if (!D::hear(f, q) || q.mode != 10 || q.command.position != q.command.position) return {};
    return J::from_drive({.torque = q.command.torque}).torque;
  } else {
    std::uint16_t word = 0;
    hw::drive_command c;
    if (!D::hear(f, word, c)) return {};
    return J::from_drive(c).torque;
  }
}

// `Case`: its graph, the robot on drives in it, and the world of the plant.
template <class Case>
class lab {
public:
  using joints = typename Case::robot::joints;

  lab() {
    far.plant.hold = cca::sim::held_by::brakes;
    controller.load();
  }
  void beats(int n) {
    for (; n > 0; --n) {
      controller.step();
      far.step([this](std::size_t bus, const hw::can_frame& f) { look(bus, f, joints()); });
    }
  }
  auto& synchronizer() { return controller.template get<"robot.synchronizer">(); }
  auto& stop() { return controller.template get<"robot.emergency_stop">(); }
  auto& wanted() { return controller.template get<"torques">(); }
  void run() {
    controller.start();
    beats(300);
    REQUIRE(synchronizer().phase() == hw::motion_phase::running);
    REQUIRE(stop().mode() == hw::motion_mode::run);
    REQUIRE(enabled() == count);
  }
  std::size_t enabled() const { return far.enabled_count(); }
  double fastest() {
    double most = 0;
    for (const auto& j : far.plant.world().joints()) most = std::max(most, std::abs(j.velocity));
    return most;
  }
  double lean() {  // how far it is from where it began, rad
    double most = 0;
    for (std::size_t i = 0; i < count; ++i)
      most = std::max(most, std::abs(far.plant.world().joints()[i].angle - arm::description::start[i]));
    return most;
  }
  bool damps() const {  // each drive only brakes
    for (std::size_t i = 0; i < count; ++i) {
      const auto& l = far.laws[i];
      if (l.stiffness != 0) return false;
    }
    return true;
  }

  cca::controller<typename Case::graph> controller{};
  hw::virtual_hardware<typename Case::robot, cca::sim::plant<arm::description, typename Case::world>> far{synchronizer()};
  std::array<double, count> most_asked{};
  bool always_finite = true;

private:
  template <class... J>
  void look(std::size_t bus, const hw::can_frame& f, hw::joint_list<J...>) {
    std::size_t i = 0;
    const auto one = [&]<class One>(std::type_identity<One>) {
      if (One::bus == bus)
        if (const auto torque = asked<One>(f)) {
          always_finite = always_finite && std::isfinite(*torque);
          most_asked[i] = std::max(most_asked[i], std::abs(*torque));
        }
      ++i;
    };
    (one(std::type_identity<J>()), ...);
  }
};

// A drive rounds a torque to its step: half a thousandth of the rated torque at most.
template <class Case>
bool within_limits(const lab<Case>& l) {
  for (std::size_t i = 0; i < count; ++i)
    if (!(l.most_asked[i] <= Case::robot::joints::torque[i].upper + 0.016)) return false;
  return l.always_finite;
}

}  // namespace

TEST_SUITE("the arm on drives") {
  TEST_CASE_TEMPLATE("torques of gravity hold it where it was put", G, on_canopen, on_moteus, compiled_on_canopen) {
    const auto l = std::make_unique<lab<G>>();
    l->run();
    l->beats(1000);
    CHECK(l->lean() < 0.05);
    CHECK(l->fastest() < 0.2);
    CHECK(l->stop().first_cause().rule == hw::safety_rule::none);
    CHECK(within_limits(*l));
    for (auto& w : l->far.wires) CHECK(w.end(0).counters().dropped_full == 0);
  }

  TEST_CASE_TEMPLATE(
      "a start outside of the range is refused: it names joint, angle and range, and nothing moves", G,
      on_canopen, on_moteus, compiled_on_canopen) {
    const auto l = std::make_unique<lab<G>>();
    std::array<double, count> q = arm::description::start;
    q[3] = -3;  // and its calibration is wrong
    l->synchronizer().p.offset[3] = -0.65;
    auto world = l->far.plant.world();
    world.place(q, std::array<double, count>{});
    l->far.plant.put_down(std::move(world));
    l->controller.start();
    l->beats(50);
    CHECK(l->synchronizer().refusal() == hw::safety_rule::range);
    const std::string text = hw::text_of(l->synchronizer().failure());
    INFO(text);
    CHECK(text.starts_with("a4 is at -3.6"));
    CHECK(text.find("range -3.072 to -0.070 rad") != std::string::npos);
    l->beats(10);
    CHECK(l->enabled() == 0);
    CHECK(l->synchronizer().phase() == hw::motion_phase::stopped);
  }

  TEST_CASE_TEMPLATE("the operator's stop, pressed: it is damped, then disabled, and each drive confirms", G,
                     on_canopen, on_moteus, compiled_on_canopen) {
    const auto l = std::make_unique<lab<G>>();
    l->run();
    l->stop().press();
    l->beats(3);
    CHECK(l->stop().mode() == hw::motion_mode::damped);
    CHECK(l->stop().first_cause().rule == hw::safety_rule::pressed);
    for (int k = 0; k < 900; ++k) {
      l->beats(1);
      REQUIRE(l->damps());
    }
    CHECK(l->fastest() < 2);
    CHECK(l->synchronizer().phase() == hw::motion_phase::running);
    l->beats(700);
    CHECK_FALSE(l->synchronizer().stopping());
    CHECK(l->enabled() == 0);
    for (std::size_t i = 0; i < count; ++i) CHECK_FALSE(l->synchronizer().unconfirmed(i));
    CHECK(l->fastest() < 0.05);  // the brakes hold it
    CHECK(within_limits(*l));
    l->controller.stop();
    l->controller.start();
    l->beats(300);
    CHECK(l->enabled() == 0);  // a start does not release the button
    l->stop().release();
    l->controller.stop();
    l->run();
  }

  TEST_CASE_TEMPLATE("stop(), and a fault of a component: damped, then disabled, and each drive confirms", G,
                     on_canopen, on_moteus, compiled_on_canopen) {
    for (const bool fault : {false, true}) {
      CAPTURE(fault);
      const auto l = std::make_unique<lab<G>>();
      l->run();
      if (fault) l->wanted().broken = true;
      else l->controller.stop();
      double fastest = 0;
      for (int k = 0; k < 900; ++k) {
        l->beats(1);
        if (k > 2) REQUIRE(l->damps());
        fastest = std::max(fastest, l->fastest());
      }
      CHECK(fastest > 0.05);  // it sinks, and is not free
      CHECK(fastest < 2);
      l->beats(700);
      CHECK_FALSE(l->synchronizer().stopping());
      CHECK(l->enabled() == 0);
      for (std::size_t i = 0; i < count; ++i) CHECK_FALSE(l->synchronizer().unconfirmed(i));
    }
  }

  TEST_CASE_TEMPLATE(
      "a drive fails, falls silent or loses its frames: all are damped, and a start brings it back", G,
      on_canopen, on_moteus, compiled_on_canopen) {
    for (const int trouble : {0, 1, 2}) {
      CAPTURE(trouble);
      const auto l = std::make_unique<lab<G>>();
      l->run();
      auto& drive = l->far.template drive<arm::a4>();
      if (trouble == 0) drive.fail(std::is_same_v<typename G::graph, on_canopen> ? 0x2310u : 38u);
      if (trouble == 1) drive.go_silent(true);
      if (trouble == 2) drive.reboot(l->far.now, 50'000'000);
      l->beats(6);
      CHECK(l->stop().mode() == hw::motion_mode::damped);
      CHECK(l->stop().first_cause().joint == 3);
      CHECK(l->stop().first_cause().rule ==
            (trouble == 0 ? hw::safety_rule::drive_fault : hw::safety_rule::silent));
      for (int k = 0; k < 500; ++k) {
        l->beats(1);
        REQUIRE(l->damps());
      }
      drive.clear();
      l->beats(1200);
      CHECK(l->enabled() == 0);
      CHECK(within_limits(*l));
      l->controller.stop();
      l->run();
    }
  }

  TEST_CASE_TEMPLATE("whatever torque is commanded, none beyond the limits and no NaN is ever on a bus", G,
                     on_canopen, on_moteus, compiled_on_canopen) {
    const auto l = std::make_unique<lab<G>>();
    std::mt19937_64 random(7);
    const auto torque = [&random]() -> double {
      switch (random() % 8) {
        case 0:
          return std::numeric_limits<double>::quiet_NaN();
        case 1:
          return std::numeric_limits<double>::infinity();
        case 2:
          return 1e300;
        case 3:
          return -1e6;
        default:
          return static_cast<double>(static_cast<std::int64_t>(random() % 400)) - 200;
      }
    };
    for (int life = 0; life < 6; ++life) {
      l->wanted().instead.reset();
      l->controller.start();
      l->beats(100);
      for (int k = 0; k < 400; ++k) {
        vector v;
        for (int i = 0; i < v.size(); ++i)
          v[i] = life % 2 == 0 && k < 300 ? 500 * std::cos(0.05 * k + i) : torque();
        l->wanted().instead = v;
        l->beats(1);
      }
      l->controller.stop();
      l->beats(1600);
    }
    CHECK(within_limits(*l));
    CHECK(*std::ranges::max_element(l->most_asked) > 40);
  }

  TEST_CASE_TEMPLATE("a load sensor that is silent, or of which half is lost, stops the arm", G, on_canopen,
                     on_moteus) {
    const auto l = std::make_unique<lab<G>>();
    l->run();
    l->far.far.board_silent = true;
    l->beats(14);
    CHECK(l->stop().mode() == hw::motion_mode::damped);
    CHECK(l->stop().first_cause().rule == hw::safety_rule::sensor_board);
  }

  TEST_CASE("a velocity of the wrong sign: that drive is disabled, since its damping would drive") {
    const auto l = std::make_unique<lab<on_canopen>>();
    l->run();
    l->far.speed_scale[1] = -1;
    vector v = vector::Zero();  // it falls
    l->wanted().instead = v;
    l->beats(150);
    CHECK(l->stop().first_cause().rule == hw::safety_rule::implausible);
    CHECK(l->stop().first_cause().joint == 1);
    CHECK_FALSE(l->far.drive<arm::a2>().enabled());
    CHECK(l->far.drive<arm::a4>().enabled());
  }

  TEST_CASE("a load is taken when force and torque of one measurement have come, and only then") {
    using board = hw::load_board<0x40, 2>;
    auto r = board::reading::untold();
    auto sent = r;
    sent.loads[0] = {0.1, -0.2, 0.3, 10, -20, 30};
    sent.loads[1] = {1, 2, 3, 400, -400, std::nan("")};
    const auto first = board::frames(sent, 1), second = board::frames(sent, 2);
    CHECK(board::decode(first[0], r));
    CHECK(std::isnan(r.loads[0][3]));
    CHECK(board::decode(second[1], r));  // of another measurement
    CHECK(std::isnan(r.loads[0][3]));
    CHECK(board::decode(second[0], r));
    CHECK(board::decode(second[1], r));
    CHECK(r.loads[0][3] == doctest::Approx(10));
    CHECK(r.loads[0][1] == doctest::Approx(-0.2));
    CHECK(r.frames == 0);  // the other sensor is still silent
    CHECK(board::decode(second[2], r));
    CHECK(board::decode(second[3], r));
    CHECK(r.frames == 1);
    CHECK(r.loads[1][3] == doctest::Approx(327.67));  // clamped
    CHECK(r.loads[1][4] == doctest::Approx(-327.67));
    CHECK(r.loads[1][5] == 0);
    for (const auto& other : {hw::can_frame{.id = hw::standard(0x44), .length = 8},
                              hw::can_frame{.id = hw::standard(0x40), .length = 7},
                              hw::can_frame{.id = hw::extended(0x40), .length = 8}})
      CHECK_FALSE(board::decode(other, r));
  }
}
