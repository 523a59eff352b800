// The end of a message about a name that doesn't exist: the name that the user probably meant, or those that
// there are.
#pragma once

#include <cstddef>
#include <string_view>

#include <cca/base/nearest.hpp>

namespace cca::detail {

// "; did you mean `hip`?", or ": it has `hip`, `knee`".
template <class Names>
constexpr void tell_names(auto& m, std::string_view wrong, const Names& names) {
  if (const std::string_view near = nearest_name(wrong, names); !near.empty()) {
    m << "; did you mean `" << near << "`?";
    return;
  }
  constexpr std::size_t most = 12;
  std::size_t count = 0;
  for (const std::string_view name : names) {
    if (count == most) m << ", ...";
    if (count < most) m << (count == 0 ? ": it has `" : ", `") << name << "`";
    ++count;
  }
  if (count == 0) m << ": it has none";
}

}  // namespace cca::detail
