// Times of frames while the real-time clock is set.
#include <doctest/doctest.h>

#include <cstdint>

#include <cca/hardware/bus/arrival_clock.hpp>

namespace {

constexpr std::int64_t ms = 1'000'000, second = 1000 * ms;

struct clocks {
  cca::hardware::detail::arrival_clock times{};
  std::int64_t monotonic = 100 * second, real = 1'700'000'000 * second;

  // A frame that is read `waited` after it came, while the real-time clock is set by `step`.
  std::int64_t frame(std::int64_t waited = 0, std::int64_t step = 0) {
    const std::int64_t stamp = real;
    pass(waited);
    real += step;
    return times(stamp, real, monotonic);
  }
  void pass(std::int64_t time) { monotonic += time, real += time; }
};

}  // namespace

TEST_CASE("arrival clock: the time is that of the stamp, on the monotonic clock") {
  clocks c;
  CHECK(c.frame(ms) == 100 * second);
  c.pass(5 * ms);
  CHECK(c.frame(2 * ms) == 100 * second + 6 * ms);
}

TEST_CASE("arrival clock: the real-time clock is set back, and no time lies in the future") {
  clocks c;
  CHECK(c.frame(ms, -3600 * second) <= c.monotonic);
  const std::int64_t then = c.frame();
  CHECK(then <= c.monotonic);
  c.pass(200 * ms);  // a stall is seen at once
  CHECK(c.frame() - then == 200 * ms);
}

TEST_CASE("arrival clock: it is set forward, and no time lies before the last one") {
  clocks c;
  const std::int64_t first = c.frame();
  c.pass(ms);
  CHECK(c.frame(ms, 3600 * second) == first);
  c.pass(ms);
  CHECK(c.frame() == c.monotonic);
}
