// The names of an enumeration, read from the compiler's own spelling, so that a file can say `terrain =
// "slope"`. Enumerators of value 0 to 31, of an `enum class` or an enum with a fixed underlying type.
#pragma once

#include <cca/base/compiler.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace cca::detail {

inline constexpr std::size_t enumerators_seen = 32;

// Without a fixed underlying type, a cast may leave the enum's range, which a constant expression forbids.
template <class Type> concept NameableEnum = std::is_enum_v<Type> && requires { Type{0}; };

template <class Enum, Enum... Values>
constexpr std::string_view spelled_values() {
  constexpr std::string_view whole = __PRETTY_FUNCTION__, before = "Values = ";
  constexpr auto from = whole.find(before) + before.size() + 1;  // after `{` or `<`
  return whole.substr(from, whole.find_last_of(">}") - from);
}

// The name of value i; empty if there is none.
template <NameableEnum Enum>
inline constexpr std::array<std::string_view, enumerators_seen> enumerators = [] {
  constexpr std::string_view all = []<std::size_t... I>(std::index_sequence<I...>) {
    return spelled_values<Enum, static_cast<Enum>(I)...>();
  }(std::make_index_sequence<enumerators_seen>{});
  std::array<std::string_view, enumerators_seen> names{};
  int depth = 0;
  std::size_t which = 0, start = 0;
  for (std::size_t i = 0; i <= all.size() && which < names.size(); ++i) {
    const char c = i < all.size() ? all[i] : ',';
    if (c == '<' || c == '(') ++depth;
    if (c == '>' || c == ')') --depth;
    if (c == ':' && depth == 0) start = i + 1;
    if (c != ',' || depth != 0) continue;
    // The compiler spells a value without a name as a cast, `(terrain)7`.
    const std::string_view name = all.substr(start, i - start);
    if (name.find(')') == name.npos) names[which] = name;
    ++which;
    start = i + 2;
  }
  return names;
}();

}  // namespace cca::detail
