// Keys, out of the bytes that a terminal sends.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cca_door {

struct key {
  enum class kind {
    character,
    enter,
    escape,
    tab,
    backspace,
    erase_all,
    up,
    down,
    left,
    right,
    page_up,
    page_down,
    home,
    end,
    remove,
    pasted,
    interrupt,
    suspend,
    redraw,
    unknown
  };
  kind what = kind::unknown;
  char letter = 0;     // of a character: printable ASCII
  std::string text{};  // what was pasted
  bool is(char c) const { return what == kind::character && letter == c; }
};

class key_reader {
public:
  void add(std::string_view bytes) { waiting += bytes; }
  bool is_empty() const { return waiting.empty(); }

  // `is_all`: nothing more has come for a while, so an escape that stands alone is the key of that name.
  std::optional<key> next(bool is_all) {
    if (waiting.empty()) return {};
    const char first = waiting[0];
    if (first == '\x1b') return escape(is_all);
    waiting.erase(0, 1);
    using k = key::kind;
    switch (first) {
      case '\r':
      case '\n':
        return key{k::enter};
      case '\t':
        return key{k::tab};
      case '\x7f':
      case '\b':
        return key{k::backspace};
      case '\x03':
        return key{k::interrupt};
      case '\x1a':
        return key{k::suspend};
      case '\x0c':
        return key{k::redraw};
      case '\x15':
        return key{k::erase_all};
      case '\x01':
        return key{k::home};
      case '\x05':
        return key{k::end};
      default:
        break;
    }
    if (first < ' ' || first == '\x7f') return key{};  // also bytes of other characters
    return key{k::character, first};
  }

private:
  std::string waiting{};

  std::optional<key> escape(bool is_all) {
    using k = key::kind;
    if (waiting.size() == 1) return is_all ? std::optional(take(1, k::escape)) : std::nullopt;
    if (waiting[1] != '[' && waiting[1] != 'O')
      return take(waiting[1] == '\x1b' ? 1 : 2, waiting[1] == '\x1b' ? k::escape : k::unknown);
    std::size_t end = 2;
    while (end < waiting.size() && (waiting[end] < '@' || waiting[end] > '~')) ++end;
    if (end == waiting.size())
      return is_all || end > 32 ? std::optional(take(end, k::unknown)) : std::nullopt;
    const std::string code = waiting.substr(2, end - 1);
    if (code == "200~") return paste(end + 1, is_all);
    static constexpr std::pair<std::string_view, k> known[] = {
        {"A", k::up},       {"B", k::down},       {"C", k::right},   {"D", k::left},  {"H", k::home},
        {"F", k::end},      {"1~", k::home},      {"4~", k::end},    {"7~", k::home}, {"8~", k::end},
        {"5~", k::page_up}, {"6~", k::page_down}, {"3~", k::remove}, {"Z", k::tab}};
    for (const auto& [text, what] : known)
      if (code == text) return take(end + 1, what);
    return take(end + 1, k::unknown);
  }
  // What is pasted is no key: a text with a blank in it must not stop a robot.
  std::optional<key> paste(std::size_t begin, bool is_all) {
    constexpr std::string_view mark = "\x1b[201~";
    constexpr std::size_t most = 1 << 16;
    const std::size_t end = waiting.find(mark, begin);
    if (end == std::string::npos) {
      if (!is_all && waiting.size() < most) return {};
      return take(waiting.size(), key::kind::unknown);
    }
    key one{key::kind::pasted, 0, waiting.substr(begin, end - begin)};
    waiting.erase(0, end + mark.size());
    return one;
  }
  key take(std::size_t size, key::kind what) {
    waiting.erase(0, size);
    return key{what};
  }
};

}  // namespace cca_door
