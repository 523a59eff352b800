// A law of every `parameters` struct: `parameters values;` leaves no field without a value.
//
// BOOST_HANA_DEFINE_STRUCT can't give a field its initial value. So a field is of a type that begins with
// one, or the struct has a constructor.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <cca/component/parameters.hpp>

namespace laws {
namespace detail {

// Of each field the bits: what was never written may be no number, no bool and no enumerator.
inline void add_bits(const cca::detail::schema& type, const void* value, std::vector<std::byte>& bits) {
  using cca::detail::kind;
  const auto add = [&](std::size_t size) {
    const auto* from = static_cast<const std::byte*>(value);
    bits.insert(bits.end(), from, from + size);
  };
  switch (type.what) {
    case kind::number:
    case kind::boolean:
    case kind::integer:
    case kind::choice:
      return add(type.bytes);
    case kind::text:
      return add(type.count);
    case kind::array:
      for (std::size_t i = 0; i < type.count; ++i) add_bits(*type.element, type.at(value, i), bits);
      return;
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i)
        add_bits(*type.members[i].type, type.members[i].of(value), bits);
      return;
    case kind::unsupported:
      return;
  }
}

// As a declaration without an initialiser makes it, in memory that was full of `old`.
template <class Parameters>
std::vector<std::byte> bits_of_new(std::byte old) {
  alignas(Parameters) std::byte memory[sizeof(Parameters)];
  void* at = memory;
  std::memset(at, static_cast<int>(old), sizeof memory);
  // The compiler must neither drop the old bytes nor know which bits an unwritten field has.
  cca::detail::forget_content(at);
  auto* made = ::new (at) Parameters;
  cca::detail::forget_content(made);
  std::vector<std::byte> bits;
  add_bits(cca::detail::schema_of<Parameters>, made, bits);
  std::destroy_at(made);
  return bits;
}

}  // namespace detail

template <class Parameters>
void begins_with_values() {
  const auto one = detail::bits_of_new<Parameters>(std::byte{0xFF});
  const auto other = detail::bits_of_new<Parameters>(std::byte{0x55});
  CHECK_MESSAGE(one == other, "a field of `parameters values;` has no value");
}

}  // namespace laws
