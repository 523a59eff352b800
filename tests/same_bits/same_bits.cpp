// Prints a hash of the bits of many results of each elementary function, and one of all of them. Each
// compiler, level of optimisation and machine must print the same (hashes.txt). Lanes must give what doubles
// give: else it ends with 1. Arguments are drawn with integers, so they are the same everywhere.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <cca/base/math.hpp>

namespace {

namespace math = cca::math;
using lanes = double __attribute__((vector_size(32)));
constexpr int count = 20000;  // a multiple of the lanes

struct draw {
  std::uint64_t state;
  std::uint64_t bits() {  // xorshift
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state;
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  // In turn: of usual size, larger, any bits at all. The last bits of a small one would be zeros.
  double argument(int i, double usual) {
    if (i % 8 == 7) return std::bit_cast<double>(bits());
    const double x = (unit() - 0.5) * 2 * usual;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(i % 8 == 6 ? x * 1000 : x) ^
                                 (bits() & 0xffffff));
  }
};

struct hash {
  std::uint64_t value = 0x9e3779b97f4a7c15;
  void add(double x) {
    value = (value ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
    value ^= value >> 29;
  }
};

bool lanes_agree = true;
hash whole{};

template <class Function>
void judge(const char* name, double usual, Function function) {
  draw from{88172645463325252u};
  hash all{};
  for (int i = 0; i < count; i += 4) {
    lanes x{}, y{};
    for (int k = 0; k < 4; ++k) x[k] = from.argument(i + k, usual), y[k] = from.argument(i / 4 + k, usual);
    const lanes together = function(x, y);
    for (int k = 0; k < 4; ++k) {
      const double alone = function(double(x[k]), double(y[k]));
      all.add(alone), whole.add(alone);
      if (std::bit_cast<std::uint64_t>(alone) != std::bit_cast<std::uint64_t>(double(together[k]))) {
        lanes_agree = false;
        std::printf("%s(%a, %a): %a alone, %a beside others\n", name, double(x[k]), double(y[k]), alone,
                    double(together[k]));
      }
    }
  }
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(all.value));
}

}  // namespace

int main() {
#define JUDGE(f, usual) judge(#f, usual, [](auto x, auto) { return math::f(x); })
#define JUDGE_2(f, usual) judge(#f, usual, [](auto x, auto y) { return math::f(x, y); })
  JUDGE(sin, 4);
  JUDGE(cos, 4);
  JUDGE(tan, 4);
  JUDGE(exp, 3);
  JUDGE(expm1, 3);
  JUDGE(sinh, 3);
  JUDGE(cosh, 3);
  JUDGE(tanh, 3);
  JUDGE(log, 8);
  JUDGE(atan, 4);
  JUDGE(asin, 1);
  JUDGE(acos, 1);
  JUDGE(sqrt, 9);
  JUDGE(cbrt, 9);
  JUDGE(trunc, 9);
  JUDGE(floor, 9);
  JUDGE(ceil, 9);
  JUDGE(round, 9);
  JUDGE_2(pow, 6);
  JUDGE_2(atan2, 3);
  JUDGE_2(hypot, 5);
  JUDGE_2(fmod, 5);
  std::printf("all %016llx\n", static_cast<unsigned long long>(whole.value));
  return lanes_agree ? 0 : 1;
}
