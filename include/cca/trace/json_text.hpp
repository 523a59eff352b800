// Text of JSON, written piece by piece into one string that keeps its memory.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <cca/base/compiler.hpp>

namespace cca::detail {

class json_text {
public:
  json_text& operator<<(std::string_view raw) { return letters.append(raw), *this; }
  json_text& operator<<(char raw) { return letters += raw, *this; }
  json_text& operator<<(std::int64_t number) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
  }
  // Nanoseconds, not negative, as microseconds with all their digits.
  json_text& add_microseconds(std::int64_t ns) {
    const auto rest = ns % 1000;
    *this << ns / 1000 << '.' << static_cast<char>('0' + rest / 100);
    return *this << static_cast<char>('0' + rest / 10 % 10) << static_cast<char>('0' + rest % 10);
  }
  // What is no ASCII becomes a question mark.
  json_text& add_quoted(std::string_view text) {
    *this << '"';
    for (const char c : text) {
      if (c == '"' || c == '\\') *this << '\\' << c;
      else *this << (c >= ' ' && c <= '~' ? c : '?');
    }
    return *this << '"';
  }
  json_text& add_member(std::string_view key, std::string_view value) {
    return add_quoted(key) << ':', add_quoted(value);
  }
  json_text& add_member(std::string_view key, std::int64_t value) {
    return add_quoted(key) << ':', *this << value;
  }

  std::string_view view() const { return letters; }
  void clear() { letters.clear(); }

private:
  std::string letters;
};

}  // namespace cca::detail
