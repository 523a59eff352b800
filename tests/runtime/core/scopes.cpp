// What patterns name, and what is heard: look-up in the graph of the observer and in those around it, outputs
// and inputs, spaces, policies.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "counting.hpp"

using namespace core_test;

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct same_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct other_angles : cca::space<cca::joint_angles, cca::axes<knee, hip>> {};

struct joints {
  auto process(cca::beat now) -> cca::out<"angles", leg_angles> {
    const auto k = static_cast<double>(now.index());
    return Eigen::Vector2d(0.125 * k, -0.25 * k);
  }
};
struct plus {
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", leg_angles> {
    return Eigen::Vector2d(x.vector().array() + 1);
  }
};

struct heard {
  double value;
  std::int64_t origin;
  bool fresh;
  friend bool operator==(const heard&, const heard&) = default;
};
// The paths in the order in which they are heard, and what was heard of each in each firing.
template <class Observe>
struct ear {
  void process(Observe all, cca::beat) {
    paths.clear();
    for (const cca::observation& one : all) {
      paths.emplace_back(one.path);
      told[std::string(one.path)].push_back({one.values[0], one.origin, one.fresh});
    }
  }
  std::vector<std::string> paths;
  std::map<std::string, std::vector<heard>> told;
};
using names = std::vector<std::string>;

// mind.log stands beside mind.arm.s; arm.s and legs.l stand around it.
struct arm : cca::graph<cca::node<"s", joints>,
                        cca::node<"t", plus>,
                        cca::wire<"s.angles", "t.x">,
                        cca::expose<"t.y", "command">> {};
template <cca::fixed_string Pattern, class... Policies>
struct mind : cca::graph<cca::node<"arm", arm>, cca::node<"log", ear<cca::observe<Pattern, Policies...>>>> {};
template <cca::fixed_string Pattern, class... Policies>
struct around : cca::graph<cca::rate<1000>,
                           cca::node<"mind", mind<Pattern, Policies...>>,
                           cca::node<"arm", arm>,
                           cca::node<"leg", arm>> {};

template <cca::fixed_string Pattern, class... Policies>
names heard_by() {
  auto c = started<around<Pattern, Policies...>>();
  c.step();
  return c.template get<"mind.log">().paths;
}

}  // namespace

TEST_SUITE("scopes") {
  TEST_CASE(
      "a pattern is looked up where it stands, then in the graphs around - the first that matches counts") {
    CHECK_EQ(heard_by<"arm.s.angles">(), names{"mind.arm.s.angles"});
    CHECK_EQ(heard_by<"leg.s.angles">(), names{"leg.s.angles"});
    CHECK_EQ(heard_by<"mind.arm.s.*">(), names{"mind.arm.s.angles"});
    CHECK_EQ(heard_by<"*.s.*">(), names{"mind.arm.s.angles"});
    CHECK_EQ(heard_by<"leg.*.y">(), names{"leg.t.y"});
  }

  TEST_CASE("with a / in front it is looked up in the outermost graph") {
    CHECK_EQ(heard_by<"/arm.s.angles">(), names{"arm.s.angles"});
    CHECK_EQ(heard_by<"/*.s.*">(), names{"arm.s.angles", "leg.s.angles"});
    CHECK_EQ(heard_by<"/**.arm.**.y">(), names{"mind.arm.t.y", "arm.t.y"});
  }

  TEST_CASE("* is one name, ** any number of them - ** at the end also names wired inputs") {
    CHECK_EQ(heard_by<"leg.**">(), names{"leg.s.angles", "leg.t.y", "leg.t.x"});
    CHECK_EQ(heard_by<"leg.**.*">(), names{"leg.s.angles", "leg.t.y"});
    CHECK_EQ(heard_by<"leg.*.*">(), names{"leg.s.angles", "leg.t.y"});
    CHECK_EQ(heard_by<"leg.t.**">(), names{"leg.t.y", "leg.t.x"});
    CHECK_EQ(heard_by<"**.t.**">(), names{"mind.arm.t.y", "mind.arm.t.x"});
    CHECK_EQ(heard_by<"/**.t.y">(), names{"mind.arm.t.y", "arm.t.y", "leg.t.y"});
  }

  TEST_CASE(
      "what a graph exposes has two names, and is heard once, under its own if the pattern names that") {
    CHECK_EQ(heard_by<"leg.command">(), names{"leg.command"});
    CHECK_EQ(heard_by<"leg.*">(), names{"leg.command"});
    CHECK_EQ(heard_by<"/*.*">(), names{"arm.command", "leg.command"});
    CHECK_EQ(heard_by<"/leg.**">().size(), 3);
  }

  TEST_CASE("several patterns are looked up together") {
    CHECK_EQ(heard_by<"leg.s.*|arm.t.y">(), names{"mind.arm.t.y"});
    CHECK_EQ(heard_by<"leg.s.*|/arm.t.y">(), names{"arm.t.y", "leg.s.angles"});
  }
}

namespace {

struct by_space {
  void process(cca::observe<"arm.**"> all, cca::beat) {
    for (const auto& one : all) {
      if (one.path != "arm.t.x") continue;
      axes.assign(one.axes().begin(), one.axes().end());
      unit = one.unit();
      const auto* q = one.as<leg_angles>();
      const auto* same = one.as<same_angles>();
      is_known = q && same && !one.as<other_angles>() && !one.as<reading>();
      if (!is_known) continue;
      hip_of_it = (*same)[hip{}];
      difference = same->difference(*same).norm();
      knee_of_it = same->template on<knee>().vector()[0];
      origin = same->origin();
    }
    found = all.find("arm.t.y") != nullptr && all.find("arm.t.y")->path == "arm.t.y" && !all.find("arm.t.z");
  }
  std::vector<std::string> axes;
  std::string unit;
  bool is_known = false, found = false;
  double hip_of_it = 0, knee_of_it = 0, difference = 1;
  std::int64_t origin = 0;
};
struct spaces : cca::graph<cca::rate<1000>, cca::node<"arm", arm>, cca::node<"log", by_space>> {};

}  // namespace

TEST_SUITE("scopes") {
  TEST_CASE("an observation knows its axes and its unit, and is a sample of its space, whatever its name") {
    auto c = started<spaces>();
    c.run(cca::for_beats<3>{});
    const auto& log = c.get<"log">();
    CHECK_EQ(log.axes, names{"hip", "knee"});
    CHECK_EQ(log.unit, "rad");
    CHECK(log.is_known);
    CHECK(log.found);
    CHECK_EQ(log.hip_of_it, 0.25);
    CHECK_EQ(log.knee_of_it, -0.5);
    CHECK_EQ(log.difference, 0);
    CHECK_EQ(log.origin, 2'000'000);
  }
}

namespace {

constexpr std::int64_t ms = 1'000'000, never = cca::never;

// Inputs of all kinds: a delay with an initial value, a queue that fills, one that is not wired.
struct reads_all {
  auto process(cca::in<"late", leg_angles>,
               cca::in<"queued", leg_angles>,
               cca::optional_in<"open", leg_angles>) -> cca::out<"y", reading> {
    return 0;
  }
};
template <class Observe, class Strategy = cca::timed<1>>
struct kinds : cca::graph<cca::rate<1000>,
                          cca::node<"s", joints>,
                          cca::node<"r", reads_all, cca::timed<2>>,
                          cca::node<"log", ear<Observe>, Strategy>,
                          cca::wire<"s.angles", "r.late", cca::delayed<2>, cca::initial<0.5>>,
                          cca::wire<"s.angles", "r.queued", cca::queue<4, cca::drop_newest>>> {};
template <class Observe, class Strategy = cca::timed<1>>
auto after(int beats) {
  auto c = started<kinds<Observe, Strategy>>();
  for (int k = 0; k < beats; ++k) c.step();
  return c.template get<"log">();
}
using all_heard = std::vector<heard>;

struct once_in_three {
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs&) {
    return now.index() % 3 == 2;
  }
};

}  // namespace

TEST_SUITE("scopes") {
  TEST_CASE("an observed input shows what it shows: late, first its initial value, the oldest that waits") {
    const auto log = after<cca::observe<"r.**">>(4);
    CHECK_EQ(log.paths, names{"r.y", "r.late", "r.queued"});
    CHECK(log.told.at("r.late") ==
          all_heard{{0.5, never, false}, {0.5, never, false}, {0, 0, true}, {0.125, ms, true}});
    // In beats 0 and 2 the component comes before the observer and takes one: what it took last, or the next.
    CHECK(log.told.at("r.queued") ==
          all_heard{{0, 0, false}, {0.125, ms, true}, {0.25, 2 * ms, true}, {0.25, 2 * ms, true}});
  }

  TEST_CASE("a delay of the observer comes on top of that of the wire") {
    struct late_only
        : cca::graph<cca::rate<1000>, cca::node<"s", joints>, cca::node<"r", plus, cca::timed<1>>,
                     cca::node<"log", ear<cca::observe<"r.**", cca::delayed<1>>>, cca::timed<1>>,
                     cca::wire<"s.angles", "r.x", cca::delayed<1>>> {};
    auto c = started<late_only>();
    for (int k = 0; k < 4; ++k) c.step();
    const auto& told = c.get<"log">().told;
    CHECK(told.at("r.x") == all_heard{{0, never, false}, {0, never, false}, {0, 0, true}, {0.125, ms, true}});
    CHECK(told.at("r.y") == all_heard{{0, never, false}, {1, 0, true}, {1, 0, true}, {1.125, ms, true}});
  }

  TEST_CASE("with a delay an observer hears what is taken from a queue, when it was taken") {
    // Beats 0 and 2 take what was published in beats 0 and 1; in between nothing is new.
    const auto log = after<cca::observe<"r.**", cca::delayed<1>>>(6);
    CHECK_EQ(log.paths, names{"r.y", "r.late", "r.queued"});
    CHECK(log.told.at("r.queued") == all_heard{{0, never, false},
                                               {0, 0, true},
                                               {0, 0, false},
                                               {0.125, ms, true},
                                               {0.125, ms, false},
                                               {0.25, 2 * ms, true}});
    // Nothing is lost to a slower one but what it does not see, and a program hears the same.
    const auto slow = after<cca::observe<"r.queued.**", cca::delayed<2>>, cca::timed<3>>(7);
    CHECK(slow.told.at("r.queued") == all_heard{{0, never, false}, {0, 0, true}, {0.25, 2 * ms, true}});
  }

  TEST_CASE("of merged wires each sample is heard that was taken - an empty queue tells nothing new") {
    struct sums : cca::graph<cca::rate<1000>, cca::node<"a", joints, cca::timed<4>>,
                             cca::node<"b", joints, cca::timed<4, 2>>, cca::node<"r", plus, cca::timed<1>>,
                             cca::node<"log", ear<cca::observe<"r.x.**", cca::delayed<1>>>, cca::timed<1>>,
                             cca::wire<"a.angles", "r.x", cca::merged<2>, cca::initial<0.5>>,
                             cca::wire<"b.angles", "r.x", cca::merged<2>, cca::delayed<2>>> {};
    auto c = started<sums>();
    for (int k = 0; k < 7; ++k) c.step();
    // Beat 4: what `b` published in beat 2 arrives first; what `a` publishes is taken in beat 5.
    CHECK(c.get<"log">().told.at("r.x") == all_heard{{0.5, never, false},
                                                     {0, 0, true},
                                                     {0, 0, false},
                                                     {0, 0, false},
                                                     {0, 0, false},
                                                     {0.25, 2 * ms, true},
                                                     {0.5, 4 * ms, true}});
  }

  TEST_CASE("an observer's queue holds what it has not seen, for each output") {
    const auto log = after<cca::observe<"s.*", cca::queue<2, cca::drop_oldest>>, cca::timed<3>>(7);
    CHECK(log.told.at("s.angles") == all_heard{{0, 0, true}, {0.25, 2 * ms, true}, {0.625, 5 * ms, true}});
    const auto first = after<cca::observe<"s.*", cca::queue<2, cca::drop_newest>>, cca::timed<3>>(7);
    CHECK(first.told.at("s.angles") == all_heard{{0, 0, true}, {0.125, ms, true}, {0.25, 2 * ms, true}});
  }

  TEST_CASE("a full queue of an observer that rejects is a fault") {
    auto c = started<kinds<cca::observe<"s.*", cca::queue<2, cca::reject>>, once_in_three>>();
    c.run(cca::for_beats<6>{});
    CHECK(c.state() == cca::state::faulted);
    CHECK_EQ(std::string(c.fault().reason()), "a sample arrived while the queue was full");
  }

  TEST_CASE("between two beats: outputs, and inputs as they were in the last one") {
    struct watched
        : cca::graph<cca::rate<1000>, cca::node<"s", joints>, cca::node<"r", reads_all, cca::timed<2>>,
                     cca::wire<"s.angles", "r.late", cca::delayed<2>, cca::initial<0.5>>,
                     cca::wire<"s.angles", "r.queued", cca::queue<4, cca::drop_newest>>,
                     cca::observe<"r.**">> {};
    auto c = started<watched>();
    std::map<std::string, all_heard> told;
    for (int k = 0; k < 4; ++k) {
      c.step();
      c.observed([&](const cca::observation& one) {
        told[std::string(one.path)].push_back({one.values[0], one.origin, one.fresh});
      });
    }
    CHECK_EQ(told.size(), 3);
    CHECK(told.at("r.late") ==
          all_heard{{0.5, never, false}, {0.5, never, false}, {0, 0, true}, {0.125, ms, true}});
    CHECK(told.at("r.queued") ==
          all_heard{{0, 0, false}, {0.125, ms, true}, {0.25, 2 * ms, true}, {0.25, 2 * ms, true}});
  }
}
