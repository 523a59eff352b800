// The words of a benchmark program whose code is measured: these programs read few and fixed ones, so they do
// without the library that the other programs use for their command line.
#pragma once

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace bench {

// Ends the program.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse(std::string_view word, const char* expected) {
  std::fprintf(stderr, "%.*s: expected %s\n", static_cast<int>(word.size()), word.data(), expected);
  std::exit(2);
}

[[gnu::cold, gnu::noinline]] inline int beats_in(std::string_view word) {
  int beats = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), beats);
  if (error != std::errc() || end != word.data() + word.size() || beats < 1)
    refuse(word, "a number of beats, 1 or more");
  return beats;
}

}  // namespace bench
