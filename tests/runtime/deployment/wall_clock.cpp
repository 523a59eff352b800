// In a wall-clock run an environment never waits for a sample: late ones are counted, and lost contact is a
// fault. What is asserted holds on a machine that is as slow as it likes.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <thread>

#include "alarmed.hpp"
#include "robot_and_mind.hpp"

using namespace deployment_test;

namespace {

struct stall {
  stall(std::int64_t beat, int ms) { beat_that_stalls = beat, stall_in_ms = ms; }
  ~stall() { beat_that_stalls = -1; }
};

struct patient : cca::deployment<architecture,
                                 cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                 cca::environment<"mind", cca::other_nodes>,
                                 cca::tolerate<100000>> {};
struct strict : cca::deployment<architecture,
                                cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                cca::environment<"mind", cca::other_nodes>,
                                cca::tolerate<20>> {};

// All that runs beside the device has a period of ten beats, or of twenty.
struct sleepers : cca::graph<cca::rate<1000>,
                             cca::node<"device", device>,
                             cca::node<"often", filter, cca::timed<10>>,
                             cca::node<"seldom", stalling, cca::timed<20>>,
                             cca::wire<"device.measured", "often.x", cca::delayed<1>>,
                             cca::wire<"often.y", "seldom.x", cca::latest>,
                             cca::wire<"seldom.y", "device.command", cca::delayed<5>>> {};
struct sleeping : cca::deployment<sleepers,
                                  cca::environment<"robot", cca::nodes<"device">>,
                                  cca::environment<"mind", cca::other_nodes>,
                                  cca::tolerate<100000>> {};

template <class D>
void begin(cca::deployed<D>& d) {
  d.load();
  d.start();
}

}  // namespace

TEST_SUITE("deployed in a wall-clock run") {
  TEST_CASE("all environments do the same number of beats, and nothing fails") {
    cca::deployed<patient> d;
    begin(d);
    CHECK_EQ(d.run(cca::for_beats<300>{}, cca::at_wall_clock()), cca::state::started);
    CHECK_EQ(d.beat_index(), 300);
    CHECK_EQ(d.run(cca::for_beats<200>{}, cca::at_speed(4)), cca::state::started);
    CHECK_EQ(d.beat_index(), 500);
    CHECK_EQ(d.get<"device">().senses, 500);  // the first environment loses periods, never a beat
    CHECK(std::isfinite(d.get<"device">().command));
    d.run(cca::for_beats<100>{});  // in a fast run from there on
    CHECK_EQ(d.beat_index(), 600);
  }

  TEST_CASE("an environment that is late too long has lost contact: a fault of all") {
    cca::deployed<strict> d;
    begin(d);
    const stall one(47, 1000);
    CHECK_EQ(d.run(cca::for_<20>{}, cca::at_wall_clock()), cca::state::faulted);
    CHECK_EQ(std::string(d.fault().reason()), "lost contact with `mind`");
    CHECK_EQ(d.fault_path(), "");
    CHECK_EQ(d.get<"device">().faults, 1);
    CHECK_GT(d.late(), 20);
    CHECK_LT(d.beat_index(), 20'000);
    d.resume();
    CHECK_EQ(d.run(cca::for_beats<50>{}), cca::state::started);
    d.stop();
    d.start();
    CHECK_EQ(d.late(), 0);
  }

  TEST_CASE("what is tolerated is counted, and the late environment skips to the beat of the first") {
    cca::deployed<patient> d;
    begin(d);
    const stall one(47, 500);
    CHECK_EQ(d.run(cca::for_beats<800>{}, cca::at_wall_clock()), cca::state::started);
    CHECK_GT(d.late(), 0);
    CHECK_GT(d.overruns(), 0);
    CHECK_GT(d.lost_periods(), 0);
    CHECK_EQ(d.beat_index(), 800);
  }

  TEST_CASE("an environment that is late at the end of a run ends with the others") {
    for (int beat = 95; beat < 100; ++beat) {
      cca::deployed<patient> d;
      begin(d);
      const stall one(beat, 20);
      CHECK_EQ(d.run(cca::for_beats<100>{}, cca::at_wall_clock()), cca::state::started);
      CHECK_EQ(d.beat_index(), 100);
    }
  }

  TEST_CASE("an environment sleeps through the beats in which nothing can fire") {
    cca::deployed<sleeping> d;
    begin(d);
    CHECK_EQ(d.run(cca::for_beats<400>{}, cca::at_wall_clock()), cca::state::started);
    const auto figures = d.figures();
    CHECK_EQ(figures[0].beat.count(), 400);
    CHECK_LE(figures[1].beat.count(), 40);
    CHECK_EQ(figures[1].beat.count() + figures[1].lost_periods / 10, 40);
  }

  TEST_CASE("a fault in a follower stops the resource nodes of all environments within two beats") {
    cca::deployed<alarmed> d;
    begin(d);
    CHECK_EQ(d.run(cca::without_end{}, cca::at_speed(alarmed_speed)), cca::state::faulted);
    CHECK_EQ(d.fault_path(), "alarm");
    const std::int64_t raised_at = d.get<"alarm">().raised_at;
    for (const limb* const each : {&d.get<"arm">(), &d.get<"hand">()}) {
      CHECK_EQ(each->stops, 1);
      CHECK_GE(each->stopped_at, raised_at);
      CHECK_LE(each->stopped_at, raised_at + 2 * alarmed_beat);
    }
  }

  TEST_CASE("between runs with the first environment and ends the run - a fault of a follower ends it too") {
    cca::deployed<patient> d;
    begin(d);
    int calls = 0;
    d.run(cca::without_end{}, cca::at_wall_clock(), [&](auto& same) {
      CHECK_EQ(same.template get<"device">().senses, ++calls);
      CHECK_GE(same.late(), 0);
      return calls < 40;
    });
    CHECK_EQ(calls, 40);
    CHECK_GE(d.beat_index(), 40);
    d.set<"guard">({-1e9});
    CHECK_EQ(d.run(cca::without_end{}, cca::at_wall_clock()), cca::state::faulted);
    CHECK_EQ(d.fault_path(), "guard");
    CHECK_EQ(d.get<"device">().faults, 1);
  }

  TEST_CASE("how each environment kept up can be read from any thread while it runs") {
    cca::deployed<patient> d;
    begin(d);
    std::atomic<bool> ends{false};
    std::int64_t most_seen = 0;
    std::thread reader([&] {
      while (!ends)
        for (const auto& e : d.figures()) most_seen = std::max(most_seen, e.beat.count());
    });
    const stall one(47, 300);
    d.run(cca::for_beats<400>{}, cca::at_wall_clock());
    ends = true;
    reader.join();
    CHECK_GT(most_seen, 0);
    const auto figures = d.figures();
    REQUIRE_EQ(figures.size(), 2);
    CHECK_EQ(figures[0].name, "robot");
    CHECK_EQ(figures[0].beat.count(), 400);
    CHECK_EQ(figures[0].wake_up.count(), 400);
    CHECK_LT(figures[1].beat.count(), 400);
    CHECK_GE(figures[1].beat.most(), 300'000'000);
    CHECK_GE(figures[1].beat.quantile(1), 300'000'000);
    CHECK_LT(figures[1].beat.quantile(0.5), 300'000'000);
    REQUIRE_EQ(figures[0].channels.size(), 1);
    CHECK_EQ(figures[0].channels[0].from, "mind");
    CHECK_EQ(figures[0].channels[0].late + figures[1].channels.at(0).late, d.late());
    CHECK_EQ(figures[0].overruns + figures[1].overruns, d.overruns());
    std::ostringstream table;
    table << figures;
    CHECK_EQ(std::ranges::count(table.str(), '\n'), 3);
    d.stop();
    d.start();
    CHECK_EQ(d.figures()[0].beat.count(), 0);
  }

  TEST_CASE("a histogram keeps every duration to an eighth") {
    cca::histogram h;
    CHECK_EQ(h.quantile(0.5), 0);
    for (std::int64_t ns = 1; ns <= 1'000'000; ns += 7) h.add(ns);
    CHECK_EQ(h.count(), 142'858);
    for (const double part : {0.01, 0.5, 0.9, 0.99, 0.999}) {
      CHECK_GE(static_cast<double>(h.quantile(part)), part * 1e6 * 0.999);
      CHECK_LE(static_cast<double>(h.quantile(part)), part * 1e6 * 1.126);
    }
    CHECK_EQ(h.most(), 1'000'000);
    h.add(-5);
    h.add(std::numeric_limits<std::int64_t>::max());
    CHECK_EQ(h.quantile(0), 0);
    CHECK_EQ(h.count(), 142'860);
    CHECK_EQ(h.most(), std::numeric_limits<std::int64_t>::max());
  }
}
