// The name of a type as the user wrote it, for messages and pictures: `leg_angles`, `cartesian_position<hip_frame>`.
#pragma once

#include <string_view>

namespace cca::detail {

template <class Type>
constexpr std::string_view signature_with() {
  return __PRETTY_FUNCTION__;
}

// What stands before and after the type is the same for each.
inline constexpr auto before_type = signature_with<double>().find("double");
inline constexpr auto around_type = signature_with<double>().size() - std::string_view("double").size();

template <class Type>
constexpr std::string_view spelled() {
  constexpr std::string_view whole = signature_with<Type>();
  return {whole.data() + before_type, whole.size() - around_type};
}

// Without its namespaces: what stands after the last `::` outside of angle brackets.
constexpr std::string_view without_namespaces(std::string_view whole) {
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole[i] == '<' || whole[i] == '(') ++depth;
    if (whole[i] == '>' || whole[i] == ')') --depth;
    if (depth == 0 && whole[i] == ':') start = i + 1;
  }
  return whole.substr(start);
}

template <class Type>
constexpr std::string_view type_name() { return without_namespaces(spelled<Type>()); }

}  // namespace cca::detail
