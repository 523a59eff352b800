// A deployment does what the controller of its architecture does, bit for bit: whatever is called between the
// runs, and however a run ends.
#include <doctest/doctest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <cca/config.hpp>

#include "robot_and_mind.hpp"
#include "same_story.hpp"

using namespace deployment_test;

namespace {

// All that a user can see, with all digits; but for the idle beats, which an environment makes whenever the
// machine lets it wait for longer than a period.
template <class Played>
std::string told(const Played& c) {
  std::ostringstream text;
  text << std::hexfloat << c.beat_index() << ' ' << cca::to_string(c.state()) << ' ' << c.fault().reason()
       << ' ' << c.fault_path() << ' ' << c.template get<"filter">().kept << ' '
       << c.template get<"thinker">().sum << ' ' << c.template get<"device">().command << ' '
       << c.template get<"device">().senses << ' ' << c.template get<"device">().faults;
  same_story::tell_observed(text, c);
  return text.str();
}

template <class Deployment, class F>
void check_same(F plays) {
  same_story::check<architecture, Deployment>(plays, [](const auto& c) { return told(c); });
}

struct three : cca::deployment<architecture,
                               cca::environment<"thoughts", cca::nodes<"thinker", "slow">>,
                               cca::environment<"robot", cca::other_nodes>> {};
struct all_in_one : cca::deployment<architecture, cca::environment<"all", cca::other_nodes>> {};

struct pace_that_throws {
  std::int64_t from;
  void begin() {}
  void wait(std::int64_t now) const {
    if (now >= from) throw std::runtime_error("no clock");
  }
};

}  // namespace

TEST_SUITE("deployed as one loop") {
  TEST_CASE("runs of any length, steps, and what is seen between two beats") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.start();
      tell();
      c.step();
      tell();
      c.run(cca::for_<1>{});
      tell();
      c.run(cca::for_beats<0>{});
      for (int i = 0; i < 30; ++i) c.run(cca::for_some_beats{i % 4});
      tell();
      int beats = 0;
      c.run(cca::without_end{}, cca::as_fast_as_possible{}, [&](auto&) {
        tell();
        return ++beats < 50;
      });
      tell();
      c.run(cca::for_beats<3>{}, cca::as_fast_as_possible{}, [&](auto& same) {
        CHECK_EQ(same.state(), cca::state::running);
        same.template set<"filter">({same.template get<"filter">().p.gain + 0.01});
      });
      tell();
    };
    check_same<two>(plays);
    check_same<three>(plays);
    check_same<all_in_one>(plays);
  }

  TEST_CASE("a fault cuts the beat in all environments, and all go on with the same beat") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.template set<"guard">({4.0});
      c.start();
      c.run(cca::for_<10>{});
      tell();
      CHECK_EQ(c.state(), cca::state::faulted);
      CHECK_EQ(c.fault_path(), "guard");
      const int idles = c.template get<"device">().idles;
      CHECK_FALSE(c.step());
      CHECK_FALSE(c.step());
      CHECK_EQ(c.template get<"device">().idles, idles + 2);
      tell();
      c.template set<"guard">({1e9});
      c.resume();
      c.run(cca::for_beats<41>{});
      tell();
      int calls = 0;
      c.template set<"guard">({-1e9});
      c.run(cca::for_<1>{}, cca::as_fast_as_possible{}, [&](auto&) { ++calls; });
      tell();
      CHECK_EQ(calls, 1);
      c.stop();
      CHECK(c.fault().reason()[0] == '\0');
      tell();
      c.template set<"guard">({1e9});
      c.start();
      c.run(cca::for_beats<9>{});
      tell();
    };
    check_same<two>(plays);
    check_same<three>(plays);
  }

  TEST_CASE("an exception between two beats ends the run in order") {
    check_same<two>([](auto& c, auto tell) {
      c.load();
      c.start();
      CHECK_THROWS_AS(c.run(cca::for_<1>{}, cca::as_fast_as_possible{},
                            [](auto& same) {
                              if (same.beat_index() == 20) throw std::runtime_error("the disk is full");
                            }),
                      std::runtime_error);
      CHECK_EQ(c.state(), cca::state::started);
      CHECK_EQ(c.beat_index(), 20);
      tell();
      CHECK_THROWS_AS(c.run(cca::for_<1>{}, pace_that_throws{30'000'000}), std::runtime_error);
      CHECK_EQ(c.beat_index(), 50);
      tell();
      c.run(cca::for_beats<100>{});
      tell();
    });
  }

  TEST_CASE("parameters by path, and what is refused") {
    cca::deployed<two> d;
    CHECK_THROWS_AS(d.start(), cca::refused);
    CHECK_THROWS_AS(d.run(cca::for_<1>{}), cca::refused);
    CHECK_FALSE(d.step());
    d.load();
    CHECK_THROWS_AS(d.set("filter.gain", "much"), cca::refused);
    CHECK_THROWS_AS(d.set("mind.filter.gain", 1.0), cca::refused);
    d.set("filter.gain", 0.125);
    CHECK_EQ(d.get<"filter">().p.gain, 0.125);
    CHECK_EQ(d.parameter<double>("guard.most"), 1e9);
    std::string all;
    d.for_each_component([&](std::string_view path, auto&) { all += std::string(path) + " "; });
    CHECK_EQ(all, "device filter guard thinker slow ");
  }
}
