// Faults: the beat ends at once, every resource node's on_fault runs in the same beat, and nothing fires
// until resume().
#include <doctest/doctest.h>

#include "counting.hpp"

using namespace core_test;

namespace {

std::vector<std::string> notified;

// [fault]
struct motor {
  auto sense() -> std::tuple<cca::out<"angle", reading>, cca::fault> {
    return {angle, unplugged ? cca::fault("the encoder is unplugged") : cca::fault()};
  }
  auto act(cca::in<"command", reading> to) -> cca::fault {
    if (to[cca::x{}] > 100) return cca::fault("the drive refused the command");
    angle = to[cca::x{}];
    return {};
  }
  void on_fault() { braked = true; }

  double angle = 0;
  bool unplugged = false, braked = false;
};
// [fault end]

struct checking {
  auto process(cca::in<"x", reading> x) -> std::tuple<cca::out<"y", reading>, cca::fault> {
    return {x[cca::x{}], x[cca::x{}] > limit ? cca::fault("more than the limit") : cca::fault()};
  }
  double limit = 1e9;
};
struct inner
    : cca::graph<cca::node<"check", checking>, cca::expose<"check.x", "x">, cca::expose<"check.y", "y">> {};
template <cca::fixed_string Name>
struct witness {
  void act(cca::in<"x", reading>) { ++acts; }
  void on_fault() { notified.push_back(std::string(Name.view())); }
  int acts = 0;
};
struct stage : cca::graph<cca::rate<1000>,
                          cca::node<"motor", motor>,
                          cca::node<"before", counter>,
                          cca::node<"checks", inner>,
                          cca::node<"later", adder>,
                          cca::node<"one", witness<"one">>,
                          cca::node<"two", witness<"two">>,
                          cca::wire<"before.y", "checks.x">,
                          cca::wire<"checks.y", "later.x">,
                          cca::wire<"later.y", "motor.command">,
                          cca::wire<"later.y", "one.x">,
                          cca::wire<"later.y", "two.x">> {};

struct overflowing : cca::graph<cca::rate<1000>,
                                cca::node<"noise", counter, cca::any_of<cca::timeout<1>, cca::timed<1>>>,
                                cca::node<"sometimes", adder, cca::inactive>,
                                cca::wire<"noise.y", "sometimes.x", cca::queue<3, cca::drop_oldest>>> {};

struct brake {
  void act(cca::in<"x", reading>) { ++acts; }
  void on_idle() { ++idle; }
  int acts = 0, idle = 0;
};
struct braking : cca::graph<cca::rate<1000>,
                            cca::node<"before", counter>,
                            cca::node<"check", checking>,
                            cca::node<"brake", brake>,
                            cca::wire<"before.y", "check.x">,
                            cca::wire<"check.y", "brake.x">> {};

struct now_and_then {
  auto process() -> cca::maybe<"y", reading> { return 1; }
};
struct filling : cca::graph<cca::rate<1000>,
                            cca::node<"writer", now_and_then>,
                            cca::node<"reader", adder, cca::timed<4, 3>>,
                            cca::node<"device", witness<"device">>,
                            cca::wire<"writer.y", "reader.x", cca::queue<2, cca::reject>>,
                            cca::wire<"reader.y", "device.x", cca::latest>> {};

}  // namespace

TEST_SUITE("faults") {
  TEST_CASE("a component faults") {
    auto c = started<stage>();
    c.get<"checks.check">().limit = 4;
    notified.clear();
    CHECK_EQ(c.run(cca::for_beats<100>{}), cca::state::faulted);
    CHECK_EQ(c.beat_index(), 5);
    CHECK_EQ(std::string(c.fault().reason()), "more than the limit");
    CHECK(c.fault());
    CHECK_EQ(c.fault_path(), "checks.check");
    CHECK_EQ(c.get<"before">().value, 5);
    CHECK_EQ(c.get<"later">().sum, 1 + 2 + 3 + 4);  // it did not fire in the beat of the fault
    CHECK_EQ(c.get<"motor">().angle, 10);
    CHECK_EQ(c.get<"one">().acts, 4);
    CHECK(c.get<"motor">().braked);
    CHECK_EQ(notified, std::vector<std::string>{"one", "two"});

    CHECK_FALSE(c.step());
    CHECK_EQ(c.beat_index(), 5);
    CHECK_EQ(notified.size(), 2);  // on_fault ran once per node

    c.get<"checks.check">().limit = 7;
    c.resume();
    CHECK_FALSE(c.fault());
    CHECK_EQ(c.fault_path(), "");
    CHECK_EQ(c.run(cca::for_beats<100>{}), cca::state::faulted);
    CHECK_EQ(c.beat_index(), 8);
    CHECK_EQ(c.get<"later">().sum, 1 + 2 + 3 + 4 + 6 + 7);
  }

  TEST_CASE("a fault in sense: no component fires") {
    auto c = started<stage>();
    c.run(cca::for_beats<3>{});
    c.get<"motor">().unplugged = true;
    CHECK(c.step());  // this was a beat, the one with the fault
    CHECK_EQ(c.state(), cca::state::faulted);
    CHECK_EQ(c.fault_path(), "motor");
    CHECK_EQ(std::string(c.fault().reason()), "the encoder is unplugged");
    CHECK_EQ(c.get<"before">().value, 3);
    CHECK_EQ(c.get<"one">().acts, 3);
    CHECK(c.get<"motor">().braked);
  }

  TEST_CASE("a fault in act: later acts don't run") {
    auto c = started<stage>();
    CHECK_EQ(c.run(cca::for_beats<100>{}), cca::state::faulted);  // 1 + 2 + ... + 14 > 100
    CHECK_EQ(c.beat_index(), 14);
    CHECK_EQ(std::string(c.fault().reason()), "the drive refused the command");
    CHECK_EQ(c.get<"later">().sum, 105);
    CHECK_EQ(c.get<"one">().acts, 13);
    CHECK_EQ(c.get<"motor">().angle, 91);
  }

  TEST_CASE("a full queue with cca::reject is a fault") {
    auto c = started<filling>();
    notified.clear();
    CHECK_EQ(c.run(cca::for_beats<100>{}), cca::state::faulted);
    CHECK_EQ(c.beat_index(), 3);  // the third sample arrives before the reader takes the first
    CHECK_EQ(std::string(c.fault().reason()), "a sample arrived while the queue was full");
    CHECK_EQ(c.fault_path(), "reader");
    CHECK_EQ(notified, std::vector<std::string>{"device"});
  }

  TEST_CASE("on_idle of a resource node runs in each step() that runs no beat") {
    auto c = started<braking>();
    c.get<"check">().limit = 2;
    CHECK_EQ(c.run(cca::for_beats<100>{}), cca::state::faulted);
    CHECK_EQ(c.get<"brake">().idle, 0);
    for (int k = 1; k <= 3; ++k) {
      CHECK_FALSE(c.step());
      CHECK_EQ(c.get<"brake">().idle, k);
    }
    CHECK_EQ(c.beat_index(), 3);
    CHECK_EQ(c.get<"brake">().acts, 2);
    c.get<"check">().limit = 100;
    c.resume();
    CHECK(c.step());
    CHECK_EQ(c.get<"brake">().idle, 3);
    c.stop();
    CHECK_FALSE(c.step());
    CHECK_EQ(c.get<"brake">().idle, 4);
  }

  TEST_CASE("a copy of a faulted controller is faulted") {
    auto c = started<stage>();
    c.get<"checks.check">().limit = 0;
    c.step();
    auto copy = c;
    CHECK_EQ(copy.state(), cca::state::faulted);
    CHECK_EQ(std::string(copy.fault().reason()), "more than the limit");
    copy.resume();
    CHECK_EQ(c.state(), cca::state::faulted);
  }
}
