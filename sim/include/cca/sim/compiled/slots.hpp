// Room for a few values, of which nothing is written until one is made.
//
//   slots<contact, 32> all;   costs nothing
//   all.make(k)               begins the value k; all[k] is it from then on
//
// For trivially destructible values, on the stack: to write those that a step doesn't need would cost more
// than a step without contacts.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>

namespace cca::sim::detail {

template <class T, std::size_t Most>
class slots {
public:
  static_assert(std::is_trivially_destructible_v<T>);

  slots() {}  // NOLINT(modernize-use-equals-default): the room stays without values

  T& make(std::size_t k) { return *::new (static_cast<void*>(&room_[k * sizeof(T)])) T; }
  T& operator[](std::size_t k) { return *std::launder(reinterpret_cast<T*>(&room_[k * sizeof(T)])); }
  const T& operator[](std::size_t k) const {
    return *std::launder(reinterpret_cast<const T*>(&room_[k * sizeof(T)]));
  }

private:
  alignas(T) std::array<std::byte, Most * sizeof(T)> room_;
};

}  // namespace cca::sim::detail
