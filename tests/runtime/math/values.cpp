// Domains, signs of zeros, infinities and NaN of the elementary functions, as the C standard has them (annex
// F): beside the C library, whose results there are exact. And what holds in a constant expression and of a
// float.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <cca/base/math.hpp>

namespace {

namespace math = cca::math;
constexpr double infinite = std::numeric_limits<double>::infinity(),
                 none = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t one_nan = 0x7ff8000000000000;

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// Equal bits; a NaN is the one NaN, whatever the C library's is.
void same(const char* name, double x, double y, double ours, double theirs) {
  INFO(name << " of " << x << " and " << y << ": " << ours << ", not " << theirs);
  CHECK(bits(ours) == (std::isnan(theirs) ? one_nan : bits(theirs)));
}

constexpr std::array odd{0.0, -0.0, infinite, -infinite, none, -none};
constexpr std::array sides{
    0.0,   -0.0,   1.0,    -1.0,    2.0,      -2.0,      3.0, -3.0, 0.5, -0.5, 4503599627370497.0,
    1e300, -1e300, 5e-324, -5e-324, infinite, -infinite, none};

}  // namespace

TEST_CASE("zeros, infinities and NaN of one argument") {
  for (const double x : odd) {
#define ONE(function) same(#function, x, 0, math::function(x), std::function(x))
    ONE(sin);
    ONE(cos);
    ONE(tan);
    ONE(exp);
    ONE(expm1);
    ONE(sinh);
    ONE(cosh);
    ONE(tanh);
    ONE(log);
    ONE(atan);
    ONE(asin);
    if (!std::signbit(x) || std::isnan(x)) ONE(sqrt);
    ONE(cbrt);
    ONE(trunc);
    ONE(floor);
    ONE(ceil);
    ONE(round);
    if (!(x == 0)) ONE(acos);  // pi / 2 is rounded
  }
  for (const double x : {1.0, -1.0, 1.0000000000000002, -1.5, 1e300}) {
    ONE(log);
    if (std::abs(x) > 1) ONE(asin), ONE(acos);
    if (x > 0) ONE(sqrt);
  }
  CHECK(bits(math::sqrt(-1.0)) == one_nan);
  CHECK(bits(math::sqrt(-infinite)) == one_nan);
  CHECK(bits(math::sqrt(-0.0)) == 0);
  CHECK(math::acos(1.0) == 0);
  CHECK(math::exp(710.0) == infinite);
  CHECK(math::exp(-746.0) == 0);
  CHECK(math::exp(-745.0) == 5e-324);
  CHECK(math::expm1(-1000.0) == -1);
  CHECK(math::tanh(1000.0) == 1);
  CHECK(math::tanh(-1000.0) == -1);
  CHECK(math::cosh(710.4) == doctest::Approx(std::cosh(710.4)).epsilon(1e-12));
  CHECK(math::sinh(-711.0) == -infinite);
}

TEST_CASE("zeros, infinities and NaN of two arguments") {
  for (const double x : sides)
    for (const double y : sides) {
#define TWO(function) same(#function, x, y, math::function(x, y), std::function(x, y))
      const bool is_exact =
          x == 0 || y == 0 || std::isinf(x) || std::isinf(y) || std::isnan(x) || std::isnan(y);
      if (is_exact || std::abs(x) == 1 || (std::abs(x) == 2 && std::abs(y) <= 3 && y == std::floor(y)) ||
          y == 0.5)
        TWO(pow);
      if (is_exact) TWO(hypot);
      TWO(fmod);
      const double angle = math::atan2(x, y), theirs = std::atan2(x, y);  // multiples of pi / 4 are rounded
      INFO("atan2 of " << x << " and " << y << ": " << angle << ", not " << theirs);
      if (std::isnan(theirs)) CHECK(bits(angle) == one_nan);
      else CHECK((std::abs(angle - theirs) <= 5e-16 && std::signbit(angle) == std::signbit(theirs)));
    }
}

TEST_CASE("whole numbers") {
  for (const double x :
       {0.3, -0.3, 0.5, -0.5, 1.5, -1.5, 2.5, 0.49999999999999994, -0.49999999999999994, 4503599627370495.5,
        -4503599627370495.5, 4503599627370496.0, 9007199254740993.0, -1e18, 7.0, -7.0}) {
    ONE(trunc);
    ONE(floor);
    ONE(ceil);
    ONE(round);
  }
}

TEST_CASE("sine and cosine together are those of each") {
  for (double x = -50; x < 50; x += 0.37) {
    const auto both = math::sine_and_cosine(x);
    CHECK(both.sine == math::sin(x));
    CHECK(both.cosine == math::cos(x));
  }
}

TEST_CASE("a float is computed in double") {
  for (float x = -3; x < 3; x += 0.01f) {
    CHECK(math::sin(x) == static_cast<float>(math::sin(double{x})));
    CHECK(std::abs(math::exp(x) - std::exp(x)) <= 2e-7f * std::exp(x));
    CHECK(std::abs(math::atan2(x, 2.0f) - std::atan2(x, 2.0f)) <= 2e-7f);
  }
  static_assert(std::same_as<decltype(math::sin(1.0f)), float>);
}

TEST_CASE("a constant is what is computed at run time") {
  volatile double a = 0.7, b = -2.3;
  constexpr double in_constants[] = {math::sin(0.7),         math::cos(0.7),       math::tan(0.7),
                                     math::exp(0.7),         math::tanh(0.7),      math::log(0.7),
                                     math::sqrt(0.7),        math::pow(0.7, -2.3), math::acos(0.7),
                                     math::atan2(0.7, -2.3), math::cbrt(0.7),      math::hypot(0.7, -2.3),
                                     math::sin(1e22),        math::sqrt(5e-324)};
  volatile double far = 1e22, least = 5e-324;
  const double at_run_time[] = {math::sin(double{a}),   math::cos(double{a}),
                                math::tan(double{a}),   math::exp(double{a}),
                                math::tanh(double{a}),  math::log(double{a}),
                                math::sqrt(double{a}),  math::pow(double{a}, double{b}),
                                math::acos(double{a}),  math::atan2(double{a}, double{b}),
                                math::cbrt(double{a}),  math::hypot(double{a}, double{b}),
                                math::sin(double{far}), math::sqrt(double{least})};
  for (std::size_t i = 0; i < std::size(in_constants); ++i) {
    INFO(i);
    CHECK(bits(in_constants[i]) == bits(at_run_time[i]));
  }
}
