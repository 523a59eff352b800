// The watchdog faults when a command becomes stale, by the age of its data, even if nothing arrives any more.
#include <doctest/doctest.h>

#include "../picture.hpp"
#include "joints.hpp"

using namespace robot_test;

namespace {

struct leg_angles_at_10 : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<10>> {};
// Its encoders may fall silent.
struct leg_with_encoders {
  auto sense(cca::beat now) -> cca::maybe<"angles", leg_angles> {
    if (!reporting) return {};
    cca::maybe<"angles", leg_angles> y(at);
    if (ahead != 0) y.with_origin(now.time() + ahead);
    return y;
  }
  void act(cca::in<"command", leg_angles> to) {
    if (to.origin() != cca::never) at = to.vector();
  }
  void on_fault() { ++stops; }
  leg_angles::vector_type at{0.1, -0.9};
  bool reporting = true;
  std::int64_t ahead = 0;
  int stops = 0;
};

// [watchdog]
struct link {  // a remote command that may stop arriving
  bool up = true;
  auto process() -> cca::maybe<"angles", leg_angles> {
    if (!up) return {};
    return leg_angles::vector_type{0.1, -1};
  }
};

struct guarded
    : cca::graph<cca::node<"link", link>,
                 cca::node<"watchdog", cca::watchdog<leg_angles, 5>>,  // a command may be 5 beats old
                 cca::node<"limits", cca::limiter<leg_angles>>,
                 cca::node<"leg", perfect_leg>,
                 cca::wire<"link.angles", "watchdog.command">,
                 cca::wire<"watchdog.fresh", "limits.command">,
                 cca::wire<"limits.safe", "leg.command">> {};
// [watchdog end]

// [source]
struct planner {  // a new goal ten times a second
  auto process() -> cca::out<"goal", leg_angles_at_10> { return leg_angles::vector_type{0.3, -1}; }
};
struct follower {  // a command in each beat, from the goal and the measured angles
  auto process(cca::in<"goal", leg_angles_at_10> goal, cca::in<"angles", leg_angles> angles)
      -> cca::maybe<"command", leg_angles> {
    if (gone) return {};
    return (angles.vector() + 0.01 * (goal.vector() - angles.vector())).eval();
  }
  bool gone = false;
};

template <class Watchdog>
struct planned : cca::graph<cca::rate<1000>,
                            cca::node<"planner", planner, cca::timed<100>>,
                            cca::node<"follower", follower, cca::timed<1>>,
                            cca::node<"watchdog", Watchdog>,
                            cca::node<"limits", cca::limiter<leg_angles>>,
                            cca::node<"robot", leg_with_encoders>,
                            cca::wire<"planner.goal", "follower.goal", cca::latest>,
                            cca::wire<"robot.angles", "follower.angles", cca::latest>,
                            cca::wire<"follower.command", "watchdog.command">,
                            cca::wire<"watchdog.fresh", "limits.command">,
                            cca::wire<"limits.safe", "robot.command">> {};

// The encoders must have reported within 5 beats, and a command must have come; the goal may be of any age.
using of_encoders = cca::watchdog<leg_angles, 5, cca::of<"robot.angles">>;
// The same, with a command at least every 20 beats.
using of_encoders_slowly = cca::watchdog<leg_angles, 5, cca::of<"robot.angles">, 20>;
// [source end]

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["link<br/><i>1000 Hz</i>"]
  n2["limits<br/><i>restless</i>"]
  n3[("leg<br/><i>1000 Hz</i>")]
  subgraph g1["watchdog"]
    n1["watch<br/><i>1000 Hz</i>"]
  end
  n0 -- "angles → command<br/>leg_angles" --> n1
  n1 -- "fresh → command<br/>leg_angles" --> n2
  n2 -- "safe → command<br/>leg_angles" --> n3
)";  // [picture end]

// Commands come slowly, from data 2 beats old, and pass a limiter first.
struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};  // without a rate
struct claiming {
  auto process(cca::beat now) -> cca::out<"angles", slow_angles> {
    cca::out<"angles", slow_angles> y(slow_angles::vector_type{0.1, -1});
    y.with_origin(now.time() + offset * millisecond);
    return y;
  }
  std::int64_t offset = -2;
};
struct noting {
  void act(cca::in<"command", slow_angles> to) { origin = to.origin(); }
  std::int64_t origin = cca::never;
};
template <std::int64_t Beats>
struct slow : cca::graph<cca::rate<1000>,
                         cca::node<"far", claiming, cca::full_speed>,
                         cca::node<"hold", cca::limiter<slow_angles>, cca::timed<10>>,
                         cca::node<"watchdog", cca::watchdog<slow_angles, Beats>>,
                         cca::node<"leg", noting>,
                         cca::wire<"far.angles", "hold.command", cca::latest>,
                         cca::wire<"hold.safe", "watchdog.command", cca::latest>,
                         cca::wire<"watchdog.fresh", "leg.command">> {};

struct echo {
  auto process(cca::in<"x", slow_angles> x) -> cca::out<"y", slow_angles> { return x; }
};
struct echoing {
  auto sense() -> cca::out<"angles", slow_angles> { return slow_angles::vector_type{0, -1}; }
  void act(cca::in<"command", slow_angles> to) { origin = to.origin(); }
  std::int64_t origin = cca::never;
};
struct loop : cca::graph<cca::rate<1000>,
                         cca::node<"gait", echo>,
                         cca::node<"limits", cca::limiter<slow_angles>>,
                         cca::node<"watchdog", cca::watchdog<slow_angles, 5>>,
                         cca::node<"leg", echoing>,
                         cca::wire<"leg.angles", "gait.x">,
                         cca::wire<"gait.y", "limits.command">,
                         cca::wire<"limits.safe", "watchdog.command", cca::delayed<3>>,
                         cca::wire<"watchdog.fresh", "leg.command">> {};

// The robot is a graph that exposes the angles; the watchdog is in another one.
struct body : cca::graph<cca::node<"leg", leg_with_encoders>,
                         cca::expose<"leg.angles", "angles">,
                         cca::expose<"leg.command", "command">> {};
struct guard : cca::graph<cca::node<"watchdog", cca::watchdog<leg_angles, 5, cca::of<"robot.angles">>>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::wire<"watchdog.fresh", "limits.command">,
                          cca::expose<"watchdog.command", "command">,
                          cca::expose<"limits.safe", "safe">> {};
struct inside : cca::graph<cca::node<"robot", body>,
                           cca::node<"guard", guard>,
                           cca::wire<"guard.safe", "robot.command">,
                           cca::expose<"guard.command", "command">,
                           cca::expose<"robot.angles", "angles">> {};
struct nested : cca::graph<cca::rate<1000>,
                           cca::node<"planner", planner, cca::timed<100>>,
                           cca::node<"follower", follower, cca::timed<1>>,
                           cca::node<"body", inside>,
                           cca::wire<"planner.goal", "follower.goal", cca::latest>,
                           cca::wire<"body.angles", "follower.angles", cca::latest>,
                           cca::wire<"follower.command", "body.command">> {};

template <class Controller>
std::int64_t steps_until_fault(Controller& c, int most) {
  for (int i = 0; i < most; ++i) {
    c.step();
    if (c.state() == cca::state::faulted) return i;
  }
  return -1;
}

template <class Graph>
cca::controller<Graph> started() {
  cca::controller<Graph> c;
  c.load();
  c.start();
  return c;
}

}  // namespace

TEST_SUITE("watchdog") {
  TEST_CASE("it faults in the first beat in which the command is too old") {
    auto c = started<guarded>();
    CHECK_EQ(c.run(cca::for_beats<100>{}), cca::state::started);
    CHECK_EQ(c.get<"leg">().at[0], 0.1);
    c.get<"link">().up = false;  // the last command is from beat 99
    CHECK_EQ(c.run(cca::for_beats<5>{}), cca::state::started);
    CHECK_EQ(c.get<"leg">().stops, 0);
    CHECK_EQ(c.run(cca::for_beats<5>{}), cca::state::faulted);
    CHECK_EQ(c.beat_index(), 106);
    CHECK_EQ(std::string(c.fault().reason()), "stale command");
    CHECK_EQ(c.fault_path(), "watchdog.watch");
    CHECK_EQ(c.get<"leg">().stops, 1);

    // It faults again while nothing arrives, and continues once something does.
    c.resume();
    CHECK_EQ(c.run(cca::for_beats<5>{}), cca::state::faulted);
    CHECK_EQ(c.beat_index(), 107);
    c.get<"link">().up = true;
    c.resume();
    CHECK_EQ(c.run(cca::for_beats<5>{}), cca::state::started);
  }

  TEST_CASE("its picture is the one on its page") { test::check_picture<guarded>(picture); }

  TEST_CASE("no command at all: the age counts from the first beat, and nothing is passed on") {
    auto c = started<guarded>();
    c.get<"link">().up = false;
    CHECK_EQ(steps_until_fault(c, 50), 6);
    CHECK_EQ(c.get<"leg">().at, Eigen::Vector2d(0.1, -0.9));
    c.stop();
    c.start();
    CHECK_EQ(steps_until_fault(c, 50), 6);  // after a start it waits again
  }

  TEST_CASE("the origin is passed on even if the wire closes a loop") {
    auto c = started<loop>();
    c.run(cca::for_beats<10>{});
    CHECK_EQ(c.get<"leg">().origin, (9 - 3) * millisecond);
  }

  TEST_CASE("the age is that of the data, and the origin is passed on") {
    // Fires in beats 0, 10, ... with data 2 beats old: the age in beat 9 is 11.
    auto c = started<slow<11>>();
    CHECK_EQ(steps_until_fault(c, 100), -1);
    CHECK_EQ(c.get<"leg">().origin, (90 - 2) * millisecond);
    auto stale = started<slow<10>>();
    CHECK_EQ(steps_until_fault(stale, 100), 9);
  }

  TEST_CASE("where nothing has ever come the cause says so") {
    auto c = started<guarded>();
    c.get<"link">().up = false;
    CHECK_EQ(steps_until_fault(c, 50), 6);
    CHECK_EQ(c.get<"watchdog.watch">().cause().what,
             "no command has come for 0.006 s, 0.005 s are allowed: see what its writers wait for, or raise "
             "`Beats`");
    auto followed = started<planned<of_encoders_slowly>>();
    followed.get<"follower">().gone = true;
    CHECK(steps_until_fault(followed, 50) > 0);
    CHECK_EQ(followed.get<"watchdog.watch">().cause().what,
             "no command has come for 0.021 s, 0.02 s are allowed: see what its writer waits for, or raise "
             "`Arrival`");
    auto deaf = started<planned<of_encoders>>();
    deaf.get<"robot">().reporting = false;
    CHECK(steps_until_fault(deaf, 50) > 0);
    CHECK(deaf.get<"watchdog.watch">().cause().what.starts_with("no sample of `robot.angles` has come for "));
  }

  TEST_CASE("without a source a slow goal makes the command old") {
    auto c = started<planned<cca::watchdog<leg_angles, 5>>>();
    CHECK_EQ(steps_until_fault(c, 200), 6);
    CHECK_EQ(std::string(c.fault().reason()), "stale command");
  }

  TEST_CASE("with a source only its age counts: a slow goal is fine, a dead encoder is not") {
    auto c = started<planned<of_encoders>>();
    CHECK_EQ(steps_until_fault(c, 1000), -1);
    CHECK_EQ(c.get<"robot">().at[0], doctest::Approx(0.3).epsilon(0.01));
    c.get<"robot">().reporting = false;  // the last sample is from beat 999
    CHECK_EQ(steps_until_fault(c, 50), 5);
    CHECK_EQ(std::string(c.fault().reason()), "stale source");
    const cca::cause cause = c.get<"watchdog.watch">().cause();
    CHECK(cause.what.starts_with("the newest sample of `"));
    CHECK(cause.what.find("see why it is no longer published, or raise `Beats`") != std::string::npos);
    CHECK_EQ(c.fault_path(), "watchdog.watch");
    CHECK_EQ(c.get<"robot">().stops, 1);
    c.get<"robot">().reporting = true;
    c.resume();
    CHECK_EQ(steps_until_fault(c, 100), -1);
  }

  TEST_CASE("with a source a command must still arrive: within the beats of the source, or its own number") {
    auto c = started<planned<of_encoders>>();
    CHECK_EQ(steps_until_fault(c, 1000), -1);
    c.get<"follower">().gone = true;  // the last command is from beat 999
    CHECK_EQ(steps_until_fault(c, 50), 5);
    CHECK_EQ(std::string(c.fault().reason()), "stale command");
    CHECK_EQ(c.get<"robot">().stops, 1);
    c.get<"follower">().gone = false;
    c.resume();
    CHECK_EQ(steps_until_fault(c, 100), -1);

    auto slowly = started<planned<of_encoders_slowly>>();
    CHECK_EQ(steps_until_fault(slowly, 1000), -1);
    slowly.get<"follower">().gone = true;
    CHECK_EQ(steps_until_fault(slowly, 50), 20);
    CHECK_EQ(std::string(slowly.fault().reason()), "stale command");

    auto silent = started<planned<of_encoders>>();  // no command at all
    silent.get<"follower">().gone = true;
    CHECK_EQ(steps_until_fault(silent, 50), 6);
    CHECK_EQ(std::string(silent.fault().reason()), "stale command");
  }

  TEST_CASE("a source that never reports is stale, and one from the future by its time of arrival") {
    auto c = started<planned<of_encoders>>();
    c.get<"robot">().reporting = false;
    CHECK_EQ(steps_until_fault(c, 100), 6);
    auto ahead = started<planned<of_encoders>>();
    ahead.get<"robot">().ahead = 1'000'000'000;
    CHECK_EQ(steps_until_fault(ahead, 100), -1);
    ahead.get<"robot">().reporting = false;
    CHECK_EQ(steps_until_fault(ahead, 100), 5);
  }

  TEST_CASE("a source may be an output that an inner graph exposes, or of the inner graph itself") {
    auto c = started<nested>();
    CHECK_EQ(steps_until_fault(c, 1000), -1);
    c.get<"body.robot.leg">().reporting = false;
    CHECK_EQ(steps_until_fault(c, 50), 5);
  }

  TEST_CASE("a command from the future becomes stale by its time of arrival") {
    auto c = started<slow<9>>();
    c.get<"far">().offset = 1'000'000'000;
    CHECK_EQ(steps_until_fault(c, 100), -1);
    auto stale = started<slow<8>>();
    stale.get<"far">().offset = 1'000'000'000;
    CHECK_EQ(steps_until_fault(stale, 100), 9);
  }
}
