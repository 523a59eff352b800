// Many runs on all cores: each once, in their order, the same bits on any number of threads.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <cca/cca.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/sim/compiled/robot.hpp>
#include <cca/sim/rollouts.hpp>

#include "waving.hpp"

using namespace cca;

namespace {

namespace arm = robots::arm;

using rollouts_test::waving;
struct waved : graph<node<"targets", waving>,
                     node<"limits", limiter<arm::angles>>,
                     node<"robot", sim::robot<arm::description, sim::compiled>>,
                     wire<"targets.angles", "limits.command">,
                     wire<"robot.angles", "limits.measured">,
                     wire<"limits.safe", "robot.position">> {};

// [rollouts]
// How fast the tip is after half a second, for each width of a wave.
std::vector<double> speeds(const std::vector<double>& widths, unsigned threads) {
  controller<waved> start;  // a controller with its world is a value
  start.load();
  return sim::rollouts(widths.size(),
                       [&](std::size_t i) {
                         auto c = start;
                         c.get<"targets">().wide = widths[i];
                         c.start();
                         c.run(for_beats<500>{});
                         return c.get<"robot.simulator">().world().end("arm").velocity.norm();
                       },
                       {.threads = threads});
}
// [rollouts end]

std::vector<std::size_t> to(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

TEST_SUITE("rollouts") {
  TEST_CASE("the same bits on any number of threads") {
    std::vector<double> widths;
    for (int i = 0; i < 20; ++i) widths.push_back(0.01 * i);
    const std::vector<double> alone = speeds(widths, 1);
    CHECK_LT(alone[0], 1e-3);
    CHECK_GT(alone[19], 0.1);
    for (const unsigned threads : {0u, 2u, 3u, 40u}) CHECK_EQ(speeds(widths, threads), alone);
  }

  TEST_CASE("each runs once, and stands at its number") {
    for (const unsigned threads : {1u, 4u}) {
      for (const std::size_t count : {0u, 1u, 3u, 1000u}) {
        std::atomic<std::size_t> begun = 0;
        std::vector<std::size_t> told;
        const auto all =
            sim::rollouts(count, [&](std::size_t i) { return ++begun, i; },
                          {.threads = threads, .over = [&](std::size_t n) { told.push_back(n); }});
        CHECK_EQ(all, to(count));
        CHECK_EQ(begun, count);
        std::vector<std::size_t> each = to(count);
        for (std::size_t& n : each) ++n;
        CHECK_EQ(told, each);
      }
    }
  }

  TEST_CASE("results need only be movable") {
    const auto all = sim::rollouts(9, [](std::size_t i) { return std::make_unique<std::size_t>(i); });
    REQUIRE_EQ(all.size(), 9);
    CHECK_EQ(*all[8], 8);
  }

  TEST_CASE("once it is to stop, nothing begins, and what was cut short is left out") {
    for (const unsigned threads : {1u, 4u}) {
      std::atomic<bool> stop = false;
      std::atomic<std::size_t> begun = 0;
      const auto all = sim::rollouts(1000,
                                     [&](std::size_t i) {
                                       ++begun;
                                       if (i == 20) stop = true;
                                       return i;
                                     },
                                     {.threads = threads, .stops = [&] { return stop.load(); }});
      CHECK_LE(begun, 20 + threads);
      CHECK_LE(all.size(), 20);
      CHECK(std::ranges::is_sorted(all));
      CHECK(std::ranges::find(all, 20u) == all.end());
      if (threads == 1) CHECK_EQ(all, to(20));
    }
  }

  TEST_CASE("after a stop each result still stands at its number") {
    std::atomic<bool> stop = false;
    const auto first_is_slow = [&](std::size_t i) {
      while (i == 2 && !stop) std::this_thread::yield();
      if (i == 9) stop = true;
      return i;
    };
    CHECK_EQ(sim::rollouts(20, first_is_slow, {.threads = 2, .stops = [&] { return stop.load(); }}), to(2));
  }

  TEST_CASE("what the settings have may throw, too") {
    for (const unsigned threads : {1u, 4u}) {
      const auto same = [](std::size_t i) { return i; };
      const auto stops = []() -> bool { throw std::runtime_error("asked"); };
      const auto over = [](std::size_t n) { n > 5 ? throw std::runtime_error("told") : void(); };
      CHECK_THROWS_WITH_AS(sim::rollouts(9, same, {.threads = threads, .stops = stops}), "asked",
                           std::runtime_error);
      CHECK_THROWS_WITH_AS(sim::rollouts(9, same, {.threads = threads, .over = over}), "told",
                           std::runtime_error);
    }
  }

  TEST_CASE("if two runs fail, the exception of the lower number is thrown, also if it came later") {
    std::atomic<bool> second_is_leaving = false;
    const auto both_fail = [&](std::size_t i) {
      if (i == 1) {
        second_is_leaving = true;
        throw std::runtime_error("run 1");
      }
      while (!second_is_leaving) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      if (i == 0) throw std::runtime_error("run 0");
      return i;
    };
    CHECK_THROWS_WITH_AS(sim::rollouts(2, both_fail, {.threads = 2}), "run 0", std::runtime_error);
  }

  TEST_CASE("an exception ends all") {
    for (const unsigned threads : {1u, 4u}) {
      std::atomic<int> under_way = 0;
      std::atomic<std::size_t> begun = 0;
      const auto fails_from_20_on = [&](std::size_t i) {
        ++begun, ++under_way;
        if (i >= 20) {
          --under_way;
          throw std::runtime_error("run " + std::to_string(i));
        }
        --under_way;
        return i;
      };
      CHECK_THROWS_WITH_AS(sim::rollouts(1000, fails_from_20_on, {.threads = threads}), "run 20",
                           std::runtime_error);
      CHECK_EQ(under_way, 0);
      CHECK_LE(begun, 20 + threads);
    }
  }
}
