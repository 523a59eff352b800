// Arrays for the time of a constant evaluation.
#pragma once

#include <cstddef>

#include <cca/base/compiler.hpp>

namespace cca::detail {

template <class Number>
class scratch_of {
public:
  explicit constexpr scratch_of(int size, Number fill = {})
      : numbers(new Number[static_cast<std::size_t>(size) + 1]) {
    for (int i = 0; i <= size; ++i) numbers[i] = fill;
  }
  scratch_of(const scratch_of&) = delete;
  scratch_of& operator=(const scratch_of&) = delete;
  constexpr ~scratch_of() { delete[] numbers; }
  constexpr Number& operator[](int i) { return numbers[i]; }
  constexpr Number operator[](int i) const { return numbers[i]; }

private:
  Number* numbers;
};
using scratch = scratch_of<int>;

}  // namespace cca::detail
