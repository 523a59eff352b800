// A queue of fixed size. Cost: its elements; nothing is allocated.
#pragma once

#include <array>
#include <cstddef>

namespace cca::hardware::detail {

template <class Type, std::size_t Capacity>
class ring {
public:
  constexpr bool empty() const { return count == 0; }
  constexpr bool full() const { return count == Capacity; }
  constexpr std::size_t size() const { return count; }
  constexpr const Type& front() const { return items[first]; }
  constexpr void clear() { count = 0; }

  constexpr bool push(const Type& item) {
    if (full()) return false;
    items[(first + count++) % Capacity] = item;
    return true;
  }
  constexpr void pop() {
    first = (first + 1) % Capacity;
    --count;
  }

private:
  std::array<Type, Capacity> items{};
  std::size_t first = 0, count = 0;
};

}  // namespace cca::hardware::detail
