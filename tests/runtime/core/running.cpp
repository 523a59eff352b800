// Running for a time, in steps and at any pace gives the same results.
#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

#include "counting.hpp"

using namespace core_test;

namespace {

struct counting : cca::graph<cca::rate<1000>,
                             cca::node<"counter", counter>,
                             cca::node<"tenth", adder, cca::timed<10>>,
                             cca::node<"log", journal>,
                             cca::wire<"counter.y", "tenth.x", cca::latest>,
                             cca::wire<"tenth.y", "log.x">> {};
struct odd_rate : cca::graph<cca::rate<3>, cca::node<"counter", counter>> {};
struct thrower {
  void process(cca::beat now) {
    if (now.index() == 2) throw std::runtime_error("beat 2");
  }
};
struct throwing : cca::graph<cca::rate<1000>, cca::node<"thrower", thrower>> {};

// How a process that calls f() ends: 0 if f returns, 1 if it throws, 2 if it calls std::terminate.
template <class F>
int end_of(F f) {
  const pid_t child = fork();
  if (child == 0) {
    std::set_terminate([] { std::_Exit(2); });
    try {
      f();
    } catch (const std::exception&) { std::_Exit(1); }
    std::_Exit(0);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

template <class F>
double seconds_of(F f) {
  const auto begin = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

static_assert(noexcept(std::declval<cca::controller<counting>&>().step()));

TEST_SUITE("running") {
  TEST_CASE("run for a time") {
    auto c = started<counting>();
    CHECK_EQ(c.run(cca::for_<2>{}), cca::state::started);
    CHECK_EQ(c.beat_index(), 2000);
    c.run(cca::for_<0.25>{});
    CHECK_EQ(c.beat_index(), 2250);
    c.run(cca::for_beats<7>{});
    CHECK_EQ(c.beat_index(), 2257);
    c.run(cca::for_some_beats{3});
    CHECK_EQ(c.beat_index(), 2260);
    c.run(cca::for_beats<0>{});
    c.run(cca::for_some_beats{-1});
    CHECK_EQ(c.beat_index(), 2260);
    CHECK_EQ(c.get<"counter">().value, 2260);
    CHECK_EQ(c.state(), cca::state::started);
  }

  TEST_CASE("a beat is whole nanoseconds, rounded down") {
    CHECK_EQ(cca::controller<counting>::period(), 1'000'000);
    CHECK_EQ(cca::controller<odd_rate>::period(), 333'333'333);
    auto c = started<odd_rate>();
    c.run(cca::for_<10>{});
    CHECK_EQ(c.beat_index(), 30);
  }

  TEST_CASE("a function between two beats") {
    auto c = started<counting>();
    std::vector<std::int64_t> indices;
    c.run(cca::for_beats<4>{}, cca::as_fast_as_possible{}, [&](auto& running) {
      CHECK_EQ(running.state(), cca::state::running);
      indices.push_back(running.beat_index());
    });
    CHECK_EQ(indices, std::vector<std::int64_t>{1, 2, 3, 4});
  }

  TEST_CASE("the same results at any pace") {
    auto fast = started<counting>(), slow = fast, quick = fast, stepped = fast;
    fast.run(cca::for_beats<60>{});
    CHECK_GE(seconds_of([&] { slow.run(cca::for_beats<60>{}, cca::at_speed(0.5)); }),
             0.11);  // the last beat begins at 118 ms
    const double at_wall_clock = seconds_of([&] {
      auto c = stepped;
      c.run(cca::for_beats<60>{}, cca::at_wall_clock());
    });
    CHECK_GE(at_wall_clock, 0.055);
    CHECK_LT(at_wall_clock, 30);
    CHECK_GE(seconds_of([&] { quick.run(cca::for_beats<60>{}, cca::at_speed(10)); }), 0.0055);
    for (int i = 0; i < 60; ++i) CHECK(stepped.step());
    CHECK_EQ(fast.get<"log">().all.size(), 6);
    CHECK_EQ(fast.get<"log">().all, slow.get<"log">().all);
    CHECK_EQ(fast.get<"log">().all, quick.get<"log">().all);
    CHECK_EQ(fast.get<"log">().all, stepped.get<"log">().all);
  }

  TEST_CASE("an invalid pace is refused") {
    for (const double none : {0.0, -1.0, std::nan("")})
      CHECK_EQ(words_of([&] { cca::at_speed{none}; }),
               "cca::at_speed: " + std::to_string(none) + " is no pace, expected a number above 0");
    auto c = started<counting>();
    c.run(cca::for_beats<1>{}, cca::at_speed(1e-300));  // the first beat begins at once at any speed
    c.run(cca::for_beats<3>{}, cca::at_speed(1e300));
    CHECK_EQ(c.beat_index(), 4);
  }

  TEST_CASE("nothing fires before start()") {
    cca::controller<counting> c;
    CHECK_FALSE(c.step());
    c.load();
    CHECK_FALSE(c.step());
    CHECK_EQ(c.get<"counter">().value, 0);
    CHECK_EQ(c.beat_index(), 0);
  }

  TEST_CASE("an exception from a component ends the program, however the beat was started") {
    CHECK_EQ(end_of([] { started<throwing>().run(cca::for_beats<2>{}); }), 0);
    CHECK_EQ(end_of([] { started<throwing>().run(cca::for_beats<3>{}); }), 2);
    CHECK_EQ(end_of([] {
               auto c = started<throwing>();
               for (int k = 0; k < 3; ++k) c.step();
             }),
             2);
  }
}
