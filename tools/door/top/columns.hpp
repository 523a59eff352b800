// Text in columns of a terminal: what comes from another program may be of any length, hold any byte, and be
// of characters that this terminal can't show.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cwchar>
#include <string>
#include <string_view>

#include <cca/record/mcap/printable.hpp>

namespace cca_door {

// The code point of the UTF-8 character of `size` bytes.
inline char32_t code_point(std::string_view one) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(one[i]); };
  if (one.size() == 1) return byte(0);
  char32_t code = byte(0) & (0xFFu >> (one.size() + 1));
  for (std::size_t i = 1; i < one.size(); ++i) code = code << 6 | (byte(i) & 0x3Fu);
  return code;
}

// How many columns it takes: 2 for East Asian characters, 0 for accents on the one before. Terminals agree on
// these ranges; wcwidth would depend on the locale.
inline std::size_t columns_of(char32_t c) {
  const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  if (within(0x300, 0x36F) || within(0x200B, 0x200F) || within(0x20D0, 0x20FF) || within(0xFE00, 0xFE0F))
    return 0;
  if (within(0x1100, 0x115F) || within(0x2E80, 0xA4CF) || within(0xAC00, 0xD7A3) || within(0xF900, 0xFAFF) ||
      within(0xFE30, 0xFE6F) || within(0xFF00, 0xFF60) || within(0xFFE0, 0xFFE6) ||
      within(0x1F300, 0x1FAFF) || within(0x20000, 0x3FFFD))
    return 2;
  return 1;
}

struct shown_text {
  std::string text{};
  std::size_t columns = 0;
};

// At most `most` columns of it. Control characters and bytes that are no UTF-8 become `?`; without `utf8` so
// does every character that is not ASCII.
inline shown_text shown(std::string_view text, std::size_t most, bool utf8) {
  shown_text all;
  while (!text.empty()) {
    const std::size_t size = cca::recording::detail::shown_bytes(text);
    std::string_view one = text.substr(0, std::max<std::size_t>(size, 1));
    text.remove_prefix(one.size());
    if (size == 0 || (size > 1 && !utf8)) one = "?";
    const std::size_t columns = columns_of(code_point(one));
    if (all.columns + columns > most) break;
    all.text += one;
    all.columns += columns;
  }
  return all;
}

inline std::size_t columns_of(std::string_view text, bool utf8) {
  return shown(text, text.size() * 2, utf8).columns;
}

// Exactly so many columns, blanks at the end. What is too long ends with `~`.
inline std::string left(std::string_view text, std::size_t columns, bool utf8) {
  shown_text all = shown(text, columns, utf8);
  if (columns > 0 && columns_of(text, utf8) > columns) {
    all = shown(text, columns - 1, utf8);
    all.text += '~', ++all.columns;
  }
  return all.text.append(columns - all.columns, ' ');
}
// The same, with the end of what is too long: of a path the end says more.
inline std::string end_of(std::string_view text, std::size_t columns, bool utf8) {
  if (columns_of(text, utf8) <= columns) return left(text, columns, utf8);
  while (!text.empty() && columns_of(text, utf8) + 1 > columns)
    text.remove_prefix(std::max<std::size_t>(cca::recording::detail::shown_bytes(text), 1));
  return left("~" + std::string(text), columns, utf8);
}
// At the right. A number that is cut would be another number, so what is too long is all `#`.
inline std::string right(std::string_view text, std::size_t columns, bool utf8) {
  const std::size_t size = columns_of(text, utf8);
  if (size > columns) return std::string(columns, '#');
  return std::string(columns - size, ' ') + shown(text, columns, utf8).text;
}

}  // namespace cca_door
