// Writes JSON into a string: for the few texts that a program gives to its page.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace cca::page {

class json_text {
public:
  std::string text;

  json_text& open(char bracket) {
    separate();
    text += bracket;
    is_first = true;
    return *this;
  }
  json_text& close(char bracket) {
    text += bracket;
    is_first = false;
    return *this;
  }
  json_text& key(std::string_view name) {
    add(name);
    text += ':';
    is_first = true;
    return *this;
  }
  json_text& add(std::string_view value) {
    separate();
    text += '"';
    for (const char c : value) {
      if (c == '"' || c == '\\') text += '\\';
      if (static_cast<unsigned char>(c) >= 0x20) text += c;
    }
    text += '"';
    return *this;
  }
  json_text& add(const char* value) { return add(std::string_view(value)); }
  json_text& add(bool value) { return add_raw(value ? "true" : "false"); }
  json_text& add(std::int64_t value) { return add_raw(std::to_string(value)); }
  json_text& add(int value) { return add(std::int64_t{value}); }
  // JSON has no infinity.
  json_text& add(double value) {
    if (!std::isfinite(value)) return add_raw("null");
    char digits[32];
    return add_raw({digits, std::to_chars(digits, digits + sizeof digits, value).ptr});
  }

private:
  json_text& add_raw(std::string_view value) {
    separate();
    text += value;
    return *this;
  }
  void separate() {
    if (!is_first) text += ',';
    is_first = false;
  }

  bool is_first = true;
};

}  // namespace cca::page
