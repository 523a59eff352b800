// The one door to Boost.Hana: a struct's fields by name, for `parameters`. Users define them with
// BOOST_HANA_DEFINE_STRUCT, so that macro is here too.
// Cost: measured in docs/parameters.md; of Hana only the struct macros with tuple, pair and string come in.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include <boost/hana/accessors.hpp>
#include <boost/hana/define_struct.hpp>
#include <boost/hana/first.hpp>
#include <boost/hana/second.hpp>
#include <boost/hana/unpack.hpp>

namespace cca::detail {

template <class Type> concept Reflected = boost::hana::Struct<Type>::value;

// A copy: Hana's own text isn't `inline`, and g++ 12 with the address sanitizer can't link inline data that
// points to it.
template <class Name>
inline constexpr auto field_name = [] {
  constexpr std::string_view name = Name::c_str();
  std::array<char, name.size() + 1> copy{};
  for (std::size_t i = 0; i < name.size(); ++i) copy[i] = name[i];
  return copy;
}();

// One field as a type: its name, its type and how to reach it.
template <class Table, class Name, class Access>
struct field {
  static constexpr std::string_view name() { return {field_name<Name>.data(), field_name<Name>.size() - 1}; }
  static constexpr const auto& of(const Table& table) { return Access{}(table); }
  // With `const` where the field has it.
  using type = std::remove_reference_t<decltype(Access{}(std::declval<Table&>()))>;
};

// f(field<...>{}...), in the order of declaration.
template <Reflected Table, class F>
constexpr auto with_fields(F f) {
  return boost::hana::unpack(boost::hana::accessors<Table>(), [&](auto... pairs) {
    return f(field<Table, std::remove_cvref_t<decltype(boost::hana::first(pairs))>,
                   std::remove_cvref_t<decltype(boost::hana::second(pairs))>>{}...);
  });
}

}  // namespace cca::detail
