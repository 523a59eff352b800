// The name of a type as the user wrote it, for messages and pictures: `leg_angles`,
// `cartesian_position<hip_frame>`.
#pragma once

#include <cca/base/compiler.hpp>

#include <array>
#include <string_view>

namespace cca::detail {

template <class Type>
constexpr std::string_view signature_with() {
  return __PRETTY_FUNCTION__;
}

// The text before and after the type has the same length for every type.
inline constexpr auto before_type = signature_with<double>().find("double");
inline constexpr auto around_type = signature_with<double>().size() - std::string_view("double").size();

template <class Type>
constexpr std::string_view spelled() {
  constexpr std::string_view whole = signature_with<Type>();
  return {whole.data() + before_type, whole.size() - around_type};
}

// The part after the last `::` that is outside of angle brackets.
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

// Drops namespaces inside of angle brackets too: `leg<a::hip, (anonymous namespace)::knee>` becomes
// `leg<hip, knee>`. And the space in `pose<frame<1> >`, which not every compiler writes: programs of both
// must have one name for a space.
template <std::size_t Size>
struct tidy_name {
  std::array<char, Size> letters{};
  std::size_t size = 0;

  constexpr explicit tidy_name(std::string_view name) {
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (name.substr(i).starts_with("::")) {
        size = start_of_last_word();
        ++i;
      } else if (!(name.substr(i).starts_with(" >") && size > 0 && letters[size - 1] == '>')) {
        letters[size++] = name[i];
      }
    }
  }
  constexpr std::string_view view() const { return {letters.data(), size}; }

private:
  // Brackets and their content belong to the word.
  constexpr std::size_t start_of_last_word() const {
    std::size_t at = size;
    for (int depth = 0; at > 0; --at) {
      const char c = letters[at - 1];
      if (c == '>' || c == ')' || c == '}') ++depth;
      else if (depth == 0 &&
               (c == '<' || c == '(' || c == '{' || c == ',' || c == ' ' || c == '&' || c == '*'))
        break;
      else if (c == '<' || c == '(' || c == '{') --depth;
    }
    return at;
  }
};
template <class Type>
inline constexpr tidy_name<spelled<Type>().size()> tidied{without_namespaces(spelled<Type>())};

template <class Type>
constexpr std::string_view type_name() {
  constexpr std::string_view name = without_namespaces(spelled<Type>());
  if constexpr (name.find("::") == name.npos && name.find("> >") == name.npos) return name;
  else return tidied<Type>.view();
}

}  // namespace cca::detail
