// A string that can be a template argument: the names of nodes, ports and axes are part of types.
#pragma once

#include <cca/base/compiler.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cca {

template <std::size_t Size>
struct fixed_string {
  char text[Size]{};

  consteval fixed_string(const char (&literal)[Size]) {
    for (std::size_t i = 0; i < Size; ++i) text[i] = literal[i];
  }

  constexpr std::string_view view() const { return {text, Size - 1}; }
  constexpr operator std::string_view() const { return view(); }
};

namespace detail {

// FNV-1a. The hash of a path continues that of its scope, so nested paths need no strings.
constexpr std::uint64_t hash(std::string_view text, std::uint64_t seed = 14695981039346656037ull) {
  const char* letter = text.data();
  for (const char* end = letter + text.size(); letter != end; ++letter)
    seed = (seed ^ static_cast<unsigned char>(*letter)) * 1099511628211ull;
  return seed;
}
constexpr std::uint64_t after_dot(std::uint64_t seed) {
  return (seed ^ static_cast<unsigned char>('.')) * 1099511628211ull;
}

}  // namespace detail
}  // namespace cca
