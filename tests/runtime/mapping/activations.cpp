// The activations of networks, in float and double, beside the C library's functions in long double.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <doctest/doctest.h>

#include <cca/mapping/network/activations.hpp>

namespace {

namespace neural = cca::neural;
constexpr int size = 7;  // a pack and a rest, in float and in double

// Numbers of all sizes that a network has, from the upper bits of a generator.
struct numbers_of_all_sizes {
  std::uint64_t bits = 1;
  double unit() {  // -1 to 1
    bits = bits * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(static_cast<std::int64_t>(bits)) * 0x1p-63;
  }
  double next(int kind) {
    const double x = unit();
    switch (kind % 6) {
      case 0:
        return x;
      case 1:
        return 2 * x;
      case 2:
        return 20 * x;
      case 3:
        return 87 * x;
      case 4:
        return std::ldexp(x, static_cast<int>(40 * unit()));
      default:
        return std::ldexp(x, static_cast<int>(60 * unit()) - 60);
    }
  }
};

struct worst {
  double absolute = 0, relative = 0;
  void add(double made, long double wanted) {
    const auto off = static_cast<double>(std::abs(made - wanted));
    if (!(off <= absolute)) absolute = off;  // NaN too
    if (std::abs(wanted) < 1.2e-38L) return;
    if (const auto part = static_cast<double>(off / std::abs(wanted)); !(part <= relative)) relative = part;
  }
};

template <class Number>
struct errors {
  worst sigmoid, silu, below, elu, tangent, softmax;
  bool is_odd = true;
  std::uint64_t bits = 14695981039346656037u;

  void add(const neural::numbers<Number, size>& x) {
    const auto s = neural::sigmoid(x), w = neural::silu(x), e = neural::elu(x, 1), t = neural::tangent(x),
               back = neural::tangent(neural::numbers<Number, size>(-x));
    is_odd = is_odd && t == neural::numbers<Number, size>(-back);
    for (int i = 0; i < size; ++i) {
      const long double at = x[i], over = 1 + std::exp(-at);
      if (at < -87) {
        below.add(static_cast<double>(w[i]), at / over);
        below.add(static_cast<double>(s[i]), 1 / over);
      } else {
        sigmoid.add(static_cast<double>(s[i]), 1 / over);
        silu.add(static_cast<double>(w[i]), at / over);
      }
      elu.add(static_cast<double>(e[i]), at > 0 ? at : std::expm1(at));
      tangent.add(static_cast<double>(t[i]), std::tanh(at));
      for (const Number one : {s[i], w[i], e[i], t[i]}) {
        std::array<unsigned char, sizeof one> bytes;
        std::memcpy(bytes.data(), &one, sizeof one);
        for (const unsigned char byte : bytes) bits = (bits ^ byte) * 1099511628211u;
      }
    }
    const auto y = neural::softmax(x);
    std::array<long double, size> parts;
    long double sum = 0;
    for (int i = 0; i < size; ++i)
      sum += parts[static_cast<std::size_t>(i)] =
          std::exp(static_cast<long double>(x[i]) - static_cast<long double>(x.maxCoeff()));
    for (int i = 0; i < size; ++i)
      softmax.add(static_cast<double>(y[i]), parts[static_cast<std::size_t>(i)] / sum);
  }
};

template <class Number>
errors<Number> all_errors() {
  errors<Number> all;
  const auto inputs = [](auto... x) {
    return neural::numbers<Number, size>(std::array{static_cast<Number>(x)...}.data());
  };
  all.add(inputs(0.0, -0.0, 1e12, -1e12, 87, -87, -87.01));
  all.add(inputs(40, 40.01, -40, -40.01, 20, -20, 1e-38));
  all.add(inputs(std::numeric_limits<Number>::denorm_min(), std::numeric_limits<Number>::min(),
                 -std::numeric_limits<Number>::denorm_min(), -1e-38, 0x1.62e42fefa39efp-2,
                 -0x1.62e42fefa39efp-2, 1));
  numbers_of_all_sizes draw;
  for (int k = 0; k < 1'000'000 / size; ++k) {
    neural::numbers<Number, size> x;
    for (int i = 0; i < size; ++i) x[i] = static_cast<Number>(draw.next(size * k + i));
    all.add(x);
  }
  return all;
}

}  // namespace

// The figures of activations.hpp.
TEST_CASE("activations of a million numbers are as exact as they say, and the same bits everywhere") {
  const auto in_float = all_errors<float>();
  CHECK(in_float.sigmoid.relative < 1.8e-7);
  CHECK(in_float.silu.relative < 2.2e-7);
  CHECK(in_float.elu.relative < 9.2e-8);
  CHECK(in_float.tangent.relative < 1.8e-7);
  CHECK(in_float.softmax.absolute < 3e-7);
  CHECK(in_float.below.absolute < 2e-26);
  CHECK(in_float.is_odd);
  CHECK(in_float.bits == 17392113005262083128u);
  const auto in_double = all_errors<double>();
  CHECK(in_double.sigmoid.relative < 4e-12);
  CHECK(in_double.silu.relative < 4e-12);
  CHECK(in_double.elu.relative < 1e-11);
  CHECK(in_double.tangent.relative < 1.2e-11);
  CHECK(in_double.softmax.absolute < 1e-12);
  CHECK(in_double.below.absolute < 2e-26);
  CHECK(in_double.is_odd);
  CHECK(in_double.bits == 13122036548505809505u);
}

TEST_CASE("activations of NaN and infinity do no harm") {
  for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    const neural::numbers<float, 3> x(odd, 1, -1);
    for (const auto& y : {neural::sigmoid(x), neural::silu(x), neural::elu(x, 1), neural::tangent(x)}) {
      CHECK(std::isfinite(y[1]));
      CHECK(std::isfinite(y[2]));
    }
  }
  const neural::numbers<double, 2> ends(-std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::infinity());
  CHECK(neural::sigmoid(ends)[0] < 2e-38);
  CHECK(neural::sigmoid(ends)[1] == 1);
  CHECK(neural::tangent(ends)[0] == -1);
  CHECK(neural::tangent(ends)[1] == 1);
  CHECK(neural::elu(ends, 1)[0] == -1);
}
