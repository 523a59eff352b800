// The ring between two environments, seen by one thread: what a reader finds, also one that is far behind.
#include <doctest/doctest.h>

#include <cca/runtime/environments/exchange.hpp>

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

}  // namespace

TEST_SUITE("sample ring") {
  TEST_CASE("a sample is taken in the beats behind its own") {
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
}
