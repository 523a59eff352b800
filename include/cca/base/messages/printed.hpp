// A text as a type that is never defined: the compiler prints it where it is needed, and with it the text. A
// compiler that cuts texts after 35 letters gets it in lines, broken between words.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include <cca/base/compiler.hpp>

namespace cca::detail {

template <auto... Text>
struct refused_graph;

template <std::size_t Size>
struct message {
  char text[Size + 1]{};
  constexpr explicit message(std::string_view whole) {
    for (std::size_t i = 0; i < Size; ++i) text[i] = whole[i];
  }
};

struct line {
  char text[36]{};
};

struct broken_lines {
  std::array<line, 96> lines{};
  std::size_t count = 0;
};

constexpr broken_lines in_lines(std::string_view whole) {
  constexpr std::size_t width = sizeof(line) - 1;
  broken_lines broken;
  while (!whole.empty() && broken.count < broken.lines.size()) {
    std::size_t size = whole.size();
    if (size > width) {
      size = whole.rfind(' ', width);
      if (size == whole.npos || size == 0) size = width;
    }
    auto& letters = broken.lines[broken.count++].text;
    for (std::size_t i = 0; i < width; ++i) letters[i] = i < size ? whole[i] : ' ';
    letters[width] = '\0';
    whole.remove_prefix(size);
    if (!whole.empty() && whole.front() == ' ') whole.remove_prefix(1);
  }
  return broken;
}

// `Said::view()`: the text.
template <class Said, bool IsWhole = prints_whole_texts>
struct printed_text {
  using type = refused_graph<message<Said::view().size()>(Said::view())>;
};
template <class Said>
struct printed_text<Said, false> {
  static constexpr broken_lines broken = in_lines(Said::view());
  template <std::size_t... Line>
  static auto in_order(std::index_sequence<Line...>) -> refused_graph<line(broken.lines[Line])...>;
  using type = decltype(in_order(std::make_index_sequence<broken.count>{}));
};
template <class Said>
using printed = typename printed_text<Said>::type;

}  // namespace cca::detail
