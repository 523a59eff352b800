// Types in messages as the user wrote them.
#pragma once

#include <string_view>

#include <cca/base/text.hpp>

namespace cca::detail {

struct respelling {
  std::string_view from, to;
};

// Replaces the compilers' spelling of types: `in<angles, leg_angles>&` and `std::string`.
template <class Text>
constexpr Text as_written(const Text& whole) {
  Text t;
  std::string_view spelled = whole.view();
  constexpr std::string_view names[] = {"cca::fixed_string<", "fixed_string<"};
  constexpr respelling others[] = {{"std::__cxx11::basic_string<char>", "std::string"},
                                   {"std::basic_string<char>", "std::string"},
                                   {"(anonymous namespace)::", ""},
                                   {"{anonymous}::", ""},
                                   {" *", "*"},
                                   {" &", "&"},
                                   {" >", ">"}};
  while (!spelled.empty()) {
    std::size_t used = 0;
    for (const auto name : names)
      if (used == 0 && spelled.starts_with(name)) {
        const auto from = spelled.find('"') + 1, to = spelled.find('"', from);
        t << spelled.substr(from, to - from);
        used = to + 1;
        while (used < spelled.size() && spelled[used] == '}') ++used;
      }
    for (const auto& [from, to] : others)
      if (used == 0 && spelled.starts_with(from)) {
        t << to;
        used = from.size();
      }
    if (used == 0) t << spelled.substr(0, used = 1);
    spelled.remove_prefix(used);
  }
  return t;
}

}  // namespace cca::detail
