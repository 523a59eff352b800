// The weighted sums of a layer: y = W x + b, of fixed sizes, in double or float.
//
// W stands by columns, then b. Some rows at a time, whose sums stay in registers through all columns: Eigen's
// product of a matrix and a vector loads and stores them again for every few columns, and takes some 15 %
// more instructions. `from` begins with other sums than the b behind W.
//
// In float, the products of eight columns are added to each other in pairs, and then to the sum: as many
// additions as one after the other, and in layers of 512 half of the rounding errors or less
// (docs/policies.md). In double one after the other: there nothing is lost that matters, and trained policies
// keep their bits. Plain arithmetic in a fixed order: every machine gives the same. If an input is NaN or
// infinite the output is NaN or any number; there is no status and no fault.
#pragma once

#include <cstddef>
#include <cstring>
#include <utility>

#include <cca/base/eigen.hpp>

namespace cca::detail {

template <class Number, int From, int To>
struct weighted_sums {
  static constexpr int wide = 128 / sizeof(Number);
  using output = Eigen::Matrix<Number, To, 1>;

  template <class Vector>
  [[gnu::always_inline]] static output of(const Number* weights, const Vector& x) {
    return from(weights, weights + To * From, x);
  }
  // The rows begin at those of `start`: a bias, or sums that another matrix began.
  template <class Vector>
  [[gnu::always_inline]] static output from(const Number* weights, const Number* start, const Vector& x) {
    output y;
    int row = 0;
    for (; row + wide <= To; row += wide) rows<wide>(weights, start, row, x, y);
    if constexpr (To % wide != 0) rows<To % wide>(weights, start, row, x, y);
    return y;
  }

private:
  template <int Count, class Vector>
  [[gnu::always_inline]] static void rows(
      const Number* weights, const Number* start, int row, const Vector& x, output& y) {
    constexpr int in_a_pack = 16 / static_cast<int>(sizeof(Number)), rest = Count % in_a_pack;
    if constexpr (Count >= in_a_pack)
      sums<pack>(std::make_integer_sequence<int, Count / in_a_pack>(), weights, start, row, x, y);
    if constexpr (rest > 0)
      sums<Number>(std::make_integer_sequence<int, rest>(), weights, start, row + Count - rest, x, y);
  }

  using pack [[gnu::vector_size(16)]] = Number;

  template <class Part>
  [[gnu::always_inline]] static Part loaded(const Number* from) {
    Part p;
    std::memcpy(&p, from, sizeof p);
    return p;
  }
  // The products of some columns, the sum of one half and that of the other.
  template <int First, int Columns, class Part>
  [[gnu::always_inline]] static Part products(const Part* by, const Number* column) {
    if constexpr (Columns == 1) return by[First] * loaded<Part>(column + First * To);
    else
      return products<First, Columns / 2>(by, column) +
             products<First + Columns / 2, Columns / 2>(by, column);
  }
  // Some columns at a time: counting them one by one takes a tenth of the instructions.
  template <class Part, int... I, class Vector>
  [[gnu::always_inline]] static void sums(std::integer_sequence<int, I...>,
                                          const Number* weights,
                                          const Number* start,
                                          int row,
                                          const Vector& x,
                                          output& y) {
    constexpr int in_a_part = sizeof(Part) / sizeof(Number);
    Part all[sizeof...(I)] = {loaded<Part>(start + row + I * in_a_part)...};
    const Number* column = weights + row;
    int j = 0;
    // `first`: of the columns from j on. always_inline: calls otherwise (docs/compilers.md).
    const auto add = [&]<int... C>(int first,
                                   std::integer_sequence<int, C...>) __attribute__((always_inline)) {
      const Part by[] = {x[j + first + C] - Part{}...};  // in all lanes; x + 0 would be an addition
      ((all[I] += products<0, static_cast<int>(sizeof...(C))>(by, column + first * To + I * in_a_part)), ...);
    };
    constexpr std::integer_sequence<int, 0> one;
    if constexpr (sizeof(Number) == sizeof(float)) {
      for (; j + 8 <= From; j += 8, column += 8 * To) add(0, std::make_integer_sequence<int, 8>());
    } else {
      for (; j + 4 <= From; j += 4, column += 4 * To) {
        add(0, one);
        add(1, one);
        add(2, one);
        add(3, one);
      }
    }
    for (; j < From; ++j, column += To) add(0, one);
    (std::memcpy(y.data() + row + I * in_a_part, &all[I], sizeof(Part)), ...);
  }
};

}  // namespace cca::detail
