// A list in words that does not grow with what it lists.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cca::detail {

// "hip, knee", and of more than `most` words the first ones: "a0, a1 and 32 more". `word_of(i)` is called in
// order, once for each word that is shown.
template <class WordOf>
std::string first_words(std::size_t count, std::size_t most, std::string_view between, WordOf word_of) {
  std::string all;
  for (std::size_t i = 0; i < count && i < most; ++i) {
    if (i > 0) all += between;
    all += word_of(i);
  }
  if (count > most) all += " and " + std::to_string(count - most) + " more";
  return all;
}

}  // namespace cca::detail
