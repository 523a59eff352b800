// What a robot on a drive says when it has stopped: the first cause, with the joint, the drive and the
// number, whatever else has noticed it.
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>
#include <cca/hardware/virtual_robot.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robot/watchdog.hpp>
#include <cca/main/end_of_run.hpp>

#include "torque_pendulum.hpp"

namespace {

using namespace pendulum_test;

struct on_drive : hw::robot<pendulum, end_of_wire, swing_joint> {};

// Its command is made from what the drive measures: while the drive is silent there is none.
struct damper {
  double factor = -0.1;
  auto process(cca::in<"angle", robots::angles<pendulum>> angle) -> cca::out<"torque", torque> {
    return factor * angle.vector()[0];
  }
};

template <int Beats>
struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"damper", damper>,
                                 cca::node<"watchdog", cca::watchdog<torque, Beats>>,
                                 cca::node<"limits", cca::unlimited<torque>>,
                                 cca::node<"robot", on_drive>,
                                 cca::wire<"robot.angles", "damper.angle">,
                                 cca::wire<"damper.torque", "watchdog.command">,
                                 cca::wire<"watchdog.fresh", "limits.command">,
                                 cca::wire<"limits.safe", "robot.torque">> {};

template <int Beats>
class lab {
public:
  lab() {
    motor.now.position = 0.3;
    motor.inertia = 0.02, motor.friction = 0.01, motor.most_torque = 5;
    c.template get<"robot.synchronizer">().connect(near);
    far.connect(end);
    c.load();
    c.start();
  }

  void beats(int n) {
    for (; n > 0 && c.state() != cca::state::faulted; --n) {
      c.step();
      bus.advance(now + 500'000);
      far.listen(now + 500'000);
      motor.advance(far.laws(now + 500'000)[0], 0, 1e-3);
      if (!is_silent) far.tell({motor.now}, {});
      bus.advance((now += 1'000'000) - 1);
    }
  }
  void run() {
    beats(60);
    REQUIRE(c.template get<"robot.synchronizer">().phase() == hw::motion_phase::running);
    CHECK(cca::causes_of(c).empty());
  }
  std::string first() const {
    const auto all = cca::causes_of(c);
    return all.empty() ? "" : all.front();
  }

  wire bus{};
  cca::controller<architecture<Beats>> c{};
  hw::virtual_robot<end_of_wire, hw::virtual_of, hw::no_board, hw::joint_list<swing_joint>> far{};
  hw::virtual_motor motor{};
  bool is_silent = false;
  std::int64_t now = 0;

private:
  end_of_wire near{bus.end(0)}, end{bus.end(1)};
};

}  // namespace

TEST_SUITE("why a robot on drives has stopped") {
  TEST_CASE("a silent drive is named first, and the watchdog that faulted after it") {
    lab<100> l;
    l.run();
    l.is_silent = true;
    l.beats(200);
    REQUIRE(l.c.state() == cca::state::faulted);
    CHECK(l.c.fault_path() == "watchdog.watch");
    const auto all = cca::causes_of(l.c);
    REQUIRE(all.size() == 3);
    CHECK(all[0].starts_with("`robot.synchronizer`, after 0.061 s: swing: its drive (id "));
    CHECK(all[0].find(
              "swing: its drive (id 0x201 on bus 0) is silent: no frame for 3 beats: check its supply") !=
          std::string::npos);
    CHECK(all[1].starts_with("`robot.emergency_stop`, after 0.063 s: swing: silent"));
    CHECK(all[2].starts_with("fault in `watchdog.watch`, after "));
    CHECK(all[2].find("stale command: the oldest data of the command is") != std::string::npos);
    l.c.stop();
    l.is_silent = false;
    for (int k = 0; k < 3000; ++k) l.beats(1);
    l.c.start();
    CHECK(cca::causes_of(l.c).empty());
  }

  TEST_CASE("a fault while the drives are enabled: what is still missing comes first") {
    lab<0> l;
    l.is_silent = true;
    l.beats(10);
    REQUIRE(l.c.state() == cca::state::faulted);
    CHECK_EQ(l.first(),
             "`robot.synchronizer`, after 0.001 s: the start was not over yet: swing: its drive does not "
             "report its "
             "angle");
  }

  TEST_CASE("a fault of the drive, and one that nobody causes") {
    lab<100> l;
    l.run();
    std::get<0>(l.far.drives).fail(0x4310);
    l.beats(20);
    CHECK(l.first().find("swing: its drive (") != std::string::npos);
    CHECK(l.first().find("reports a fault: over-temperature") != std::string::npos);
  }

  TEST_CASE("a command that is not finite, and a button") {
    lab<100> l;
    l.run();
    l.c.get<"damper">().factor = std::numeric_limits<double>::quiet_NaN();
    l.beats(5);
    CHECK(
        l.first().find("`robot.emergency_stop`, after 0.060 s: swing: what it is commanded is not finite") !=
        std::string::npos);
    lab<100> other;
    other.run();
    other.c.get<"robot.emergency_stop">().press();
    other.beats(5);
    CHECK(other.first() == "`robot.emergency_stop`, after 0.060 s: the emergency stop is pressed");
  }

  TEST_CASE("a start that is refused") {
    lab<100'000> l;
    l.motor.now.position = 2.7;  // of a range to 2
    l.beats(2000);
    CHECK(l.first().find("`robot.synchronizer`, after ") == 0);
    CHECK(l.first().find("swing is at 2.7") != std::string::npos);
  }

  TEST_CASE("what the guards have limited is told after the run") {
    lab<100> l;
    l.run();
    CHECK(cca::summaries_of(l.c).empty());
    l.c.get<"damper">().factor = -100;
    l.beats(3);
    const auto all = cca::summaries_of(l.c);
    REQUIRE(!all.empty());
    CHECK(all[0].find("numbers of set points limited; the first: rate of swing, beat 60") !=
          std::string::npos);
  }
}
