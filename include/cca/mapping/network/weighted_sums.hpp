// The weighted sums of a layer: y = W x + b, of fixed sizes, in double or float.
//
// W stands by columns, then b. Some rows at a time, whose sums stay in registers through all columns: Eigen's
// product of a matrix and a vector loads and stores them again for every few columns, and takes some 15 %
// more instructions. `from` begins with other sums than the b behind W.
// If an input is NaN or infinite the output is NaN or any number; there is no status and no fault.
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
    constexpr int in_a_pack = 16 / static_cast<int>(sizeof(Number));
    if constexpr (Count % in_a_pack == 0) {
      packs<in_a_pack>(std::make_index_sequence<static_cast<std::size_t>(Count / in_a_pack)>{}, weights,
                       start, row, x, y);
    } else {
      using part = Eigen::Map<const Eigen::Matrix<Number, Count, 1>>;
      Eigen::Matrix<Number, Count, 1> sums = part(start + row);
      for (int j = 0; j < From; ++j) sums += x[j] * part(weights + To * j + row);
      y.template segment<Count>(row) = sums;
    }
  }

  using pack [[gnu::vector_size(16)]] = Number;

  [[gnu::always_inline]] static pack loaded(const Number* from) {
    pack p;
    std::memcpy(&p, from, sizeof p);
    return p;
  }
  // Four columns at a time: counting them one by one takes a tenth of the instructions.
  template <int Lanes, std::size_t... I, class Vector>
  [[gnu::always_inline]] static void packs(std::index_sequence<I...>,
                                           const Number* weights,
                                           const Number* start,
                                           int row,
                                           const Vector& x,
                                           output& y) {
    pack sums[sizeof...(I)] = {loaded(start + row + static_cast<int>(I) * Lanes)...};
    const Number* column = weights + row;
    const auto add = [&](const Number* of, Number by) {
      const pack all = by - pack{};  // in all lanes; by + 0 would be an addition
      ((sums[I] += all * loaded(of + static_cast<int>(I) * Lanes)), ...);
    };
    int j = 0;
    for (; j + 4 <= From; j += 4, column += 4 * To) {
      add(column, x[j]);
      add(column + To, x[j + 1]);
      add(column + 2 * To, x[j + 2]);
      add(column + 3 * To, x[j + 3]);
    }
    for (; j < From; ++j, column += To) add(column, x[j]);
    (std::memcpy(y.data() + row + static_cast<int>(I) * Lanes, &sums[I], sizeof(pack)), ...);
  }
};

}  // namespace cca::detail
