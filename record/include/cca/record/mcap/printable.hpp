// Bytes of a file, as a message shows them: a damaged file may hold any, and a terminal obeys control bytes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace cca::recording::detail {

// Bytes of the UTF-8 character at the beginning; 0: there is none, or it controls a terminal.
inline std::size_t shown_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return byte(0) >= 0x20 && byte(0) != 0x7F;
  const std::size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  return byte(0) == 0xC2 && byte(1) < 0xA0 ? 0 : size;
}

// The first bytes, `most` of them: a byte that is not UTF-8, or that controls a terminal, becomes "\x1b".
inline std::string printable(std::string_view text, std::size_t most = std::string_view::npos) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string all;
  text = text.substr(0, most);
  while (!text.empty()) {
    const std::size_t size = shown_bytes(text);
    if (size > 0) all += text.substr(0, size);
    else {
      const auto byte = static_cast<unsigned char>(text.front());
      all.append("\\x").append(1, digits[byte >> 4]).append(1, digits[byte & 15]);
    }
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return all;
}

}  // namespace cca::recording::detail
