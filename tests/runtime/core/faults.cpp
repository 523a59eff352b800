// Faults: the beat ends at once, every resource node's on_fault runs in the same beat, and nothing fires
// until resume().
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

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

struct failing_first {
  auto process(cca::beat now) -> cca::fault {
    return now.index() == fails_in ? cca::fault("as planned") : cca::fault();
  }
  std::int64_t fails_in = -1;
};
struct rising {
  auto process(cca::beat now) -> cca::out<"y", reading> { return 1.0 + static_cast<double>(now.index()); }
};
struct late_reader {
  void process(cca::in<"x", reading> x) { seen = x[cca::x{}]; }
  double seen = 0;
};
struct cut : cca::graph<cca::rate<1000>,
                        cca::node<"first", failing_first>,
                        cca::node<"rising", rising>,
                        cca::node<"late", late_reader, cca::full_speed>,
                        cca::wire<"rising.y", "late.x", cca::delayed<3>, cca::initial<0.5>>> {};

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

// When it fired, and what it was told of the time since then.
struct timekeeper {
  std::vector<std::int64_t> beats{}, told{};  // told: in beats
  std::vector<bool> fresh{};
  void note(cca::beat now) {
    beats.push_back(now.index());
    told.push_back(std::llround(now.dt() * 1e9 / static_cast<double>(now.period())));
  }
  bool is_right(std::int64_t first) const {
    for (std::size_t i = 0; i < beats.size(); ++i)
      if (told[i] != (i == 0 ? first : beats[i] - beats[i - 1])) return false;
    return true;
  }
};
struct source_of_time : timekeeper {
  auto process(cca::beat now) -> cca::out<"y", reading> { return note(now), 1; }
};
struct sink_of_time : timekeeper {
  void process(cca::in<"x", reading> x, cca::beat now) {
    note(now);
    fresh.push_back(x.fresh());
  }
};
struct failing_when_told {
  auto process(cca::in<"x", reading>, cca::beat now) -> cca::fault {
    return std::ranges::count(fails_in, now.index()) > 0 ? cca::fault("as planned") : cca::fault();
  }
  std::vector<std::int64_t> fails_in{};
};
// Before and after the fault, at several clocks, in a part, and by a deduced clock.
struct keeps_time : cca::graph<cca::rate<1000>,
                               cca::node<"before", source_of_time, cca::timed<4>>,
                               cca::node<"fails", failing_when_told, cca::timed<1>>,
                               cca::node<"each", source_of_time, cca::timed<1>>,
                               cca::node<"third", source_of_time, cca::timed<3, 2>>,
                               cca::node<"deduced", sink_of_time>,
                               cca::node<"looks", sink_of_time, cca::timed<1>>,
                               cca::node<"part", source_of_time, cca::stoppable<cca::timed<2>>>,
                               cca::node<"occasional", sink_of_time>,
                               cca::wire<"before.y", "fails.x", cca::latest>,
                               cca::wire<"third.y", "deduced.x">,
                               cca::wire<"before.y", "looks.x", cca::latest>,
                               cca::wire<"part.y", "occasional.x">> {};

}  // namespace

TEST_SUITE("faults") {
  TEST_CASE("after a fault dt() is the time since a component last fired, and fresh what came since then") {
    // In one beat, in several one after another, in the first, and in some more than a period apart.
    for (const std::vector<std::int64_t>& faults : {std::vector<std::int64_t>{},
                                                    {5},
                                                    {0},
                                                    {2},
                                                    {8},
                                                    {4, 5, 6, 7, 8, 9},
                                                    {5, 8, 11, 14},
                                                    {0, 1, 2, 3, 17}}) {
      CAPTURE(faults);
      auto c = started<keeps_time>();
      c.get<"fails">().fails_in = faults;
      while (c.beat_index() < 30) {
        if (c.state() == cca::state::faulted) {
          const auto copy = c;  // a snapshot
          c = copy;
          c.resume();
        }
        if (c.beat_index() == 20) c.stop<"part">();
        if (c.beat_index() == 23) c.start<"part">();
        c.step();
      }
      CHECK(c.get<"before">().is_right(4));
      CHECK(c.get<"each">().is_right(1));
      CHECK(c.get<"third">().is_right(3));
      CHECK(c.get<"deduced">().is_right(1));
      CHECK(c.get<"looks">().is_right(1));
      CHECK(c.get<"occasional">().is_right(1));
      const auto& part = c.get<"part">();
      for (std::size_t i = 1; i < part.beats.size(); ++i)
        CHECK_EQ(part.told[i],
                 part.beats[i - 1] < 20 && part.beats[i] >= 23 ? 2 : part.beats[i] - part.beats[i - 1]);
      // `before` comes before the fault, so what it published in that beat is fresh in the next.
      const auto& looks = c.get<"looks">();
      const auto& before = c.get<"before">().beats;
      for (std::size_t i = 0; i < looks.beats.size(); ++i) {
        const std::int64_t last = i == 0 ? -1 : looks.beats[i - 1];
        CHECK_EQ(looks.fresh[i], std::ranges::any_of(before, [&](std::int64_t k) {
                   return k > last && k <= looks.beats[i];
                 }));
      }
    }
  }

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

  TEST_CASE("after a beat that a fault cut, a delayed reader never sees an older sample than before") {
    auto c = started<cut>();
    std::vector<double> seen;
    for (int i = 0; i < 3; ++i) {
      c.get<"first">().fails_in = 5 * i;
      c.run(cca::for_beats<20>{}, {}, [&](auto& same) {
        if (same.state() == cca::state::running) seen.push_back(same.template get<"late">().seen);
      });
      c.resume();
    }
    c.run(cca::for_beats<20>{}, {}, [&](auto& same) { seen.push_back(same.template get<"late">().seen); });
    CHECK_EQ(seen.front(), 0.5);  // the initial value: nothing was published before
    CHECK(std::ranges::is_sorted(seen));
    CHECK_EQ(seen.back(), 28);
  }
}
