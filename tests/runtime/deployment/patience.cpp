// Who waits leaves its core to those for whom it waits, also in real time.
#include <doctest/doctest.h>

#include <cca/runtime/environments/waiting/patience.hpp>

#include <atomic>
#include <cstdint>
#include <thread>

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

  TEST_CASE("a bell that rings between two looks is not missed") {
    cca::detail::bell bell;
    const std::int64_t begin = cca::detail::monotonic_clock::now();
    const std::uint32_t before = bell.count();
    bell.ring();
    bell.wait(before, 10'000 * millisecond);
    CHECK_LT(cca::detail::monotonic_clock::now() - begin, 5'000 * millisecond);
  }

  TEST_CASE("a bell wakes who sleeps, each time") {
    cca::detail::bell to, back;
    std::atomic<int> number{0}, answer{0};
    const auto wait_for = [](cca::detail::bell& bell, const std::atomic<int>& what, int value) {
      for (;;) {
        const std::uint32_t before = bell.count();
        if (what == value) return;
        bell.wait(before, 10'000 * millisecond);
      }
    };
    const std::int64_t begin = cca::detail::monotonic_clock::now();
    std::thread other([&] {
      for (int n = 1; n <= 200; ++n) {
        wait_for(to, number, n);
        answer = n;
        back.ring();
      }
    });
    for (int n = 1; n <= 200; ++n) {
      number = n;
      to.ring();
      wait_for(back, answer, n);
    }
    other.join();
    CHECK_LT(cca::detail::monotonic_clock::now() - begin, 10'000 * millisecond);  // one miss takes as long
  }

  TEST_CASE("without a ring a wait ends") {
    cca::detail::bell bell;
    const std::int64_t begin = cca::detail::monotonic_clock::now();
    bell.wait(bell.count(), 2 * millisecond);
    CHECK_GE(cca::detail::monotonic_clock::now() - begin, millisecond);
  }
}
