// Who makes which run, and what counts: each once, whoever is lost on the way.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <cca/mpi/hand_out.hpp>

using cca::mpi::detail::hand_out;

namespace {

using numbers = std::vector<std::uint64_t>;

std::string result_of(std::uint64_t i) { return "result " + std::to_string(i); }

}  // namespace

TEST_SUITE("hand_out") {
  TEST_CASE("many wait: each gets its share, at least as many as it could begin") {
    hand_out book(100);
    CHECK_EQ(book.take(1, 1, 1, 2).size(), 12);  // half of a quarter
    CHECK_EQ(book.take(0, 30, 1, 2).size(), 30);
    CHECK_EQ(book.take(0, 100, 1, 2).size(), 58);
    CHECK(book.take(1, 1, 1, 2).empty());
    CHECK_FALSE(book.is_over());
  }

  TEST_CASE("runs of a lost rank wait again, the lowest first, and what it says later does not count") {
    hand_out book(4);
    CHECK_EQ(book.take(1, 2, 1, 1), numbers{0, 1});
    CHECK_EQ(book.take(2, 1, 1, 1), numbers{2});
    CHECK(book.is_done(1, 1, result_of(1)));
    book.is_lost(1);
    CHECK_EQ(book.take(2, 2, 1, 1), numbers{0, 3});
    CHECK_FALSE(book.is_done(1, 0, "late"));
    for (const std::uint64_t i : {3u, 2u, 0u}) CHECK(book.is_done(2, i, result_of(i)));
    CHECK_FALSE(book.is_done(2, 0, "twice"));
    CHECK_FALSE(book.is_done(2, 4, "none such"));
    CHECK(book.is_over());
    CHECK_EQ(book.take_results(), std::vector{result_of(0), result_of(1), result_of(2), result_of(3)});
  }

  TEST_CASE(
      "once it ceases, it is over when nothing is under way, and the results end before the first gap") {
    hand_out book(10);
    CHECK_EQ(book.take(1, 4, 1, 1), numbers{0, 1, 2, 3});
    book.is_done(1, 0, result_of(0));
    book.cease();
    CHECK(book.take(2, 1, 1, 1).empty());
    book.is_done(1, 3, result_of(3));
    book.is_dropped(1, 2);
    CHECK_FALSE(book.is_over());
    book.is_lost(1);
    CHECK(book.is_over());
    CHECK_EQ(book.take_results(), std::vector{result_of(0)});
  }

  TEST_CASE("of several failures that of the lowest number counts, and one of no run comes last") {
    hand_out book(3);
    CHECK_EQ(book.take(1, 3, 1, 1).size(), 3);
    book.has_failed(1, 3, "a setting");
    book.has_failed(1, 2, "run 2");
    book.has_failed(1, 1, "run 1");
    CHECK_FALSE(book.is_over());
    book.is_dropped(1, 0);
    CHECK(book.is_over());
    CHECK_EQ(book.failed().text, "run 1");
  }

  TEST_CASE("whoever is lost, and when: all runs come to their end once") {
    std::mt19937 random(1);
    for (int trial = 0; trial < 300; ++trial) {
      const std::size_t count = random() % 40;
      hand_out book(count);
      std::vector<numbers> under_way(5);  // by rank
      std::vector<bool> lives(5, true);
      for (int step = 0; !book.is_over(); ++step) {
        REQUIRE_LT(step, 10'000);
        const int rank = static_cast<int>(random() % 5);
        const auto r = static_cast<std::size_t>(rank);
        if (!lives[r]) {
          if (!under_way[r].empty()) CHECK_FALSE(book.is_done(rank, under_way[r].back(), "late"));
          continue;
        }
        if (rank != 0 && random() % 20 == 0) {
          lives[r] = false;
          book.is_lost(rank);
        } else if (under_way[r].empty()) {
          under_way[r] = book.take(rank, 1 + random() % 3, 3, 15);
        } else {
          CHECK(book.is_done(rank, under_way[r].back(), result_of(under_way[r].back())));
          under_way[r].pop_back();
        }
      }
      CHECK_EQ(book.count_finished(), count);
      const auto all = book.take_results();
      REQUIRE_EQ(all.size(), count);
      for (std::size_t i = 0; i < count; ++i) CHECK_EQ(all[i], result_of(i));
    }
  }
}
