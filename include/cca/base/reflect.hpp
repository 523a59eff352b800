// The only header that includes Boost.Hana: reads the fields of a struct by name, for `parameters`. It
// provides BOOST_HANA_DEFINE_STRUCT to users.
// Cost: measured in docs/parameters.md; of Hana it includes only the struct macros, tuple, pair and string.
#pragma once

#include <cca/base/compiler.hpp>

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

#include <cca/base/define_struct.hpp>

namespace cca::detail {

template <class Type> concept Reflected = boost::hana::Struct<Type>::value;

// A copy of Hana's text, which isn't `inline`: inline data that points to it can't always be linked
// (docs/compilers.md).
template <class Name>
inline constexpr auto field_name = [] {
  constexpr std::string_view name = Name::c_str();
  std::array<char, name.size() + 1> copy{};
  for (std::size_t i = 0; i < name.size(); ++i) copy[i] = name[i];
  return copy;
}();

// One field as a type: its name, its type and how to read it.
template <class Table, class Name, class Access>
struct field {
  static constexpr std::string_view name() { return {field_name<Name>.data(), field_name<Name>.size() - 1}; }
  static constexpr const auto& of(const Table& table) { return Access{}(table); }
  // Keeps the field's `const`.
  using type = std::remove_reference_t<decltype(Access{}(std::declval<Table&>()))>;
};

// Calls f(field<...>{}...), in the order of declaration.
template <Reflected Table, class F>
constexpr auto with_fields(F f) {
  return boost::hana::unpack(boost::hana::accessors<Table>(), [&](auto... pairs) {
    return f(field<Table, std::remove_cvref_t<decltype(boost::hana::first(pairs))>,
                   std::remove_cvref_t<decltype(boost::hana::second(pairs))>>{}...);
  });
}

}  // namespace cca::detail
