// The ring between two environments, seen by one thread: what a reader finds, also one that is far behind.
#include <doctest/doctest.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

#include <cca/runtime/environments/exchange/exchange.hpp>

namespace {

using ring = cca::detail::sample_ring<2, 8>;

void publish(ring& r, std::int64_t beat, bool is_exact) {
  r.put(Eigen::Vector2d(static_cast<double>(beat), -static_cast<double>(beat)), 10 * beat, beat, is_exact);
}
void check_sample(const ring& r, std::uint64_t n, std::int64_t beat) {
  r.show(n, [&](const auto& v, std::int64_t origin, std::int64_t published_in) {
    CHECK_EQ(published_in, beat);
    CHECK_EQ(origin, 10 * beat);
    CHECK_EQ(v[0], static_cast<double>(beat));
    CHECK_EQ(v[1], -static_cast<double>(beat));
  });
}

// A sample that is being read: the writer goes on meanwhile, by `ahead` samples each time, `times` times.
struct overtaken_sample {
  ring& of;
  int ahead, times;
  std::int64_t next_beat;
  std::int64_t published_in = -1, origin = 0;
  int attempts = 0;
  struct coordinates {
    overtaken_sample& read;
    double values[2]{};
    double& operator[](int c) {
      if (c == 0) read.go_on();
      return values[c];
    }
  } vector{*this};

  void go_on() {
    if (attempts++ < times)
      for (int i = 0; i < ahead; ++i) publish(of, next_beat++, false);
  }
};

// As another process may leave it in shared memory: each slot says that it has sample `number`.
void claim_everywhere(ring& r, std::uint64_t number) {
  constexpr std::size_t slot_size = 64;
  static_assert(sizeof(ring) == ring::capacity * slot_size + 64);
  for (int i = 0; i < ring::capacity; ++i)
    reinterpret_cast<std::atomic<std::uint64_t>*>(reinterpret_cast<std::byte*>(&r) +
                                                  static_cast<std::size_t>(i) * slot_size)
        ->store(2 * number + 2);
}

}  // namespace

TEST_SUITE("sample ring") {
  TEST_CASE("a sample is taken in the beats after its own") {
    ring r;
    CHECK_EQ(r.end_before(0, 0), 0);
    CHECK_FALSE(r.has(0, 0));
    publish(r, 0, true);
    CHECK(r.has(0, 0));
    CHECK_FALSE(r.has(0, 1));
    CHECK_EQ(r.end_before(0, 0), 0);  // published in this beat: not yet
    CHECK_EQ(r.end_before(0, 1), 1);
    check_sample(r, 0, 0);
    CHECK_FALSE(r.has(1, 0));  // it has been taken
  }

  TEST_CASE("a reader that slept finds the newest before its beat, also where the writer is ahead") {
    ring r;
    for (std::int64_t beat = 0; beat < 6; ++beat) publish(r, beat, true);
    CHECK_EQ(r.end_before(0, 4), 4);
    check_sample(r, 3, 3);
    CHECK(r.has(0, 5));
    CHECK_FALSE(r.has(0, 6));
    CHECK_EQ(r.end_before(4, 100), 6);
  }

  TEST_CASE("a reader that was overtaken goes on with what is left") {
    ring r;
    for (std::int64_t beat = 0; beat < 30; ++beat) publish(r, beat, true);
    CHECK_EQ(r.end_before(2, 30), 30);
    check_sample(r, 29, 29);
    CHECK_FALSE(r.has(2, 29));  // then its writer's progress tells
  }

  TEST_CASE("samples of a sparse clock stay however late the beat is") {
    ring r;
    for (std::int64_t beat = 0; beat < 500; beat += 50) publish(r, beat, true);
    CHECK_EQ(r.end_before(5, 449), 9);
    check_sample(r, 8, 400);
  }

  TEST_CASE("a reader may ask whether a sample was repeated") {
    using marked = cca::detail::sample_ring<2, 8, true>;
    marked r;
    marked::sample came;
    std::uint64_t next = 0;
    r.put(Eigen::Vector2d(3, 4), 30, 3);
    r.repeat(3);  // of this beat: nothing to do
    r.repeat(4);
    r.put(Eigen::Vector2d(5, 6), 50, 5);
    REQUIRE(r.take(next, 10, came));
    CHECK_FALSE(came.is_repeated);
    REQUIRE(r.take(next, 10, came));
    CHECK(came.is_repeated);
    CHECK_EQ(came.published_in, 4);
    CHECK_EQ(came.origin, 30);
    CHECK_EQ(came.vector[1], 4);
    REQUIRE(r.take(next, 10, came));
    CHECK_FALSE(came.is_repeated);
    CHECK_FALSE(r.take(next, 10, came));
  }

  TEST_CASE("both ways of copying show the same") {
    ring r;
    publish(r, 7, false);
    publish(r, 8, true);
    std::uint64_t next = 0;
    ring::sample came;
    for (const std::int64_t beat : {7, 8}) {
      REQUIRE(r.take(next, 100, came));
      CHECK_EQ(came.published_in, beat);
      CHECK_EQ(came.vector[0], static_cast<double>(beat));
      check_sample(r, next - 1, beat);
    }
    CHECK_FALSE(r.take(next, 100, came));
  }

  TEST_CASE("a reader that is overtaken while it reads goes on with the oldest that is left") {
    for (const int ahead : {1, 3, 7, 8, 9, 30}) {
      CAPTURE(ahead);
      ring r;
      for (std::int64_t beat = 0; beat < ring::capacity; ++beat) publish(r, beat, false);
      std::uint64_t next = 0;  // its slot is the next that the writer fills
      overtaken_sample came{r, ahead, 1, ring::capacity};
      REQUIRE(r.take(next, 1000, came));
      CHECK_EQ(came.attempts, 2);
      CHECK_EQ(came.vector.values[0], static_cast<double>(came.published_in));
      CHECK_EQ(came.vector.values[1], -static_cast<double>(came.published_in));
      CHECK_EQ(next, came.published_in + 1);
      CHECK_LE(came.published_in, came.next_beat - 1);
      CHECK_GE(came.published_in, came.next_beat - ring::capacity);
      std::int64_t left = came.next_beat - came.published_in - 1;
      for (; r.take(next, 1000, came); --left) CHECK_EQ(next, came.published_in + 1);
      CHECK_EQ(left, 0);
    }
  }

  TEST_CASE("a reader that is overtaken each time gives up, and finds the newest when the writer is slower") {
    ring r;
    for (std::int64_t beat = 0; beat < ring::capacity; ++beat) publish(r, beat, false);
    std::uint64_t next = 0;
    overtaken_sample came{r, ring::capacity, 1000, ring::capacity};
    CHECK_FALSE(r.take(next, 1'000'000, came));
    CHECK_EQ(came.attempts, ring::most_attempts);
    CHECK_FALSE(r.take(next, 1'000'000, came));
    CHECK_EQ(came.attempts, 2 * ring::most_attempts);
    came.times = 0;
    std::int64_t newest = -1;
    while (r.take(next, 1'000'000, came)) newest = came.published_in;
    CHECK_EQ(newest, came.next_beat - 1);
  }

  TEST_CASE("no memory, whatever is in it, holds up a reader") {
    for (const std::uint64_t number :
         {std::uint64_t{0}, std::uint64_t{8}, std::uint64_t{1000}, ~std::uint64_t{0} / 2}) {
      CAPTURE(number);
      for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{5}, std::uint64_t{1001}}) {
        ring r;
        for (std::int64_t beat = 0; beat < 3; ++beat) publish(r, beat, false);
        claim_everywhere(r, number);
        std::uint64_t next = first;
        ring::sample came;
        int taken = 0;
        while (taken < 100 && r.take(next, 1000, came)) ++taken;
        CHECK_LE(taken, 1);
        CHECK_LE(r.end_before(first, 1000) - first, 1);
        CHECK_FALSE(r.has(first, 1000));
      }
    }
  }
}
