// Numbers of a URDF file, from text and back. Only finite decimal numbers are numbers.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cca_urdf {

inline std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(blank, at)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(blank, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

inline std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return {};
  return value;
}

template <std::size_t Count>
std::optional<std::array<double, Count>> numbers_of(std::string_view text) {
  const auto words = words_of(text);
  if (words.size() != Count) return {};
  std::array<double, Count> numbers;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto n = number_of(words[i]);
    if (!n) return {};
    numbers[i] = *n;
  }
  return numbers;
}

// The shortest text that is read as the same number.
inline std::string text_of(double number) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number == 0 ? 0.0 : number).ptr;
  return {text.data(), end};
}

// Rounded, for messages.
inline std::string rounded(double number) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 4).ptr;
  return {text.data(), end};
}

template <class Numbers>
std::string list_of(const Numbers& numbers) {
  std::string text;
  for (const double n : numbers) text += (text.empty() ? "" : ", ") + text_of(n);
  return text;
}

}  // namespace cca_urdf
