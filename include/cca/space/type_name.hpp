// The name of a type as the user wrote it, for messages and pictures: `leg_angles`, `cartesian_position<hip_frame>`.
#pragma once

#include <string_view>

namespace cca::detail {

template <class Type>
constexpr std::string_view spelled() {
#if defined(__clang__)
  constexpr std::string_view whole = __PRETTY_FUNCTION__, before = "[Type = ";
  constexpr auto from = whole.find(before) + before.size();
  return whole.substr(from, whole.size() - from - 1);
#else
  constexpr std::string_view whole = __PRETTY_FUNCTION__, before = "[with Type = ";
  constexpr auto from = whole.find(before) + before.size();
  constexpr auto semicolon = whole.find("; std::string_view", from);
  return whole.substr(from, (semicolon == whole.npos ? whole.size() - 1 : semicolon) - from);
#endif
}

// Without its namespaces: what stands after the last `::` outside of angle brackets.
template <class Type>
constexpr std::string_view type_name() {
  constexpr std::string_view whole = spelled<Type>();
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole[i] == '<' || whole[i] == '(') ++depth;
    if (whole[i] == '>' || whole[i] == ')') --depth;
    if (depth == 0 && whole[i] == ':') start = i + 1;
  }
  return whole.substr(start);
}

}  // namespace cca::detail
