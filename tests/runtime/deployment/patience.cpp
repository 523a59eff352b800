// Who waits leaves its core to those for whom it waits, also in real time.
#include <doctest/doctest.h>

#include <cca/runtime/environments/patience.hpp>

#include <cstdint>

namespace {

constexpr std::int64_t millisecond = 1'000'000;

}  // namespace

TEST_SUITE("patience") {
  TEST_CASE("the longer a wait lasts, the longer it sleeps") {
    using clock = cca::detail::monotonic_clock;
    const std::int64_t begin = clock::now();
    cca::detail::patience patience;
    int looks = 0, questions = 0;
    for (std::int64_t waited = 0; waited < 100 * millisecond; waited = clock::now() - begin) {
      if (waited > millisecond) ++looks;
      patience.wait();
      if (patience.is_time_to_ask()) ++questions;
    }
    CHECK_LE(looks, 250);  // each sleeps at least an eighth of a millisecond, and soon half of one
    CHECK_GE(questions, 1);
    CHECK_LE(questions, 50);
  }

  TEST_CASE("a short wait does not sleep, and its habit is to look longer") {
    cca::detail::waiting_habit habit;
    habit.spins = 128;
    {
      cca::detail::learned_patience patience(habit);
      for (int i = 0; i < 100; ++i) patience.wait();
    }
    CHECK_EQ(habit.spins, 256);
  }
}
