// The discrete Fourier transform of a record: its samples with as many zeros after them as make a power of
// two.
//
//   Y(k) = sum over n of y(n) e^(-2 pi i k n / M)
//
// Radix 2, in place. Source: Cooley and Tukey, An Algorithm for the Machine Calculation of Complex Fourier
// Series, 1965. Cost: M log2 M operations.
#pragma once

#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <cca/base/math.hpp>

namespace cca::detail {

inline std::vector<std::complex<double>> spectrum_of(std::span<const double> samples) {
  std::size_t size = 1;
  while (size < samples.size()) size *= 2;
  std::vector<std::complex<double>> all(size);
  for (std::size_t n = 0; n < samples.size(); ++n) all[n] = samples[n];
  for (std::size_t n = 1, other = 0; n < size; ++n) {  // the order of reversed bits
    std::size_t bit = size >> 1;
    for (; other & bit; bit >>= 1) other ^= bit;
    other ^= bit;
    if (n < other) std::swap(all[n], all[other]);
  }
  std::vector<std::complex<double>> turns(size / 2);
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const double angle = -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size);
    turns[k] = {math::cos(angle), math::sin(angle)};
  }
  for (std::size_t half = 1; half < size; half *= 2)
    for (std::size_t from = 0; from < size; from += 2 * half)
      for (std::size_t k = 0; k < half; ++k) {
        const std::complex<double> odd = all[from + half + k] * turns[k * (size / (2 * half))];
        const std::complex<double> even = all[from + k];
        all[from + k] = even + odd;
        all[from + half + k] = even - odd;
      }
  return all;
}

}  // namespace cca::detail
