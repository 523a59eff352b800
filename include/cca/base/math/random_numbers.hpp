// Random numbers from a seed, with the same bits on every machine and from every compiler.
//
//   cca::random_numbers random(7);
//   random.bits(), random.below(6)          64 bits; a whole number from 0 to 5
//   random.uniform(), random.between(a, b)  in [0, 1); in [a, b)
//   random.normal()                         mean 0, standard deviation 1
//   random.happens(0.1)                     true once in ten
//
// A value of 8 bytes: a copy goes on as the original. Source: SplitMix64 (Steele, Lea, Flood, Fast splittable
// pseudorandom number generators, OOPSLA 2014); normal numbers after Box and Muller, A note on the generation
// of random normal deviates, 1958. Cost: ten operations; a normal number also a logarithm, a root, a cosine.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <cca/base/math/angles.hpp>
#include <cca/base/math/logarithms.hpp>
#include <cca/base/math/roots.hpp>

namespace cca {

class random_numbers {
public:
  constexpr explicit random_numbers(std::uint64_t seed = 0) : state_(seed) {}

  constexpr std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // Nearly uniform while `count` is small beside 2^64.
  constexpr std::uint64_t below(std::uint64_t count) { return bits() % count; }
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  constexpr double between(double low, double high) { return low + (high - low) * uniform(); }
  constexpr bool happens(double chance) { return uniform() < chance; }

  double normal() {
    const double far = 1 - uniform(), turn = uniform();  // far: in (0, 1]
    return math::sqrt(-2 * math::log(far)) * math::cos(2 * std::numbers::pi * turn);
  }

private:
  std::uint64_t state_;
};

}  // namespace cca
