// A switch between two modes: what comes begins anew and is started, what goes is stopped; in each state of
// the life-cycle, from outside and by a component.
#include <doctest/doctest.h>

#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

#include <cca/config.hpp>
#include <cca/modes.hpp>

#include "../../laws/temporary_file.hpp"
#include "../core/counting.hpp"

namespace laws {
std::size_t allocations();
}

using namespace core_test;

namespace {

struct hooks {
  int loads = 0, starts = 0, stops = 0, saves = 0;
  bool operator==(const hooks&) const = default;
};

template <class Function>
struct hooked : Function {
  void on_load() { ++count.loads; }
  void on_start() { ++count.starts; }
  void on_stop() { ++count.stops; }
  void on_save() { ++count.saves; }
  hooks count;
};

struct counting {
  auto process() -> cca::out<"y", reading> { return ++value; }
  double value = 0;
};
struct slow_to_begin {  // publishes from the third beat after it came
  auto process() -> cca::maybe<"y", reading> {
    if (++beats < 3) return {};
    return beats;
  }
  double beats = 0;
};
struct dt_log {
  void process(cca::in<"x", reading>, cca::beat now) { all.push_back(now.dt()); }
  std::vector<double> all;
};
struct tuned {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::bounded<double, 0.0, 10.0>, gain));
  };
  parameters p{1.0};
  auto process(cca::in<"x", reading> x) -> cca::out<"y", reading> { return p.gain * x[cca::x{}]; }
};
struct robot {
  auto sense() -> std::tuple<cca::out<"y", reading>, cca::fault> {
    return {double(beats++), broken ? cca::fault("broken") : cca::fault()};
  }
  void on_fault() { ++faults; }
  void on_idle() { ++idle; }
  double beats = 0;
  bool broken = false;
  int faults = 0, idle = 0;
};

struct first : cca::graph<cca::rate<1000>,
                          cca::node<"robot", hooked<robot>>,
                          cca::node<"stays", hooked<counting>>,
                          cca::node<"only_first", hooked<counting>>,
                          cca::node<"gain", tuned>,
                          cca::node<"log", journal, cca::timed<1>>,
                          cca::wire<"robot.y", "gain.x">,
                          cca::wire<"stays.y", "log.x">,
                          cca::observe<"gain.*">> {};
struct second : cca::graph<cca::rate<1000>,
                           cca::node<"robot", hooked<robot>>,
                           cca::node<"stays", hooked<counting>>,
                           cca::node<"comes", hooked<slow_to_begin>>,
                           cca::node<"offset", tuned>,
                           cca::node<"seen_log", journal, cca::timed<1>>,
                           cca::node<"queued", journal>,
                           cca::node<"late", journal, cca::timed<7>>,
                           cca::node<"dt", dt_log>,
                           cca::wire<"comes.y", "late.x", cca::queue<4, cca::drop_oldest>>,
                           cca::wire<"comes.y", "dt.x">,
                           cca::wire<"robot.y", "offset.x">,
                           cca::wire<"comes.y", "seen_log.x", cca::latest, cca::initial<-1>>,
                           cca::wire<"comes.y", "queued.x", cca::queue<4, cca::drop_oldest>>,
                           cca::observe<"comes.*">> {};
struct two : cca::modes<cca::mode<"first", first>, cca::mode<"second", second>> {};

// Each mode asks for the other one in every beat.
template <cca::fixed_string Other>
struct asks {
  auto process() -> std::tuple<cca::out<"y", reading>, cca::switch_to<Other>> {
    ++beats;
    return {beats, wants};
  }
  double beats = 0;
  bool wants = true;
};
struct trips {
  auto process(cca::in<"x", reading>) -> cca::fault { return tripped ? cca::fault("tripped") : cca::fault(); }
  bool tripped = false;
};
struct ping : cca::graph<cca::rate<1000>,
                         cca::node<"robot", robot>,
                         cca::node<"ping", asks<"pong">>,
                         cca::node<"sum", adder>,
                         cca::node<"trips", trips>,
                         cca::wire<"ping.y", "sum.x">,
                         cca::wire<"ping.y", "trips.x">> {};
struct pong : cca::graph<cca::rate<1000>,
                         cca::node<"robot", robot>,
                         cca::node<"pong", asks<"ping">>,
                         cca::node<"sum", adder>,
                         cca::node<"trips", trips>,
                         cca::wire<"pong.y", "sum.x">,
                         cca::wire<"pong.y", "trips.x">> {};
struct table : cca::modes<cca::mode<"ping", ping>, cca::mode<"pong", pong>> {};

struct alone {
  auto process() -> cca::switch_to<"second"> { return asked; }
  bool asked = false;
};
struct with_request : cca::graph<cca::rate<1000>, cca::node<"alone", alone>> {};

static_assert(std::is_trivially_copyable_v<cca::controller<table>>);

std::vector<std::string> observed_by(const cca::controller<two>& c) {
  std::vector<std::string> all;
  c.observed([&](const cca::observation& one) { all.emplace_back(one.path); });
  return all;
}

}  // namespace

TEST_SUITE("switching") {
  TEST_CASE("hooks: loading is for all modes, starting and stopping for the active one") {
    cca::controller<two> c;
    CHECK_EQ(c.mode(), "first");
    c.load();
    CHECK(c.get<"robot">().count == hooks{1, 0, 0, 0});
    CHECK(c.get<"only_first">().count == hooks{1, 0, 0, 0});
    CHECK(c.get<"comes">().count == hooks{1, 0, 0, 0});
    c.start();
    CHECK(c.get<"only_first">().count == hooks{1, 1, 0, 0});
    CHECK(c.get<"comes">().count == hooks{1, 0, 0, 0});
    c.run(cca::for_beats<5>{});
    c.switch_to<"second">();
    CHECK(c.get<"robot">().count == hooks{1, 1, 0, 0});
    CHECK(c.get<"stays">().count == hooks{1, 1, 0, 0});
    CHECK(c.get<"only_first">().count == hooks{1, 1, 1, 0});
    CHECK(c.get<"comes">().count == hooks{1, 1, 0, 0});
    c.switch_to<"second">();  // it is active already
    CHECK(c.get<"comes">().count == hooks{1, 1, 0, 0});
    c.run(cca::for_beats<5>{});
    CHECK_EQ(c.get<"stays">().value, 10);
    CHECK_EQ(c.get<"only_first">().value, 5);
    CHECK_EQ(c.beat_index(), 10);
    c.stop();
    CHECK(c.get<"robot">().count == hooks{1, 1, 1, 0});
    CHECK(c.get<"comes">().count == hooks{1, 1, 1, 0});
    CHECK(c.get<"only_first">().count == hooks{1, 1, 1, 0});
    CHECK_FALSE(c.step());
    CHECK_EQ(c.get<"robot">().idle, 1);
    c.start();  // in the mode in which it was stopped
    CHECK_EQ(c.mode(), "second");
    CHECK(c.get<"comes">().count == hooks{1, 2, 1, 0});
    CHECK(c.get<"only_first">().count == hooks{1, 1, 1, 0});
    c.stop();
    c.save();
    CHECK(c.get<"only_first">().count == hooks{1, 1, 1, 1});
    CHECK(c.get<"comes">().count == hooks{1, 2, 2, 1});
  }

  TEST_CASE("before start() a switch calls no hook") {
    cca::controller<two> c;
    c.switch_to<"second">();
    c.load();
    c.switch_to<"first">();
    c.switch_to<"second">();
    CHECK_EQ(c.state(), cca::state::loaded);
    c.start();
    CHECK(c.get<"comes">().count == hooks{1, 1, 0, 0});
    CHECK(c.get<"only_first">().count == hooks{1, 0, 0, 0});
  }

  TEST_CASE("what comes begins with its initial values, each time") {
    auto c = started<two>();
    c.run(cca::for_beats<5>{});
    for (int round = 0; round < 2; ++round) {
      c.get<"comes">().beats = 0;
      c.get<"seen_log">().all.clear();
      c.get<"queued">().all.clear();
      c.get<"late">().all.clear();
      c.get<"dt">().all.clear();
      c.switch_to<"second">();
      const auto begun = c.beat_index();
      c.run(cca::for_beats<4>{});
      const auto& all = c.get<"seen_log">().all;
      REQUIRE_EQ(all.size(), 4);
      CHECK(all[0] == seen{begun, -1, cca::never, false});
      CHECK(all[1] == seen{begun + 1, -1, cca::never, false});
      CHECK(all[2] == seen{begun + 2, 3, (begun + 2) * 1'000'000, true});
      CHECK(c.get<"queued">().all.size() == 2);
      CHECK(c.get<"dt">().all == std::vector<double>{1e-3, 1e-3});
      // One sample still waits in this queue when the mode ends; it is not there when it begins again.
      REQUIRE_EQ(c.get<"late">().all.size(), 1);
      CHECK(c.get<"late">().all[0] == seen{begun + 2, 3, (begun + 2) * 1'000'000, true});
      c.switch_to<"first">();
      c.run(cca::for_beats<3>{});
    }
  }

  TEST_CASE("observed() hears the active mode") {
    auto c = started<two>();
    c.step();
    CHECK(observed_by(c) == std::vector<std::string>{"gain.y"});
    c.switch_to("second");
    c.step();
    CHECK(observed_by(c) == std::vector<std::string>{"comes.y"});
  }

  TEST_CASE("a name that no mode has is refused, and nothing changes") {
    auto c = started<two>();
    CHECK_EQ(words_of([&] { c.switch_to("secnd"); }),
             "cca::controller: switch_to: two has no mode `secnd`; did you mean `second`?");
    CHECK_EQ(words_of([&] { c.switch_to("gallop"); }),
             "cca::controller: switch_to: two has no mode `gallop`; it has `first`, `second`");
    CHECK_EQ(c.mode(), "first");
    CHECK(c.get<"only_first">().count == hooks{1, 1, 0, 0});
  }

  TEST_CASE("a fault stays in its mode, and says the component's path") {
    auto c = started<two>();
    c.switch_to("second");
    c.get<"robot">().broken = true;
    CHECK(c.step());
    CHECK_EQ(c.state(), cca::state::faulted);
    CHECK_EQ(c.fault_path(), "robot");
    CHECK_EQ(c.get<"robot">().faults, 1);
    CHECK_EQ(words_of([&] { c.switch_to("first"); }),
             "cca::controller: switch_to() is refused in the state `faulted`: a component has faulted: look "
             "at fault(), "
             "then resume() or stop()");
    c.get<"robot">().broken = false;
    c.resume();
    CHECK_EQ(c.mode(), "second");
    CHECK(c.step());
    c.switch_to("first");
    CHECK(c.step());
    CHECK_EQ(c.get<"only_first">().value, 1);
  }

  TEST_CASE("a component asks for a mode: it begins with the next beat") {
    auto c = started<table>();
    for (int k = 0; k < 10; ++k) {
      CHECK_EQ(c.mode(), k % 2 == 0 ? "ping" : "pong");
      c.step();
    }
    CHECK_EQ(c.get<"ping">().beats, 5);
    CHECK_EQ(c.get<"pong">().beats, 5);
    CHECK_EQ(c.get<"sum">().sum, 2 * (1 + 2 + 3 + 4 + 5));
    c.get<"ping">().wants = false;
    c.run(cca::for_beats<5>{});
    CHECK_EQ(c.mode(), "ping");
    CHECK_EQ(c.get<"ping">().beats, 10);
    // In a beat with a fault nothing is switched, nor in the next.
    c.get<"ping">().wants = c.get<"trips">().tripped = true;
    c.step();
    CHECK_EQ(c.state(), cca::state::faulted);
    CHECK_EQ(c.fault_path(), "trips");
    c.get<"trips">().tripped = c.get<"ping">().wants = false;
    c.resume();
    c.step();
    CHECK_EQ(c.mode(), "ping");
  }

  TEST_CASE("in a controller of one graph a request has no effect") {
    auto c = started<with_request>();
    c.get<"alone">().asked = true;
    c.run(cca::for_beats<3>{});
    CHECK_EQ(c.beat_index(), 3);
    CHECK_EQ(c.state(), cca::state::started);
  }

  TEST_CASE("between two beats of a run") {
    auto c = started<two>();
    c.run(cca::for_beats<10>{}, cca::as_fast_as_possible{}, [](auto& running) {
      if (running.beat_index() == 4) running.template switch_to<"second">();
      return running.mode() == "first" || running.beat_index() < 8;
    });
    CHECK_EQ(c.beat_index(), 8);
    CHECK_EQ(c.get<"only_first">().value, 4);
    CHECK_EQ(c.get<"comes">().beats, 4);
  }

  TEST_CASE("a copy is a snapshot, its mode included") {
    auto c = started<two>();
    c.run(cca::for_beats<3>{});
    c.switch_to("second");
    c.step();
    auto copy = c;
    c.switch_to("first");
    c.run(cca::for_beats<3>{});
    CHECK_EQ(copy.mode(), "second");
    copy.step();
    CHECK_EQ(copy.get<"comes">().beats, 2);
    copy.switch_to("first");
    copy.run(cca::for_beats<2>{});
    CHECK_EQ(copy.get<"only_first">().value, 5);
    CHECK_EQ(c.get<"only_first">().value, 6);
  }

  TEST_CASE("parameters of all modes, active or not") {
    auto c = started<two>();
    CHECK(c.parameter_paths() == std::vector<std::string>{"gain.gain", "offset.gain"});
    c.set<"offset">({2.5});
    c.set("gain.gain", 4.0);
    CHECK_EQ(c.parameter<double>("offset.gain"), 2.5);
    CHECK_EQ(words_of([&] { c.set("offset.gain", 11.0); }),
             "cca::controller: set: offset.gain: 11 is out of range, expected 0 to 10");
    const laws::temporary_file file("modes.toml");
    c.save(file.path);
    cca::controller<two> other;
    other.load(file.path);
    CHECK_EQ(other.get<"gain">().p.gain, 4.0);
    CHECK_EQ(other.get<"offset">().p.gain, 2.5);
    std::vector<std::string> paths;
    c.for_each_component([&](std::string_view path, auto&) { paths.emplace_back(path); });
    CHECK(paths == std::vector<std::string>{"robot", "stays", "only_first", "gain", "log", "comes", "offset",
                                            "seen_log", "queued", "late", "dt"});
  }

  TEST_CASE("a switch allocates nothing") {
    auto c = started<table>();
    cca::controller<table> other = c;
    const auto before = laws::allocations();
    for (int k = 0; k < 1000; ++k) {
      c.step();
      other.switch_to<"pong">();
      other.step();
    }
    CHECK_EQ(laws::allocations(), before);
  }
}
