// Components that are stopped on their own, and a switch: what stays keeps being stopped, what comes is
// started. Parameters from a file while it is started.
#include <doctest/doctest.h>

#include <string>
#include <tuple>

#include <cca/config.hpp>
#include <cca/modes.hpp>

#include "../../laws/temporary_file.hpp"
#include "../core/counting.hpp"

using namespace core_test;

namespace {

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
struct tuned {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::bounded<double, 0.0, 10.0>, gain));
  };
  parameters p{1.0};
  auto process() -> cca::out<"y", reading> { return double(p.gain); }
};

using at_ten = cca::stoppable<cca::timed<10>>;

// `both` is in both modes at two clocks, `first_only` in one; `pace` can be stopped in one mode only.
struct watch : cca::graph<cca::rate<1000>,
                          cca::node<"both", camera, at_ten>,
                          cca::node<"first_only", camera, at_ten>,
                          cca::node<"pace", counter, cca::stoppable<cca::timed<1>>>,
                          cca::node<"gain", tuned>,
                          cca::node<"viewer", viewer, cca::timed<1>>,
                          cca::wire<"both.y", "viewer.x", cca::latest>> {};
struct rest : cca::graph<cca::rate<1000>,
                         cca::node<"both", camera, cca::stoppable<cca::timed<5>>>,
                         cca::node<"pace", counter>,
                         cca::node<"gain", tuned>,
                         cca::node<"later", tuned>,
                         cca::node<"viewer", viewer, cca::timed<1>>,
                         cca::wire<"both.y", "viewer.x", cca::latest>> {};
struct day : cca::modes<cca::mode<"watch", watch>, cca::mode<"rest", rest>> {};

}  // namespace

TEST_SUITE("stopped in a mode") {
  TEST_CASE("what both modes have stays stopped") {
    auto c = started<day>();
    const auto& both = c.get<"both">();
    c.run(cca::for_beats<11>{});  // 0, 10
    CHECK_EQ(both.pictures, 2);
    c.stop<"both">();
    c.stop("both");  // it is already
    CHECK(c.is_stopped<"both">());
    c.run(cca::for_beats<9>{});
    c.switch_to<"rest">();
    CHECK(c.is_stopped("both"));
    c.run(cca::for_beats<20>{});
    CHECK_EQ(both.pictures, 2);
    CHECK_EQ(both.starts, 1);
    CHECK_EQ(both.stops, 1);
    CHECK_EQ(c.get<"viewer">().age, 29'000'000);  // made in beat 10, seen in beat 39: the mode is no news
    c.start<"both">();
    c.run(cca::for_beats<6>{});  // 40, 45
    CHECK_EQ(both.pictures, 4);
    CHECK_EQ(both.starts, 2);
    CHECK_EQ(both.dt, 0.005);
    c.stop("both");
    c.switch_to("watch");
    c.run(cca::for_beats<14>{});
    CHECK_EQ(both.pictures, 4);
    c.start("both");
    c.run(cca::for_beats<1>{});  // 60
    CHECK_EQ(both.pictures, 5);
    CHECK_EQ(both.dt, 0.010);  // not the time of its rest
  }

  TEST_CASE("what comes is started, however it went") {
    auto c = started<day>();
    const auto& one = c.get<"first_only">();
    c.run(cca::for_beats<1>{});
    c.stop<"first_only">();
    c.switch_to<"rest">();
    CHECK_EQ(one.stops, 1);  // when it was stopped; not once more when its mode ended
    CHECK_FALSE(c.is_stopped<"first_only">());
    c.run(cca::for_beats<20>{});
    CHECK_EQ(one.pictures, 1);
    c.switch_to<"watch">();
    CHECK_EQ(one.starts, 2);
    CHECK_FALSE(c.is_stopped<"first_only">());
    c.run(cca::for_beats<10>{});  // 30
    CHECK_EQ(one.pictures, 2);
    CHECK_EQ(one.dt, 0.010);
    c.switch_to<"rest">();
    CHECK_EQ(one.stops, 2);
  }

  TEST_CASE("a component stops itself in one mode, and start() of all starts it") {
    auto c = started<day>();
    c.get<"both">().enough = c.get<"first_only">().enough = 2;
    c.run(cca::for_beats<40>{});
    CHECK(c.is_stopped<"both">());
    CHECK(c.is_stopped<"first_only">());
    c.switch_to<"rest">();
    c.run(cca::for_beats<40>{});
    CHECK_EQ(c.get<"both">().pictures, 2);
    CHECK_EQ(c.get<"both">().stops, 0);  // they know
    CHECK_EQ(c.get<"first_only">().stops, 0);
    c.stop();
    CHECK_EQ(c.get<"both">().stops, 0);
    c.start();
    CHECK_FALSE(c.is_stopped<"both">());
    c.run(cca::for_beats<10>{});
    CHECK_EQ(c.get<"both">().pictures, 4);
    CHECK_EQ(c.get<"first_only">().starts, 1);  // it is of the other mode
  }

  TEST_CASE("a copy keeps who is stopped") {
    auto c = started<day>();
    c.stop<"both">();
    auto copy = c;
    c.start<"both">();
    copy.switch_to<"rest">();
    CHECK(copy.is_stopped<"both">());
    copy.run(cca::for_beats<30>{});
    CHECK_EQ(copy.get<"both">().pictures, 0);
    CHECK_FALSE(c.is_stopped<"both">());
  }

  TEST_CASE("what is refused") {
    cca::controller<day> c;
    CHECK_EQ(words_of([&] { c.stop<"both">(); }),
             "cca::controller: stop(`both`) is refused in the state `created`: start() the controller first");
    c.load();
    c.start();
    CHECK_EQ(words_of([&] { c.stop("bot"); }),
             "cca::controller: `bot` is no component; did you mean `both`?");
    // Each mode that has it must say so.
    CHECK_EQ(words_of([&] { c.stop("pace"); }),
             "cca::controller: `pace` can't be stopped on its own: write cca::stoppable<...> around the "
             "strategy of its node");
    c.switch_to<"rest">();
    CHECK_EQ(words_of([&] { c.stop<"first_only">(); }),
             "cca::controller: stop(`first_only`) is refused in the mode `rest`, which has no such "
             "component: it is started when a mode begins that has it");
    CHECK_EQ(words_of([&] { c.start("first_only"); }),
             "cca::controller: start(`first_only`) is refused in the mode `rest`, which has no such "
             "component: it is started when a mode begins that has it");
    CHECK_EQ(c.get<"first_only">().stops, 1);
    CHECK_EQ(c.get<"first_only">().starts, 1);
  }

  TEST_CASE("load(file) while it is started: the parameters of all modes, and nothing else happens") {
    const laws::temporary_file file("modes.toml");
    {
      cca::controller<day> other;
      other.set<"gain">({2.5});
      other.set<"later">({7.5});
      other.load();
      other.save(file.path);
    }
    auto c = started<day>();
    c.run(cca::for_beats<3>{});
    c.stop<"both">();
    c.load(file.path);
    CHECK_EQ(c.state(), cca::state::started);
    CHECK_EQ(c.mode(), "watch");
    CHECK_EQ(c.beat_index(), 3);
    CHECK(c.is_stopped<"both">());
    CHECK_EQ(c.get<"both">().starts, 1);
    CHECK_EQ(c.get<"gain">().p.gain, 2.5);
    CHECK_EQ(c.get<"later">().p.gain, 7.5);
    c.switch_to<"rest">();
    CHECK_EQ(c.get<"later">().p.gain, 7.5);
    CHECK_EQ(words_of([&] { c.load("no_such_file.toml"); }).substr(0, 12), "no_such_file");
    CHECK_EQ(c.state(), cca::state::started);
  }
}
