// Several worlds of one robot side by side, each in a lane of a vector: `compiled_world<R,
// cca::sim::lanes<4>>`.
//
//   4    AVX2 (-mavx2); 8: AVX-512 (-mavx512f). With another number, or without these, it works, but slower
//
// Each lane ends with the bits of a world alone, as long as nothing fuses products and sums
// (-ffp-contract=off): what a lane does not need any more is computed and not taken. A lane is x[k].
#pragma once

#include <cca/base/compiler.hpp>
#include <cca/base/math/angles.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/sim/compiled/scalar.hpp>

namespace cca::sim {

// What holds in which lane.
template <int N>
struct mask_of_lanes {
  using vector = typename cca::detail::some_lanes<N>::mask;
  vector v;  // -1 where it holds, else 0

  friend mask_of_lanes operator&(mask_of_lanes a, mask_of_lanes b) { return {a.v & b.v}; }
  friend mask_of_lanes operator|(mask_of_lanes a, mask_of_lanes b) { return {a.v | b.v}; }
  friend mask_of_lanes operator!(mask_of_lanes a) { return {~a.v}; }
  friend bool everywhere(mask_of_lanes a) { return math::detail::everywhere(a.v); }
};

template <int N>
struct lanes {
  using vector = typename cca::detail::some_lanes<N>::vector;
  using mask = mask_of_lanes<N>;
  static constexpr int count = N;
  vector v;  // without a value, like a double

  constexpr lanes() = default;
  constexpr lanes(double x) : v(vector{} + x) {}  // in all lanes; -0 becomes 0
  constexpr explicit lanes(const vector& x) : v(x) {}

  double operator[](int k) const { return v[k]; }
  void set(int k, double x) { v[k] = x; }

  lanes operator-() const { return lanes(-v); }
  friend lanes operator+(const lanes& a, const lanes& b) { return lanes(a.v + b.v); }
  friend lanes operator-(const lanes& a, const lanes& b) { return lanes(a.v - b.v); }
  friend lanes operator*(const lanes& a, const lanes& b) { return lanes(a.v * b.v); }
  friend lanes operator/(const lanes& a, const lanes& b) { return lanes(a.v / b.v); }
  friend mask operator<(const lanes& a, const lanes& b) { return {a.v < b.v}; }
  friend mask operator>(const lanes& a, const lanes& b) { return {a.v > b.v}; }
  friend mask operator<=(const lanes& a, const lanes& b) { return {a.v <= b.v}; }
  friend mask operator==(const lanes& a, const lanes& b) { return {a.v == b.v}; }
  friend lanes select(const mask& m, const lanes& yes, const lanes& no) { return lanes(m.v ? yes.v : no.v); }
  friend lanes root(const lanes& x) { return lanes(math::sqrt(x.v)); }
  friend auto sine_and_cosine(const lanes& x) {
    const auto of = math::sine_and_cosine(x.v);
    struct {
      lanes sine, cosine;
    } both{lanes(of.sine), lanes(of.cosine)};
    return both;
  }
};

namespace detail {
template <int N>
inline constexpr bool is_in_lanes<lanes<N>> = true;
}

}  // namespace cca::sim
