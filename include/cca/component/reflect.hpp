// The one door to Boost.Hana: a struct's fields by name, for `parameters`. Users define them with
// BOOST_HANA_DEFINE_STRUCT, so that macro is here too.
// Cost: measured in docs/parameters.md; of Hana only the struct macros with tuple, pair and string come in.
#pragma once

#include <type_traits>
#include <utility>

#include <boost/hana/accessors.hpp>
#include <boost/hana/define_struct.hpp>
#include <boost/hana/first.hpp>
#include <boost/hana/second.hpp>
#include <boost/hana/unpack.hpp>

namespace cca::detail {

template <class Type>
concept Reflected = boost::hana::Struct<Type>::value;

// One field as a type: its name, its type and how to reach it.
template <class Table, class Name, class Access>
struct field {
  static constexpr const char* name() { return Name::c_str(); }
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
