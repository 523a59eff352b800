// Numbers in bytes: every step of 12 and 16 bits, ends, middles, and numbers beyond the range.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include <cca/hardware/position_unwrap.hpp>
#include <cca/hardware/drives/wire_number.hpp>

using namespace cca::hardware;
using namespace cca::hardware::detail;

TEST_CASE("wire numbers: every step comes back, and is the nearest to the numbers around it") {
  for (const steps r : {steps{-12.5, 12.5, 16}, steps{-50, 50, 12}, steps{0, 500, 12}, steps{0, 5, 12},
                        steps{-18, 18, 12}, steps{-144, 144, 12}}) {
    const double width = (r.upper - r.lower) / r.count();
    for (std::uint32_t s = 0; s <= static_cast<std::uint32_t>(r.count()); ++s) {
      bool cut = false;
      REQUIRE(r.to_step(r.from_step(s), cut) == s);
      if (s > 0) REQUIRE(r.to_step(r.from_step(s) - 0.49 * width, cut) == s);
      if (s < r.count()) REQUIRE(r.to_step(r.from_step(s) + 0.49 * width, cut) == s);
      REQUIRE(!cut);
    }
    bool cut = false;
    CHECK(r.to_step(std::nextafter(r.upper, 1e9), cut) == r.count());
    CHECK(cut);
    cut = false;
    CHECK(r.to_step(std::nextafter(r.lower, -1e9), cut) == 0);
    CHECK(cut);
  }
}

TEST_CASE("wire numbers: zero in the middle of a range takes the lower step, as in drivers that truncate") {
  bool cut = false;
  CHECK(steps{-12.5, 12.5, 16}.to_step(0, cut) == 0x7FFF);
  CHECK(steps{-18, 18, 12}.to_step(0, cut) == 0x7FF);
  CHECK(steps{0, 5, 12}.to_step(0, cut) == 0);
}

TEST_CASE("wire numbers: integers are rounded to the nearest, but never to the most negative one") {
  for (const int bits : {8, 16, 32}) {
    const std::int64_t most = (std::int64_t{1} << (bits - 1)) - 1;
    for (const std::int64_t n :
         {-most, -most + 1, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, most - 1, most}) {
      bool cut = false;
      CHECK(nearest_integer(static_cast<double>(n), bits, cut) == n);
      CHECK(nearest_integer(static_cast<double>(n) + 0.4, bits, cut) == n);
      CHECK(!cut);
    }
    for (const double beyond :
         {1e30, static_cast<double>(most) + 1, std::numeric_limits<double>::infinity()}) {
      bool up = false, down = false;
      CHECK(nearest_integer(beyond, bits, up) == most);
      CHECK(nearest_integer(-beyond, bits, down) == -most);
      CHECK(up);
      CHECK(down);
    }
  }
}

TEST_CASE("wire numbers: floats are limited to their range") {
  bool cut = false;
  CHECK(to_float(1.5, cut) == 1.5f);
  CHECK(!cut);
  CHECK(to_float(1e300, cut) == std::numeric_limits<float>::max());
  CHECK(cut);
  CHECK(to_float(-1e300, cut) == -std::numeric_limits<float>::max());
}

TEST_CASE("wire numbers: missing bytes are read as zero and not written") {
  std::array<std::uint8_t, 3> bytes{1, 2, 3};
  CHECK(got<std::uint16_t>(bytes, 0) == 0x0201);
  CHECK(got<std::uint32_t>(bytes, 1) == 0x00000302);
  CHECK(got<std::uint32_t>(bytes, 9) == 0);
  put(bytes, 1, std::uint32_t{0xAABBCCDD});
  CHECK(bytes == std::array<std::uint8_t, 3>{1, 0xDD, 0xCC});
}

TEST_CASE("unwrap: a position goes on over the end of the range, both ways, for many turns") {
  position_unwrap unwrap(25);
  const auto wrapped = [](double q) { return q - 25 * std::floor((q + 12.5) / 25); };
  double worst = 0;
  for (int k = 0; k < 4000; ++k) {
    const double q = 90 * std::sin(0.002 * k);
    worst = std::fmax(worst, std::fabs(unwrap(wrapped(q)) - q));
  }
  CHECK(worst < 1e-9);
  CHECK(unwrap(std::numeric_limits<double>::quiet_NaN()) == doctest::Approx(90 * std::sin(0.002 * 3999)));
  unwrap.restart();
  CHECK(unwrap(-3) == -3);
}
