// Parts that stop and start where their components, and those that stop them, run in different environments:
// in a fast run the bits are those of one loop.
#include <doctest/doctest.h>

#include "asking.hpp"
#include "parts_rig.hpp"

using deployment_test::asking;
using deployment_test::which;

using namespace parts_test;

TEST_SUITE("parts of deployments") {
  TEST_CASE_TEMPLATE("as in one loop", D, scattered<>, in_two<>) {
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    for (const std::int64_t beats : {1, 7, 300, 2, 1, 90}) {
      loop.run(cca::for_some_beats{beats});
      spread.run(cca::for_some_beats{beats});
      check_equal(loop, spread);
    }
    CHECK_GT(loop.template get<"mind.reach.aim">().stops, 20);
    CHECK_LT(loop.template get<"mind.reach.aim">().all.size(), 150);
  }

  TEST_CASE_TEMPLATE("between two runs", D, scattered<>, in_two<>) {
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    const auto both = [&](auto f) { f(loop), f(spread); };
    both([](auto& c) { c.run(cca::for_beats<20>{}); });
    both([](auto& c) { c.template stop<"mind">(); });
    both([](auto& c) { c.run(cca::for_beats<5>{}); });
    both([](auto& c) { c.start("mind"), c.stop("mind.reach"); });
    both([](auto& c) { c.run(cca::for_beats<40>{}); });
    check_equal(loop, spread);
    both([](auto& c) { c.stop(), c.start(); });
    both([](auto& c) { c.run(cca::for_beats<40>{}); });
    check_equal(loop, spread);
  }

  TEST_CASE_TEMPLATE("in `between` of a fast run, after what components ask for", D, scattered<>, in_two<>) {
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    const auto run = [](auto& c) {
      c.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), [](auto& now) {
        const int what = which(now.beat_index(), 4);
        if (what == 0) now.template stop<"mind">();
        if (what == 1) now.template start<"mind">();
        if (what == 2) now.stop("mind.reach");
        if (what == 3) now.start("mind.reach");
        return true;
      });
    };
    run(loop);
    run(spread);
    check_equal(loop, spread);
  }

  TEST_CASE("from outside, a part stops in one and the same beat in all environments") {
    using D = scattered<>;
    constexpr const char* parts[] = {"mind", "mind.reach"};
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    loop.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), [&](auto& now) {
      if (const int what = which(now.beat_index(), 4); what >= 0)
        what < 2 ? now.stop(parts[what]) : now.start(parts[what - 2]);
      return true;
    });
    cca::live_access live(spread);
    int asked = 0;
    const auto ask = [&](auto& at, auto& d) {
      const int what = which(d.beat_index(), 4);
      if (what < 0) return;
      ++asked;
      CHECK((what < 2 ? at.stop(parts[what]) : at.start(parts[what - 2])));
    };
    asking<D, decltype(ask)> outside{live, ask};
    spread.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), outside);
    CHECK(live.is_taken());
    CHECK_EQ(live.refused_by(), "");
    CHECK_GT(asked, 20);
    check_equal(loop, spread);
  }

  TEST_CASE_TEMPLATE("a fault ends the beat for requests too", D, scattered<47>, in_two<47>) {
    auto loop = running<cca::controller<skilled<47>>>();
    auto spread = running<cca::deployed<D>>();
    for (int i = 0; i < 2; ++i) {
      loop.run(cca::for_beats<80>{});
      spread.run(cca::for_beats<80>{});
      check_equal(loop, spread);
      if (i == 0) {
        CHECK_EQ(spread.state(), cca::state::faulted);
        loop.resume();
        spread.resume();
      }
    }
    CHECK_EQ(spread.beat_index(), 128);
  }
}
