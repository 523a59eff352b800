// One elementary function of cca::math or of the C library, over and over: valgrind counts what a call takes.
//
//   bench_elementary sin|c_sin|... ROUNDS     rounds of 1,024 calls
//
// elementary.sh counts all of them (docs/math.md).
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <cca/base/math.hpp>

namespace {

constexpr int calls = 1024;
struct numbers {
  std::array<double, calls> x{}, y{}, result{};
} all{};

template <class Function>
[[gnu::noinline]] void run(Function function, int rounds) {
  for (int r = 0; r < rounds; ++r) {
    for (int i = 0; i < calls; ++i) all.result[i] = function(all.x[i], all.y[i]);
    asm volatile("" ::: "memory");
  }
}

// Arguments that a controller has: angles, sides of ratios, positive numbers.
double argument(std::string_view function, int i) {
  const double x = -1 + 2.0 * i / calls;
  for (const std::string_view positive : {"log", "pow", "sqrt"})
    if (function == positive) return 1e-3 + 3 * std::abs(x);
  return function == "asin" || function == "acos" ? x : 3.1 * x;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3 || std::atoi(words[2]) < 1)
    return std::fprintf(stderr, "usage: bench_elementary FUNCTION ROUNDS\n"), 2;
  const std::string_view wanted = words[1];
  const bool is_c = wanted.starts_with("c_");
  const std::string_view name = is_c ? wanted.substr(2) : wanted;
  const int rounds = std::atoi(words[2]);
  for (int i = 0; i < calls; ++i) all.x[i] = argument(name, i), all.y[i] = 1 + 0.001 * i;

  bool is_known = false;
#define ONE(f)                                                          \
  if (name == #f) {                                                     \
    is_known = true;                                                    \
    if (is_c) run([](double x, double) { return std::f(x); }, rounds);  \
    else run([](double x, double) { return cca::math::f(x); }, rounds); \
  }
#define TWO(f)                                                               \
  if (name == #f) {                                                          \
    is_known = true;                                                         \
    if (is_c) run([](double x, double y) { return std::f(x, y); }, rounds);  \
    else run([](double x, double y) { return cca::math::f(x, y); }, rounds); \
  }
  ONE(sin)
  ONE(cos)
  ONE(tan)
  ONE(asin)
  ONE(acos)
  ONE(atan)
  ONE(exp)
  ONE(expm1)
  ONE(log)
  ONE(sinh)
  ONE(cosh)
  ONE(tanh)
  ONE(cbrt)
  ONE(sqrt)
  ONE(floor)
  ONE(round)
  TWO(atan2)
  TWO(pow)
  TWO(hypot)
  TWO(fmod)
  if (name == "sine_and_cosine") {
    is_known = true;
    if (is_c) {
      run(
          [](double x, double) {
            double sine = 0, cosine = 0;
            ::sincos(x, &sine, &cosine);
            return sine + cosine;
          },
          rounds);
    } else {
      run(
          [](double x, double) {
            const auto both = cca::math::sine_and_cosine(x);
            return both.sine + both.cosine;
          },
          rounds);
    }
  }
  return is_known ? 0 : (std::fprintf(stderr, "there is no function %s\n", words[1]), 2);
}
