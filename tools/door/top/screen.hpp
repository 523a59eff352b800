// What a terminal shows: lines of pieces with a style. Only the lines that differ are written again, in one
// go.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "columns.hpp"

namespace cca_door {

enum class style { plain, bold, faint, bar, chosen, alarm, stop };

struct piece {
  style how = style::plain;
  std::string text{};
  bool operator==(const piece&) const = default;
};

// Never longer than the terminal is wide.
class screen_line {
public:
  screen_line(std::size_t width, bool has_utf8) : free(width), utf8(has_utf8) {}

  screen_line& add(std::string_view text, style how = style::plain) {
    shown_text one = shown(text, free, utf8);
    free -= one.columns;
    if (one.text.empty()) return *this;
    if (!pieces.empty() && pieces.back().how == how) pieces.back().text += one.text;
    else pieces.push_back({how, std::move(one.text)});
    return *this;
  }
  screen_line& fill(style how = style::plain, std::size_t leave = 0) {
    return free > leave ? add(std::string(free - leave, ' '), how) : *this;
  }
  std::size_t room() const { return free; }
  bool has_utf8() const { return utf8; }

  std::string text() const {
    std::string all;
    for (const piece& one : pieces) all += one.text;
    return all;
  }
  bool operator==(const screen_line& other) const { return pieces == other.pieces; }

  // Select Graphic Rendition of ECMA-48.
  std::string with_codes() const {
    std::string all;
    for (const piece& one : pieces) all += code_of(one.how) + one.text;
    return all + "\x1b[0m";
  }

private:
  static std::string code_of(style how) {
    switch (how) {
      case style::plain:
        return "\x1b[0m";
      case style::bold:
        return "\x1b[0;1m";
      case style::faint:
        return "\x1b[0;2m";
      case style::bar:
        return "\x1b[0;7m";
      case style::chosen:
        return "\x1b[0;1;7m";
      case style::alarm:
        return "\x1b[0;1;31m";
      case style::stop:
        return "\x1b[0;1;97;41m";
    }
    return {};
  }

  std::size_t free;
  bool utf8;
  std::vector<piece> pieces{};
};

struct terminal_size {
  std::size_t width = 80, height = 24;
  bool operator==(const terminal_size&) const = default;
};

class screen {
public:
  // What to write to the terminal, so that it shows these lines.
  std::string show(const std::vector<screen_line>& lines, terminal_size size) {
    const bool is_new = !is_known || size != last_size;
    std::string all = is_new ? "\x1b[0m\x1b[2J" : "";
    for (std::size_t i = 0; i < lines.size() && i < size.height; ++i)
      if (is_new || i >= last.size() || lines[i] != last[i])
        all += "\x1b[" + std::to_string(i + 1) + ";1H" + lines[i].with_codes() +
               (lines[i].room() > 0 ? "\x1b[K" : "");
    for (std::size_t i = lines.size(); i < last.size() && i < size.height && !is_new; ++i)
      all += "\x1b[" + std::to_string(i + 1) + ";1H\x1b[0m\x1b[K";
    last = lines, last_size = size, is_known = true;
    // A terminal that knows it shows all of it at once; others pass over it.
    return all.empty() ? all : "\x1b[?2026h" + all + "\x1b[?2026l";
  }
  void forget() { is_known = false; }

private:
  std::vector<screen_line> last{};
  terminal_size last_size{};
  bool is_known = false;
};

}  // namespace cca_door
