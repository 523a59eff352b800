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

// These functions read letters through pointers: each name is a constant, and evaluating the functions of
// std::string_view for each letter took two of the seventy seconds of examples/touch/touch.cpp.

// The part after the last `::` that is outside of angle brackets.
constexpr std::string_view without_namespaces(std::string_view whole) {
  const char* const letters = whole.data();
  const std::size_t count = whole.size();
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const char c = letters[i];
    if (c == '<' || c == '(') ++depth;
    else if (c == '>' || c == ')') --depth;
    else if (c == ':' && depth == 0) start = i + 1;
  }
  return {letters + start, count - start};
}

// Is there a `::` or a `> >` in it?
constexpr bool is_untidy(std::string_view name) {
  const char* const letters = name.data();
  const std::size_t count = name.size();
  for (std::size_t i = 1; i < count; ++i) {
    if (letters[i] == ':' && letters[i - 1] == ':') return true;
    if (letters[i] == '>' && letters[i - 1] == ' ' && i > 1 && letters[i - 2] == '>') return true;
  }
  return false;
}

// Drops namespaces inside of angle brackets too: `leg<a::hip, (anonymous namespace)::knee>` becomes
// `leg<hip, knee>`. And the space in `pose<frame<1> >`, which not every compiler writes: programs of both
// must have one name for a space.
template <std::size_t Size>
struct tidy_name {
  std::array<char, Size> letters{};
  std::size_t size = 0;

  constexpr explicit tidy_name(std::string_view name) {
    const char* const from = name.data();
    char* const to = letters.data();
    const std::size_t count = name.size();
    std::size_t end = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const char c = from[i], next = i + 1 < count ? from[i + 1] : ' ';
      if (c == ':' && next == ':') {
        end = start_of_last_word(to, end);
        ++i;
      } else if (!(c == ' ' && next == '>' && end > 0 && to[end - 1] == '>')) {
        to[end++] = c;
      }
    }
    size = end;
  }
  constexpr std::string_view view() const { return {letters.data(), size}; }

private:
  // Brackets and their content belong to the word.
  static constexpr std::size_t start_of_last_word(const char* text, std::size_t at) {
    for (int depth = 0; at > 0; --at) {
      const char c = text[at - 1];
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
  if constexpr (!is_untidy(name)) return name;
  else return tidied<Type>.view();
}

}  // namespace cca::detail
