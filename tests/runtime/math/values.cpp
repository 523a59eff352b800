// Domains, signs of zeros, infinities and NaN of the elementary functions, as the C standard has them (annex
// F): beside the C library, whose results there are exact. And what holds in a constant expression and of a
// float.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

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
    if (!(x < 0)) ONE(sqrt);
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
  CHECK(bits(math::sqrt(-0.0)) == bits(-0.0));
  CHECK(bits(math::sqrt(std::bit_cast<double>(std::uint64_t{0x7ff8000000000123}))) == one_nan);
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

// Of any argument: a constant expression may not compute what is NaN or too large, not even beside its
// result.
namespace {
constexpr std::array any{
    0.0,    -0.0,  5e-324, 1e-310,   -1e-200,   1e-20, 0.3,
    -0.5,   1.0,   -1.0,   1.5,      2.5,       -3.0,  100.0,
    709.7,  709.9, 711.0,  -745.,    -746.,     1.7e6, 1e15,
    4.6e15, 1e22,  -1e300, infinite, -infinite, none,  std::numeric_limits<double>::max()};

template <class Function>
constexpr auto of_one = [] {
  std::array<double, any.size()> all{};
  for (std::size_t i = 0; i < any.size(); ++i) all[i] = Function{}(any[i]);
  return all;
}();
template <class Function, std::size_t I>
constexpr auto of_two = [] {
  std::array<double, any.size()> all{};
  for (std::size_t i = 0; i < any.size(); ++i) all[i] = Function{}(any[I], any[i]);
  return all;
}();

template <class Function>
void check_one(const char* name, Function function) {
  for (std::size_t i = 0; i < any.size(); ++i) {
    volatile double x = any[i];
    INFO(name << " of " << any[i]);
    CHECK(bits(of_one<Function>[i]) == bits(function(double{x})));
  }
}
template <class Function, std::size_t... I>
void check_two(const char* name, Function function, std::index_sequence<I...>) {
  const auto check = [&](const auto& constants, double first) {
    for (std::size_t i = 0; i < any.size(); ++i) {
      volatile double x = first, y = any[i];
      INFO(name << " of " << first << " and " << any[i]);
      CHECK(bits(constants[i]) == bits(function(double{x}, double{y})));
    }
  };
  (check(of_two<Function, I>, any[I]), ...);
}
}  // namespace

TEST_CASE("a constant is what is computed at run time") {
#define CONSTANT(function) check_one(#function, [](double x) { return math::function(x); })
  CONSTANT(sin);
  CONSTANT(cos);
  CONSTANT(tan);
  CONSTANT(exp);
  CONSTANT(expm1);
  CONSTANT(sinh);
  CONSTANT(cosh);
  CONSTANT(tanh);
  CONSTANT(log);
  CONSTANT(atan);
  CONSTANT(asin);
  CONSTANT(acos);
  CONSTANT(sqrt);
  CONSTANT(cbrt);
  CONSTANT(trunc);
  CONSTANT(floor);
  CONSTANT(ceil);
  CONSTANT(round);
#define CONSTANT_OF_TWO(function)                                         \
  check_two(                                                              \
      #function, [](double x, double y) { return math::function(x, y); }, \
      std::make_index_sequence<any.size()>{})
  CONSTANT_OF_TWO(atan2);
  CONSTANT_OF_TWO(pow);
  CONSTANT_OF_TWO(hypot);
  CONSTANT_OF_TWO(fmod);
}
