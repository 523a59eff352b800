// While a run ends, the robot's side never waits: its environment idles once a period until all others have
// ended. The mind hangs until the robot has idled so often, so no test depends on how fast the machine is.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "robot_and_mind.hpp"

using namespace deployment_test;

namespace {

using namespace std::chrono_literals;

// Idle calls of all robots; what a hanging mind waits for.
std::atomic<int> idles{0};
constexpr int enough = 70;  // more than late beats are tolerated

struct watched {
  int faults = 0, own_idles = 0;
  std::thread::id sensed_in{}, idled_in{};
  std::int64_t beats = 0;
  auto sense(cca::beat) -> cca::out<"measured", level> {
    ++beats;
    sensed_in = std::this_thread::get_id();
    return 0.0;
  }
  void act(cca::in<"command", level>) {}
  void on_fault() { ++faults; }
  void on_idle() {
    ++own_idles;
    idled_in = std::this_thread::get_id();
    ++idles;
  }
};

// Hangs in one beat or, where that is lost on a busy machine, the next one, until the robots have idled often
// enough. 10 s: they do not.
struct mind {
  std::int64_t hangs_in = -1, hung_in = -1;
  std::atomic<bool>* tells = nullptr;
  bool has_given_up = false;
  auto process(cca::in<"x", level>, cca::beat now) -> cca::out<"y", level> {
    if (hangs_in < 0 || now.index() < hangs_in) return 0.0;
    hangs_in = -1;
    hung_in = now.index();
    if (tells) *tells = true;
    const auto since = std::chrono::steady_clock::now();
    while (idles < enough && !has_given_up) {
      std::this_thread::sleep_for(1ms);
      has_given_up = std::chrono::steady_clock::now() - since > 10s;
    }
    return 0.0;
  }
};

struct one_robot : cca::graph<cca::rate<1000>,
                              cca::node<"robot", watched>,
                              cca::node<"mind", mind, cca::timed<1>>,
                              cca::wire<"robot.measured", "mind.x", cca::delayed<1>>,
                              cca::wire<"mind.y", "robot.command", cca::delayed<1>>> {};
template <int Tolerated>
struct robot_first : cca::deployment<one_robot,
                                     cca::environment<"robot", cca::nodes<"robot">>,
                                     cca::environment<"mind", cca::other_nodes>,
                                     cca::tolerate<Tolerated>> {};
template <int Tolerated>
struct mind_first : cca::deployment<one_robot,
                                    cca::environment<"mind", cca::nodes<"mind">>,
                                    cca::environment<"robot", cca::other_nodes>,
                                    cca::tolerate<Tolerated>> {};
constexpr int for_ever = 1'000'000;

// Beats of 5 ms: on a busy machine nobody is late for 50 of them, but who hangs.
cca::at_speed patient_clock() { return cca::at_speed(0.2); }

struct two_robots : cca::graph<cca::rate<1000>,
                               cca::node<"arm", watched>,
                               cca::node<"hand", watched>,
                               cca::node<"mind", mind, cca::timed<1>>,
                               cca::wire<"arm.measured", "mind.x", cca::delayed<1>>,
                               cca::wire<"mind.y", "arm.command", cca::delayed<1>>,
                               cca::wire<"mind.y", "hand.command", cca::delayed<1>>> {};

struct apart : cca::deployment<two_robots,
                               cca::environment<"arm", cca::nodes<"arm">>,
                               cca::environment<"mind", cca::nodes<"mind">>,
                               cca::environment<"hand", cca::nodes<"hand">>,
                               cca::tolerate<50>> {};

// Fires once in a thousand beats.
struct sleeper : cca::graph<cca::rate<1000>,
                            cca::node<"robot", watched>,
                            cca::node<"mind", mind, cca::timed<1000>>,
                            cca::wire<"robot.measured", "mind.x", cca::delayed<1>>,
                            cca::wire<"mind.y", "robot.command", cca::delayed<1000>>> {};
struct sleeping : cca::deployment<sleeper,
                                  cca::environment<"robot", cca::nodes<"robot">>,
                                  cca::environment<"mind", cca::other_nodes>> {};

template <class D>
void begin(cca::deployed<D>& d, std::int64_t hangs_in) {
  idles = 0;
  d.load();
  d.start();
  d.template get<"mind">().hangs_in = hangs_in;
}

}  // namespace

TEST_SUITE("ending a run") {
  TEST_CASE("after lost contact the robot idles while the mind hangs, in the thread of its beats") {
    cca::deployed<robot_first<50>> d;
    begin(d, 20);
    CHECK_EQ(d.run(cca::without_end{}, patient_clock()), cca::state::faulted);
    CHECK_EQ(std::string(d.fault().reason()), "lost contact with `mind`");
    CHECK_FALSE(d.get<"mind">().has_given_up);
    const std::string cause = d.fault_cause();
    CAPTURE(cause);
    CHECK(cause.starts_with("`mind` needed "));
    CHECK(cause.find(" ms of 5 ms in beat " + std::to_string(d.get<"mind">().hung_in) +
                     ": give its wires a greater delay, or the deployment more than `tolerate<50>`") !=
          std::string::npos);
    const watched& robot = d.get<"robot">();
    CHECK_GE(robot.own_idles, enough);
    CHECK_EQ(robot.faults, 1);
    CHECK_EQ(robot.idled_in, robot.sensed_in);
  }

  TEST_CASE("after the last beat, and where `between` ends the run") {
    for (const bool by_between : {false, true}) {
      cca::deployed<robot_first<for_ever>> d;
      begin(d, 20);
      std::atomic<bool> hangs{false};
      d.get<"mind">().tells = &hangs;
      const auto between = [&](auto&) { return !(by_between && hangs); };
      if (by_between) d.run(cca::without_end{}, cca::at_wall_clock(), between);
      else d.run(cca::for_beats<21>{}, cca::at_wall_clock(), between);
      CHECK_EQ(d.state(), cca::state::started);
      CHECK_FALSE(d.get<"mind">().has_given_up);
      CHECK_EQ(d.get<"robot">().faults, 0);
      CHECK_EQ(d.beat_index(), d.get<"robot">().beats);
    }
  }

  TEST_CASE("where `between` throws") {
    cca::deployed<robot_first<for_ever>> d;
    begin(d, 20);
    std::atomic<bool> hangs{false};
    d.get<"mind">().tells = &hangs;
    CHECK_THROWS_AS(d.run(cca::without_end{}, cca::at_wall_clock(),
                          [&](auto&) {
                            if (hangs) throw std::runtime_error("enough");
                          }),
                    std::runtime_error);
    CHECK_FALSE(d.get<"mind">().has_given_up);
  }

  TEST_CASE("in a fast run, where the others hang at the end") {
    cca::deployed<robot_first<3>> d;
    begin(d, 20);
    CHECK_EQ(d.run(cca::for_beats<21>{}), cca::state::started);
    CHECK_FALSE(d.get<"mind">().has_given_up);
    CHECK_EQ(d.beat_index(), 21);
  }

  TEST_CASE("a robot that follows a mind which hangs idles, and has lost contact") {
    cca::deployed<mind_first<50>> d;
    begin(d, 20);
    CHECK_EQ(d.run(cca::without_end{}, patient_clock()), cca::state::faulted);
    CHECK_EQ(std::string(d.fault().reason()), "lost contact with `mind`");
    CHECK_FALSE(d.get<"mind">().has_given_up);
    CHECK_EQ(d.get<"robot">().faults, 1);
    CHECK_EQ(d.get<"robot">().idled_in, d.get<"robot">().sensed_in);
    CHECK(d.fault_cause().find(" of 5 ms in beat 20: ") != std::string::npos);
    d.resume();
    CHECK_EQ(d.fault_cause(), "");
  }

  TEST_CASE("two robots in environments of their own, each in its thread") {
    cca::deployed<apart> d;
    begin(d, 20);
    CHECK_EQ(d.run(cca::without_end{}, patient_clock()), cca::state::faulted);
    CHECK_FALSE(d.get<"mind">().has_given_up);
    for (const watched* const robot : {&d.get<"arm">(), &d.get<"hand">()}) {
      CHECK_GE(robot->own_idles, 2);
      CHECK_EQ(robot->faults, 1);
      CHECK_EQ(robot->idled_in, robot->sensed_in);
    }
  }

  TEST_CASE("it goes on where the mind is late, but not longer than is tolerated") {
    cca::deployed<mind_first<for_ever>> d;
    begin(d, 20);
    CHECK_EQ(d.run(cca::for_beats<40>{}, cca::at_wall_clock()), cca::state::started);
    CHECK_FALSE(d.get<"mind">().has_given_up);
    CHECK_GE(d.get<"robot">().own_idles, enough);
    CHECK_EQ(d.get<"robot">().faults, 0);
    CHECK_EQ(d.beat_index(), 40);
  }

  TEST_CASE("a follower that sleeps is woken") {
    cca::deployed<sleeping> d;
    begin(d, -1);
    std::chrono::steady_clock::time_point ended{};
    d.run(cca::without_end{}, cca::at_speed(0.0005), [&](auto&) {  // beats of 2 s
      ended = std::chrono::steady_clock::now();
      return false;
    });
    CHECK_LT(std::chrono::steady_clock::now() - ended, 1s);
    CHECK_EQ(idles, 0);
  }

  TEST_CASE("figures after a fault count the periods of the clock, and no more") {
    cca::deployed<robot_first<50>> d;
    begin(d, 20);
    const auto since = std::chrono::steady_clock::now();
    d.run(cca::without_end{}, patient_clock());
    const auto periods = (std::chrono::steady_clock::now() - since) / 5ms;
    REQUIRE_EQ(d.state(), cca::state::faulted);
    for (const cca::environment_figures& e : d.figures()) {
      CHECK_LE(e.lost_periods + e.beat.count(), periods + 1);
      CHECK_LE(e.overruns, e.beat.count());
    }
  }
}
