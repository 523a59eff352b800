// Refuses texts of TOML that toml++ itself (3.3) does not get through:
//
// - Deep nesting. It reads, visits and destroys nested tables by recursion, and `a.a.a.a = 1` nests without a
//   bracket: a file of 100 KB overflows the stack.
// - Characters beyond ASCII outside of strings and comments, where TOML has none. Some of them lead it to a
//   place that it has marked as unreachable.
// - A header without a name, `[=`. It asserts that there is one, and with NDEBUG it assumes it.
//
// This looks at the text before it is parsed, so it knows strings and comments, and little else of TOML.
// Where the text is no TOML it may refuse too much, never too little.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace cca::detail {

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The tables of a parsed text are nested at most this deep: parts of a header and of a key, and of a key in
// each bracket that is open.
inline constexpr int most_key_parts = 64, most_open_brackets = 32;

// Where a string that begins at `at` ends: its end, or that of the line.
inline std::size_t end_of_toml_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool is_long = text.substr(at, 3) == std::string(3, quote);
  for (at += is_long ? 3 : 1; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') ++at;
    else if (!is_long && (text[at] == quote || text[at] == '\n')) return at + (text[at] == quote);
    else if (is_long && text.substr(at, 3) == std::string(3, quote)) {
      at += 3;
      // A long string may end with two quotes of its own.
      for (int own = 0; own < 2 && at < text.size() && text[at] == quote; ++own) ++at;
      return at;
    }
  }
  return text.size();
}

// Whether a name, or what toml++ refuses by itself, follows the brackets of a header.
inline bool is_name_of_table(std::string_view rest) {
  const auto skip_space = [&] { rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size())); };
  skip_space();
  if (rest.starts_with('[')) rest.remove_prefix(1), skip_space();
  constexpr std::string_view others = "-_\"']";
  return rest.empty() || is_letter(rest[0]) || (rest[0] >= '0' && rest[0] <= '9') ||
         others.find(rest[0]) != others.npos;
}

// ":3: a key of more than 64 parts", or nothing.
inline std::string complaint_before_parsing(std::string_view text) {
  int dots = 0, open = 0;
  bool begins_line = true;
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // the byte order mark
  const auto complaint = [&](const std::string& what) {
    std::size_t line = 1;
    for (const char c : text.substr(0, at)) line += c == '\n';
    return ":" + std::to_string(line) + ": " + what;
  };
  while (at < text.size()) {
    const char c = text[at];
    const bool is_header = c == '[' && begins_line && open == 0;
    if (c != ' ' && c != '\t') begins_line = c == '\n';
    if (is_header && !is_name_of_table(text.substr(at + 1)))
      return complaint("not TOML: after `[` comes the name of a table");
    if (c == '"' || c == '\'') {
      at = end_of_toml_string(text, at);
      continue;
    }
    if (c == '#') {
      at = text.find_first_of("\r\n", at);
      if (at == text.npos) break;
      continue;
    }
    if (static_cast<unsigned char>(c) >= 0x80)
      return complaint("not TOML: characters beyond ASCII must stand in quotes");
    if (c == '.' && ++dots >= most_key_parts)
      return complaint("a key of more than " + std::to_string(most_key_parts) + " parts");
    if ((c == '[' || c == '{') && ++open > most_open_brackets)
      return complaint("more than " + std::to_string(most_open_brackets) + " brackets are open");
    if ((c == ']' || c == '}') && open > 0) --open;
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
    ++at;
  }
  return {};
}

}  // namespace cca::detail
