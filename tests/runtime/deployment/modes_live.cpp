// Other threads ask a deployment of modes that runs: for modes, for parts, for a pause. All environments obey
// in one and the same beat.
#include <atomic>
#include <string>
#include <thread>
#include <type_traits>

#include "../core/live_rig.hpp"
#include "asking.hpp"
#include "modes_rig.hpp"

using namespace modes_test;
using deployment_test::asking;
using deployment_test::which;
using live_test::beside;
using live_test::insist;
using live_test::wait_until;

namespace {

constexpr const char* names[] = {"walk", "stand", "fall"};

// Asks for something else in every few beats: for a mode, or for a part that several environments have, where
// the active mode has it.
template <class D>
void ask_for(auto& of, const auto& c) {
  const int what = which(c.beat_index(), std::is_same_v<D, in_four> ? 5 : 3);
  if (what < 0) return;
  if (what < 3) of.switch_to(names[what]);
  else if (c.mode() != "fall" && what == 3) of.stop("mind.deep");
  else if (c.mode() != "fall" && what == 4) of.start("mind.deep");
}

// On a busy machine samples are late.
struct patient : cca::deployment<moves,
                                 cca::environment<"robot", cca::nodes<"robot", "asks", "maybe">>,
                                 cca::environment<"mind", cca::nodes<"mind", "slow", "third">>,
                                 cca::environment<"rest", cca::other_nodes>,
                                 cca::tolerate<20>> {};

void quiet(auto& c) { c.template get<"asks">().asks = c.template get<"also_asks">().asks = false; }

}  // namespace

TEST_SUITE("live access to a deployment of modes") {
  TEST_CASE_TEMPLATE("in a fast run: the bits of one loop that was told in that beat", D, in_two, in_four) {
    for (const bool components_ask : {false, true}) {
      cca::controller<moves> loop;
      cca::deployed<D> spread;
      begin(loop);
      begin(spread);
      if (!components_ask) {
        quiet(loop);
        quiet(spread);
      }
      for (const int beats : {1, 2, 300, 50}) {
        loop.run(cca::for_some_beats{beats}, cca::as_fast_as_possible(), [](auto& now) {
          ask_for<D>(now, now);
          return true;
        });
        cca::live_access live(spread);
        const auto ask = [](auto& at, auto& d) { ask_for<D>(at, d); };
        asking<D, decltype(ask)> outside{live, ask};
        spread.run(cca::for_some_beats{beats}, cca::as_fast_as_possible(), outside);
        CHECK(live.is_taken());
        CHECK_EQ(live.mode(), loop.mode());
        check_equal(loop, spread);
      }
    }
  }

  TEST_CASE_TEMPLATE("in a wall-clock run: the same, some beats later", D, in_two, in_four) {
    constexpr std::int64_t beats = 70;
    constexpr std::int64_t later = cca::detail::beat_of_order<D>(0, false);
    static_assert(later < 30);
    cca::controller<moves> loop;
    begin(loop);
    quiet(loop);
    loop.run(cca::for_some_beats{1 + later});
    loop.switch_to<"stand">();
    loop.run(cca::for_some_beats{beats - 1 - later});
    for (const double speed : {0.2, 0.1, 0.05}) {
      cca::deployed<D> spread;
      begin(spread);
      quiet(spread);
      cca::live_access live(spread);
      CHECK(live.template switch_to<"stand">());
      spread.run(cca::for_beats<beats>{}, cca::at_speed(speed), live);
      if (!spread.fault()) CHECK_EQ(spread.mode(), "stand");
      if (spread.late() > 0 || spread.lost_periods() > 0 || spread.fault()) continue;
      check_equal(loop, spread);
      return;
    }
    MESSAGE("something was late each time: nothing to compare");
  }

  TEST_CASE("in a wall-clock run `between` asks for a mode, too") {
    for (const double speed : {0.2, 0.1, 0.05}) {
      cca::deployed<in_two> spread;
      begin(spread);
      quiet(spread);
      spread.run(cca::for_beats<60>{}, cca::at_speed(speed), [](auto& now) {
        if (now.beat_index() == 5) {
          now.template switch_to<"fall">();
          CHECK_EQ(now.mode(), "walk");
        }
        return true;
      });
      if (spread.fault()) continue;  // a busy machine
      CHECK_EQ(spread.mode(), "fall");
      return;
    }
    MESSAGE("contact was lost each time");
  }

  TEST_CASE("what no beat has taken has its effect when the run ends") {
    cca::deployed<in_four> spread;
    begin(spread);
    quiet(spread);
    cca::live_access live(spread);
    CHECK(live.switch_to("fall"));
    spread.run(cca::for_beats<3>{}, cca::at_speed(0.05), live);
    CHECK(live.is_taken());
    if (spread.fault()) return;  // a busy machine
    CHECK_EQ(spread.mode(), "fall");
    CHECK_EQ(live.mode(), "fall");
    CHECK(live.stop("mind.deep"));  // `fall` lacks it
    spread.run(cca::for_beats<1>{}, cca::as_fast_as_possible(), live);
    CHECK_EQ(live.refused_by(), "mind.deep");
  }

  TEST_CASE("a window in another thread: modes, a pause, single beats") {
    const auto window = [](auto pace) {
      cca::deployed<patient> spread;
      begin(spread);
      quiet(spread);
      cca::live_access<cca::deployed<patient>> live(spread);
      beside(spread, live, pace, [&] {
        for (int i = 0; i < 8; ++i) {
          insist(live, [&] { return live.switch_to(names[i % 3]); });
          wait_until([&] { return live.mode() == names[i % 3]; });
        }
        live.pause();
        wait_until([&] { return live.is_paused(); });
        const std::int64_t at = live.beat_index();
        CHECK(live.switch_to("stand"));  // has its effect in the beats that are made
        for (int i = 1; i <= 40; ++i) {
          live.step();
          wait_until([&] { return live.beat_index() == at + i; });
        }
        wait_until([&] { return live.mode() == "stand"; });
        live.go_on();
        wait_until([&] { return live.beat_index() > at + 60; });
      });
      CHECK(!spread.fault());
    };
    SUBCASE("in a fast run") { window(cca::as_fast_as_possible{}); }
    SUBCASE("in a wall-clock run") { window(cca::at_speed(0.2)); }
  }
}
