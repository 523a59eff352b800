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

// An array that grows. Why it is a template: docs/compilers.md.
template <class T>
class growing_array {
public:
  constexpr growing_array() = default;
  growing_array(const growing_array&) = delete;
  growing_array& operator=(const growing_array&) = delete;
  constexpr ~growing_array() { delete[] all; }
  constexpr void add(const T& one) {
    if (count == room) widen();
    all[count++] = one;
  }
  constexpr int size() const { return count; }
  constexpr const T& operator[](int i) const { return all[i]; }

private:
  constexpr void widen() {
    room = room == 0 ? 16 : 2 * room;
    auto* const wider = new T[static_cast<std::size_t>(room)];
    for (int n = 0; n < count; ++n) wider[n] = all[n];
    delete[] all;
    all = wider;
  }

  T* all = nullptr;
  int count = 0, room = 0;
};

}  // namespace cca::detail
