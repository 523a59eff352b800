// However a run ends, the controller is in a legal state, and a signal ends it in order.
#include <doctest/doctest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include <cca/runtime/interruption.hpp>

#include "counting.hpp"

using namespace core_test;

namespace {

struct counting : cca::graph<cca::rate<1000>, cca::node<"counter", counter>> {};

struct pace_that_throws {
  void begin() {}
  void wait(std::int64_t now) {
    if (now > 0) throw std::runtime_error("no clock");
  }
};

}  // namespace

TEST_SUITE("ending") {
  TEST_CASE("an exception from between two beats leaves the controller started") {
    auto c = started<counting>();
    CHECK_THROWS_AS(
        c.run(cca::for_beats<9>{}, {}, [](auto&) { throw std::runtime_error("the disk is full"); }),
        std::runtime_error);
    CHECK_EQ(c.state(), cca::state::started);
    CHECK_EQ(c.beat_index(), 1);
    CHECK(c.step());
    c.run(cca::for_beats<2>{});
    CHECK_EQ(c.beat_index(), 4);
    c.stop();
    CHECK_EQ(c.state(), cca::state::loaded);
  }

  TEST_CASE("an exception from a pace leaves it started, too") {
    auto c = started<counting>();
    CHECK_THROWS_AS(c.run(cca::for_beats<9>{}, pace_that_throws{}), std::runtime_error);
    CHECK_EQ(c.state(), cca::state::started);
    CHECK_EQ(c.beat_index(), 1);
  }

  TEST_CASE("between two beats, false ends the run") {
    auto c = started<counting>();
    const auto until_5 = [](auto& running) { return running.beat_index() < 5; };
    CHECK_EQ(c.run(cca::for_beats<100>{}, {}, until_5), cca::state::started);
    CHECK_EQ(c.beat_index(), 5);
    CHECK_EQ(c.run(cca::without_end{}, {}, [](auto& running) { return running.beat_index() < 9; }),
             cca::state::started);
    CHECK_EQ(c.beat_index(), 9);
  }

  TEST_CASE("a signal ends the run after its beat") {
    for (const int number : {SIGINT, SIGTERM}) {
      const cca::interruption interrupted;
      auto c = started<counting>();
      c.run(cca::for_beats<3>{}, {}, interrupted);
      CHECK_EQ(c.beat_index(), 3);
      CHECK_FALSE(interrupted);
      CHECK_EQ(interrupted.exit_code(), 0);
      c.run(cca::without_end{}, {}, [&](auto& running) {
        if (running.beat_index() == 20) raise(number), raise(number);
        return !interrupted;
      });
      CHECK_EQ(c.beat_index(), 20);
      CHECK_EQ(c.state(), cca::state::started);
      CHECK(interrupted);
      CHECK_EQ(interrupted.exit_code(), 128 + number);
      const cca::interruption next;  // counts from now on
      CHECK_FALSE(next);
    }
  }

  TEST_CASE("before and after, a signal does what it did") {
    const pid_t child = fork();
    if (child == 0) {
      signal(SIGTERM, SIG_DFL);  // doctest catches it
      { const cca::interruption interrupted; }
      raise(SIGTERM);
      std::_Exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    CHECK_EQ(WTERMSIG(status), SIGTERM);
  }
}
