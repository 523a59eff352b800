// A deployment of a set of modes: all environments switch in the same beat, and the bits are those of one
// loop that was told to switch in that beat.
#include <cmath>
#include <random>
#include <string_view>
#include <tuple>
#include <vector>

#include <cca/cca.hpp>
#include <cca/robot.hpp>

#include "modes_rig.hpp"

using namespace modes_test;

namespace {

using dice = std::mt19937;
int between(dice& d, int least, int most) { return std::uniform_int_distribution<int>(least, most)(d); }

constexpr const char* names[] = {"walk", "stand", "fall"};
constexpr const char* parts[] = {"mind.deep", "stance"};

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& e) { return e.what(); }
  return {};
}

// The same of both; what one refuses, the other refuses with the same words.
template <class A, class B, class F>
void tell_both(A& one, B& other, F f) {
  CHECK_EQ(words_of([&] { f(one); }), words_of([&] { f(other); }));
}

// Calls in random order.
template <class A, class B>
void play(A& loop, B& spread, unsigned seed, int calls) {
  CAPTURE(seed);
  dice d(seed);
  const bool asks = between(d, 0, 3) > 0;
  tell_both(loop, spread,
            [&](auto& c) { c.template get<"asks">().asks = c.template get<"also_asks">().asks = asks; });
  for (int i = 0; i < calls; ++i) {
    CAPTURE(i);
    const int what = between(d, 0, 9), which = between(d, 0, 2);
    const auto beats = static_cast<std::int64_t>(between(d, 0, 1) ? between(d, 0, 4) : between(d, 5, 60));
    tell_both(loop, spread, [&](auto& c) {
      if (what < 3) c.switch_to(names[which]);
      else if (what == 3) c.stop(parts[which % 2]);
      else if (what == 4) c.start(parts[which % 2]);
      else if (what == 5 && which == 0) c.stop(), c.start();
      else if (what == 6 && which == 0) c.template get<"asks">().faults_in = c.beat_index() + beats;
      else c.run(cca::for_some_beats{beats});
    });
    check_equal(loop, spread);
    if (loop.state() == cca::state::faulted)
      tell_both(loop, spread,
                [&](auto& c) {
                  c.switch_to("walk");  // refused
                  c.resume();
                }),
          tell_both(loop, spread, [&](auto& c) { c.resume(); });
  }
}

// ---- docs/modes.md ----

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}, cca::velocity{-4, 4}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

struct leg {
  auto sense() -> cca::out<"load", number> { return on_foot; }
  void act(cca::in<"command", leg_angles> to) { all.push_back(to[hip{}]); }
  double on_foot = 40;
  std::vector<double> all;
};
struct gait {
  auto process(cca::in<"load", number> on_foot, cca::beat now)
      -> std::tuple<cca::out<"angles", leg_angles>, cca::switch_to<"stand">> {
    phase += 6 * now.dt();
    return {0.5 * std::sin(phase), on_foot[cca::x{}] < 5};
  }
  double phase = 0;
};
struct stance {
  auto process(cca::in<"load", number> on_foot)
      -> std::tuple<cca::out<"angles", leg_angles>, cca::switch_to<"walking">> {
    beats = on_foot[cca::x{}] < 5 ? 0 : beats + 1;
    return {-0.2, beats > 300};
  }
  void on_start() { beats = 0; }
  int beats = 0;
};
// [architecture]
struct walking : cca::graph<cca::node<"leg", leg>,
                            cca::node<"gait", gait>,
                            cca::node<"limits", cca::limiter<leg_angles>>,
                            cca::wire<"leg.load", "gait.load", cca::delayed<1>>,
                            cca::wire<"gait.angles", "limits.command", cca::delayed<1>>,
                            cca::wire<"limits.safe", "leg.command">> {};

struct standing : cca::graph<cca::node<"leg", leg>,
                             cca::node<"stance", stance>,
                             cca::node<"limits", cca::limiter<leg_angles>>,
                             cca::wire<"leg.load", "stance.load", cca::delayed<1>>,
                             cca::wire<"stance.angles", "limits.command", cca::delayed<1>>,
                             cca::wire<"limits.safe", "leg.command">> {};

struct legs : cca::modes<cca::mode<"walking", walking>, cca::mode<"stand", standing>> {};

struct split : cca::deployment<legs,
                               cca::environment<"robot", cca::nodes<"leg", "limits">>,
                               cca::environment<"mind", cca::nodes<"gait", "stance">>> {};
// [architecture end]

// ---- who asks has the first turn of a beat ----

struct asks_first {
  auto process(cca::beat now) -> std::tuple<cca::out<"y", number>, cca::switch_to<"later">> {
    return {1, now.index() == 3};
  }
};
struct listens {
  void process(cca::in<"x", number>) {}
};
struct goes_on {
  auto process(cca::beat now) -> cca::out<"y", number> { return now.dt(); }
};
struct sooner : cca::graph<cca::rate<1000>,
                           cca::node<"asks", asks_first>,
                           cca::node<"listens", listens>,
                           cca::wire<"asks.y", "listens.x", cca::delayed<1>>> {};
struct later : cca::graph<cca::rate<1000>,
                          cca::node<"goes_on", goes_on>,
                          cca::node<"listens", listens>,
                          cca::wire<"goes_on.y", "listens.x">> {};
struct two_modes : cca::modes<cca::mode<"sooner", sooner>, cca::mode<"later", later>> {};
struct two_places : cca::deployment<two_modes,
                                    cca::environment<"here", cca::nodes<"asks">>,
                                    cca::environment<"there", cca::other_nodes>> {};

}  // namespace

TEST_SUITE("deployments of modes") {
  TEST_CASE("the page's leg") {
    // [use]
    cca::deployed<split> d;
    d.load();
    d.start();
    d.run(cca::for_<0.4>{});
    d.switch_to<"stand">();  // both environments
    d.run(cca::for_<0.2>{});
    // [use end]
    d.get<"leg">().on_foot = 0;
    d.run(cca::for_<0.4>{});
    d.get<"leg">().on_foot = 40;
    d.run(cca::for_<0.5>{});
    CHECK_EQ(d.mode(), "walking");

    cca::controller<legs> one_loop;
    begin(one_loop);
    one_loop.run(cca::for_<0.4>{});
    one_loop.switch_to<"stand">();
    one_loop.run(cca::for_<0.2>{});
    one_loop.get<"leg">().on_foot = 0;
    one_loop.run(cca::for_<0.4>{});
    one_loop.get<"leg">().on_foot = 40;
    one_loop.run(cca::for_<0.5>{});
    CHECK(d.get<"leg">().all == one_loop.get<"leg">().all);
    CHECK_EQ(d.get<"gait">().phase, one_loop.get<"gait">().phase);
  }

  TEST_CASE("the component that fires first in a beat switches, too") {
    cca::deployed<two_places> d;
    begin(d);
    d.run(cca::for_beats<4>{});
    CHECK_EQ(d.mode(), "later");
  }

  TEST_CASE_TEMPLATE("components switch: as in one loop", D, in_two, in_four) {
    cca::controller<moves> loop;
    cca::deployed<D> spread;
    begin(loop);
    begin(spread);
    for (const std::int64_t beats : {1, 7, 400, 2, 1, 290}) {
      loop.run(cca::for_some_beats{beats});
      spread.run(cca::for_some_beats{beats});
      check_equal(loop, spread);
    }
  }

  TEST_CASE_TEMPLATE("calls in random order", D, in_two, in_four) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
      cca::controller<moves> loop;
      cca::deployed<D> spread;
      begin(loop);
      begin(spread);
      play(loop, spread, seed, 40);
    }
  }

  TEST_CASE("in `between` of a fast run all environments switch at once") {
    cca::controller<moves> loop;
    cca::deployed<in_four> spread;
    begin(loop);
    begin(spread);
    const auto run = [](auto& c) {
      int calls = 0;
      c.run(cca::for_beats<300>{}, cca::as_fast_as_possible(), [&](auto& now) {
        const auto h = static_cast<unsigned>(++calls) * 2654435761u >> 16;
        if (h % 11 == 0) {
          now.switch_to(names[h % 3]);
          CHECK_EQ(now.mode(), names[h % 3]);
        }
        if (h % 13 == 0) now.template stop<"mind.deep">();
        return calls < 250;
      });
    };
    tell_both(loop, spread, run);
    check_equal(loop, spread);
  }

  TEST_CASE("a deployment of modes runs as one loop, too") {
    cca::controller<moves> loop;
    cca::controller<in_four> same;
    begin(loop);
    begin(same);
    play(loop, same, 5, 60);
  }
}
