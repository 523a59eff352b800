// The elementary functions against MPFR: the greatest error of many random arguments, in units in the last
// place. By hand with more of them, and with the table of docs/math.md:
//   CCA_MATH_ARGUMENTS=10000000 build/test/tests/runtime/cca_test_math -tc="*accuracy*" -s
#include <doctest/doctest.h>
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>

#include <cca/base/math.hpp>

namespace {

namespace math = cca::math;
using generator = std::mt19937_64;
struct arguments {
  double x = 0, y = 0;
};

long how_many() {
  const char* wanted = std::getenv("CCA_MATH_ARGUMENTS");
  return wanted ? std::atol(wanted) : 4000;
}

// With random last bits: the distribution has those of a number near the bounds, so of a small one they are
// 0.
double uniform(generator& random, double low, double high) {
  const double x = std::uniform_real_distribution<double>(low, high)(random);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (random() & 0xffffff));
}
// Where arguments come from: of usual size, of any exponent, near the multiples of pi / 2, powers of about 1.
auto between(double low, double high) {
  return [=](generator& random) {
    arguments a{};
    a.x = uniform(random, low, high), a.y = uniform(random, low, high);
    return a;
  };
}
double of_exponent(generator& random, int low, int high) {
  const double size =
      std::ldexp(uniform(random, 1, 2), std::uniform_int_distribution<int>(low, high)(random));
  return (random() & 1) != 0 ? size : -size;
}
auto exponents(int low, int high) {
  return [=](generator& random) {
    arguments a{};
    a.x = of_exponent(random, low, high), a.y = of_exponent(random, low, high);
    return a;
  };
}
auto positive(int low, int high) {
  return [=](generator& random) {
    arguments a = exponents(low, high)(random);
    a.x = std::abs(a.x);
    return a;
  };
}
arguments near_quarters(generator& random) {
  const double k = std::uniform_int_distribution<int>(1, 1 << 20)(random);
  return {std::nextafter(k * 1.5707963267948966, (random() & 1) != 0 ? 1e9 : 0), 0};
}
// Doubles that are especially near to a multiple of pi / 2, of all exponents: convergents of 2^e / (pi / 2).
arguments near_far_quarters(generator& random) {
  constexpr double found[] = {0x1.6ac5b262ca1ffp+849, 0x1.836db670594p+1000, 0x1.3315953d382p+682,
                              0x1.c818ac6be76p+502, 0x1.6ac5b262ca1ffp+850};
  return {found[std::uniform_int_distribution<std::size_t>(0, std::size(found) - 1)(random)], 0};
}
arguments about_one(generator& random) {
  arguments a{};
  a.x = 1 + of_exponent(random, -50, -2);
  a.y = of_exponent(random, 0, 40);
  return a;
}
arguments whole_powers(generator& random) {
  arguments a{};
  a.x = uniform(random, -5, 0);
  a.y = std::uniform_int_distribution<int>(-300, 300)(random);
  return a;
}

template <class Ours, class Theirs, class Draw>
void judge(const std::string& name, double bound, Ours ours, Theirs theirs, Draw draw) {
  mpfr_t x, y, exact, off;
  mpfr_inits2(200, x, y, exact, off, nullptr);
  generator random(20261126);
  double worst = 0;
  arguments worst_at{};
  for (long i = 0; i < how_many(); ++i) {
    const arguments a = draw(random);
    const double got = ours(a);
    mpfr_set_d(x, a.x, MPFR_RNDN), mpfr_set_d(y, a.y, MPFR_RNDN);
    theirs(exact, x, y);
    const double rounded = mpfr_get_d(exact, MPFR_RNDN);
    if (!std::isfinite(rounded) || !std::isfinite(got)) {
      if (got == rounded || (std::isnan(got) && std::isnan(rounded))) continue;
      FAIL(name << " of " << a.x << ", " << a.y << ": " << got << " instead of " << rounded);
    }
    int exponent = -2000;
    if (rounded != 0) std::frexp(rounded, &exponent);
    mpfr_sub_d(off, exact, got, MPFR_RNDN);
    mpfr_div_d(off, off, std::ldexp(1.0, std::max(exponent - 53, -1074)), MPFR_RNDN);
    const double units = std::abs(mpfr_get_d(off, MPFR_RNDN));
    if (!(units <= worst)) worst = units, worst_at = a;
  }
  mpfr_clears(x, y, exact, off, nullptr);
  if (std::getenv("CCA_MATH_ARGUMENTS"))
    std::printf("%-32s %.3f at %a, %a\n", name.c_str(), worst, worst_at.x, worst_at.y);
  INFO(name << ": " << worst << " units in the last place at " << worst_at.x << ", " << worst_at.y);
  CHECK(worst <= bound);
}

#define ONE(name, bound, function, draw)                                   \
  judge(                                                                   \
      name, bound, [](const arguments& a) { return math::function(a.x); }, \
      [](mpfr_t to, mpfr_t x, mpfr_t) { mpfr_##function(to, x, MPFR_RNDN); }, draw)
#define TWO(name, bound, function, draw)                                        \
  judge(                                                                        \
      name, bound, [](const arguments& a) { return math::function(a.x, a.y); }, \
      [](mpfr_t to, mpfr_t x, mpfr_t y) { mpfr_##function(to, x, y, MPFR_RNDN); }, draw)

}  // namespace

TEST_CASE("accuracy of sin, cos, tan") {
  ONE("sin, |x| < pi", 0.8, sin, between(-3.2, 3.2));
  ONE("sin, without a branch", 0.8, sin, between(-1.6e6, 1.6e6));
  ONE("sin, near k pi / 2", 0.8, sin, near_quarters);
  ONE("sin, small", 0.8, sin, exponents(-1070, 0));
  ONE("sin, huge", 0.8, sin, exponents(20, 1023));
  ONE("sin, huge and near k pi / 2", 0.8, sin, near_far_quarters);
  ONE("cos, |x| < pi", 0.8, cos, between(-3.2, 3.2));
  ONE("cos, without a branch", 0.8, cos, between(-1.6e6, 1.6e6));
  ONE("cos, near k pi / 2", 0.8, cos, near_quarters);
  ONE("cos, huge", 0.8, cos, exponents(20, 1023));
  ONE("cos, huge and near k pi / 2", 0.8, cos, near_far_quarters);
  ONE("tan, |x| < pi", 1, tan, between(-3.2, 3.2));
  ONE("tan, without a branch", 1, tan, between(-1.6e6, 1.6e6));
  ONE("tan, near k pi / 2", 1, tan, near_quarters);
  ONE("tan, small", 1, tan, exponents(-1070, 0));
  ONE("tan, huge", 1, tan, exponents(20, 1023));
  ONE("tan, huge and near k pi / 2", 1, tan, near_far_quarters);
}
TEST_CASE("accuracy of exp, expm1, sinh, cosh, tanh") {
  ONE("exp, |x| < 1", 0.7, exp, between(-1, 1));
  ONE("exp, normal results", 0.7, exp, between(-708, 712));
  ONE("exp, subnormal results", 1, exp, between(-747, -707));
  ONE("exp, small", 0.7, exp, exponents(-1070, 0));
  ONE("expm1, |x| < 1", 0.95, expm1, between(-1, 1));
  ONE("expm1, large", 0.95, expm1, between(-100, 712));
  ONE("expm1, small", 0.95, expm1, exponents(-1070, 3));
  ONE("sinh, |x| < 2", 0.85, sinh, between(-2, 2));
  ONE("sinh, large", 0.85, sinh, between(-712, 712));
  ONE("sinh, small", 0.85, sinh, exponents(-1070, 3));
  ONE("cosh, |x| < 2", 0.95, cosh, between(-2, 2));
  ONE("cosh, large", 0.95, cosh, between(-712, 712));
  ONE("tanh, |x| < 2", 0.8, tanh, between(-2, 2));
  ONE("tanh, large", 0.8, tanh, between(-30, 30));
  ONE("tanh, small", 0.8, tanh, exponents(-1070, 6));
}
TEST_CASE("accuracy of log, pow") {
  ONE("log, 1/2 to 2", 0.9, log, between(0.5, 2));
  ONE("log, near 1", 0.85, log, between(0.999, 1.001));
  ONE("log, 0 to 10", 0.85, log, between(0, 10));
  ONE("log, all", 0.85, log, positive(-1074, 1023));
  TWO("pow, 0 to 4", 0.7, pow, between(0, 4));
  TWO("pow, all results", 1, pow, positive(-8, 8));
  TWO("pow, large and small", 1, pow, positive(-300, 300));
  TWO("pow, of about 1", 1.0, pow, about_one);
  TWO("pow, of a negative number", 0.7, pow, whole_powers);
}
TEST_CASE("accuracy of atan, atan2, asin, acos") {
  ONE("atan, |x| < 2", 0.85, atan, between(-2, 2));
  ONE("atan, where pi / 4 is split off", 0.87, atan, between(0.41, 0.6));
  ONE("atan, |x| < 20", 0.85, atan, between(-20, 20));
  ONE("atan, all", 1, atan, exponents(-1070, 1000));
  TWO("atan2, sides below 2", 0.85, atan2, between(-2, 2));
  TWO("atan2, sides of 1e-6 to 1e6", 0.85, atan2, exponents(-20, 20));
  TWO("atan2, all", 1, atan2, exponents(-1073, 1022));
  ONE("asin", 0.7, asin, between(-1, 1));
  ONE("asin, near 1", 0.7, asin, between(0.999999, 1));
  ONE("asin, small", 0.7, asin, exponents(-1070, -1));
  ONE("acos", 0.9, acos, between(-1, 1));
  ONE("acos, near 1", 0.9, acos, between(0.999999, 1));
  ONE("acos, near -1", 0.9, acos, between(-1, -0.999999));
  ONE("acos, small", 0.9, acos, exponents(-1070, -1));
}
TEST_CASE("accuracy of sqrt, cbrt, hypot, fmod") {
  ONE("sqrt", 0.5, sqrt, positive(-1074, 1023));
  ONE("cbrt, |x| < 10", 0.7, cbrt, between(-10, 10));
  ONE("cbrt, all", 0.7, cbrt, exponents(-1074, 1023));
  TWO("hypot, sides below 10", 0.6, hypot, between(-10, 10));
  TWO("hypot, sides of 1e-9 to 1e9", 0.6, hypot, exponents(-30, 30));
  TWO("hypot, all", 1, hypot, exponents(-1074, 1022));
  TWO("fmod, below 10", 0, fmod, between(-10, 10));
  TWO("fmod, 1e-9 to 1e9", 0, fmod, exponents(-30, 30));
  TWO("fmod, all", 0, fmod, exponents(-1074, 1023));
}
