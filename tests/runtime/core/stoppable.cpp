// Components that are stopped and started on their own: from outside, by themselves, in a controller and in
// environments.
#include <doctest/doctest.h>

#include <string>
#include <tuple>

#include <cca/deployment.hpp>
#include <cca/motor.hpp>
#include <cca/robot.hpp>

#include "../running.hpp"
#include "counting.hpp"

using namespace core_test;

namespace {

// [stoppable]
struct camera {
  auto process(cca::beat now) -> std::tuple<cca::out<"y", reading>, cca::done> {
    dt = now.dt();
    ++pictures;
    return {pictures, pictures == enough};  // then it stops itself
  }
  void on_start() { ++starts; }
  void on_stop() { ++stops; }

  int enough = -1;
  double pictures = 0, dt = 0;
  int starts = 0, stops = 0;
};
struct viewer {
  void process(cca::in<"x", reading> x, cca::beat now) {
    if (x.origin() != cca::never) age = now.time() - x.origin();
    news += x.fresh();
  }
  std::int64_t age = 0;
  int news = 0;
};
struct looking : cca::graph<cca::rate<1000>,
                            cca::node<"camera", camera, cca::stoppable<cca::timed<10>>>,
                            cca::node<"viewer", viewer, cca::timed<1>>,
                            cca::wire<"camera.y", "viewer.x", cca::delayed<1>>> {};
// [stoppable end]

struct split : cca::deployment<looking,
                               cca::environment<"front", cca::nodes<"viewer">>,
                               cca::environment<"back", cca::other_nodes>> {};

using test::refusal;
using test::running;

}  // namespace

TEST_SUITE("stoppable") {
  TEST_CASE_TEMPLATE("a stopped component does not fire and its last sample ages", Played,
                     cca::controller<looking>, cca::deployed<split>) {
    auto c = running<Played>();
    const auto& seen = c.template get<"camera">();
    const auto& viewed = c.template get<"viewer">();
    c.run(cca::for_beats<25>{});
    CHECK_EQ(seen.pictures, 3);
    CHECK_EQ(seen.dt, 0.010);  // as of timed<10>, the first time too
    CHECK_FALSE(c.template is_stopped<"camera">());

    c.template stop<"camera">();
    c.stop("camera");  // it is already
    c.run(cca::for_beats<25>{});
    CHECK_EQ(seen.pictures, 3);
    CHECK_EQ(seen.stops, 1);
    CHECK_EQ(viewed.age, 29'000'000);  // made in beat 20, seen in beat 49
    CHECK_EQ(viewed.news, 3);
    CHECK(c.is_stopped("camera"));

    c.start("camera");
    c.template start<"camera">();
    c.run(cca::for_beats<20>{});
    CHECK_EQ(seen.pictures, 5);  // in beats 50 and 60
    CHECK_EQ(seen.dt, 0.010);    // not the time of its rest
    CHECK_EQ(seen.starts, 2);
  }

  TEST_CASE_TEMPLATE("a component stops itself, and start() of all starts it", Played,
                     cca::controller<looking>, cca::deployed<split>) {
    auto c = running<Played>();
    c.template get<"camera">().enough = 4;
    c.run(cca::for_beats<200>{});
    CHECK_EQ(c.template get<"camera">().pictures, 4);
    CHECK_EQ(c.template get<"camera">().stops, 0);  // it knows
    CHECK_EQ(c.template get<"viewer">().news, 4);   // the last one was published
    CHECK(c.template is_stopped<"camera">());
    c.stop();
    CHECK_EQ(c.template get<"camera">().stops, 0);
    c.start();
    CHECK_FALSE(c.template is_stopped<"camera">());
    c.run(cca::for_beats<20>{});
    CHECK_EQ(c.template get<"camera">().pictures, 6);
  }

  TEST_CASE("what arrived while it was stopped is not fresh") {
    struct waiting : cca::graph<cca::rate<1000>, cca::node<"counter", counter, cca::timed<5>>,
                                cca::node<"reader", viewer, cca::stoppable<cca::restless>>,
                                cca::wire<"counter.y", "reader.x">> {};
    auto c = running<cca::controller<waiting>>();
    c.stop<"reader">();
    c.run(cca::for_beats<8>{});  // samples in beats 0 and 5
    c.start<"reader">();
    c.run(cca::for_beats<2>{});
    CHECK_EQ(c.get<"reader">().news, 0);
    c.run(cca::for_beats<1>{});  // one in beat 10
    CHECK_EQ(c.get<"reader">().news, 1);
  }

  TEST_CASE("a watchdog notices that a component is stopped") {
    struct watched : cca::graph<cca::rate<1000>, cca::node<"camera", camera, cca::stoppable<cca::timed<1>>>,
                                cca::node<"watchdog", cca::watchdog<reading, 20>>,
                                cca::wire<"camera.y", "watchdog.command">> {};
    auto c = running<cca::controller<watched>>();
    c.run(cca::for_beats<50>{});
    CHECK(!c.fault());
    c.stop<"camera">();
    c.run(cca::for_beats<50>{});
    CHECK_EQ(c.state(), cca::state::faulted);
    CHECK_EQ(c.fault_path(), "watchdog.watch");
    c.start<"camera">();
    c.resume();
    c.run(cca::for_beats<50>{});
    CHECK(!c.fault());
  }

  TEST_CASE("a copy of a controller keeps who is stopped") {
    auto c = running<cca::controller<looking>>();
    c.stop<"camera">();
    auto copy = c;
    c.start<"camera">();
    CHECK(copy.is_stopped<"camera">());
    copy.run(cca::for_beats<30>{});
    CHECK_EQ(copy.get<"camera">().pictures, 0);
  }

  TEST_CASE("what is refused") {
    cca::controller<looking> c;
    CHECK_EQ(
        refusal([&] { c.stop<"camera">(); }),
        "cca::controller: stop(`camera`) is refused in the state `created`: start() the controller first");
    c.load();
    CHECK_EQ(
        refusal([&] { c.start("camera"); }),
        "cca::controller: start(`camera`) is refused in the state `loaded`: start() the controller first");
    c.start();
    CHECK_EQ(refusal([&] { c.stop("camra"); }),
             "cca::controller: `camra` is no component; did you mean `camera`?");
    CHECK_EQ(refusal([&] { c.stop("viewer"); }),
             "cca::controller: `viewer` can't be stopped on its own: write cca::stoppable<...> around the "
             "strategy of its node");
    CHECK_FALSE(c.is_stopped("camera"));
  }
}
