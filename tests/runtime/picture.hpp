// What `describe` draws of a graph against the picture on its page: a raw string that begins with the mark by
// which the page finds it.
#pragma once

#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include <cca/graph/describe.hpp>

namespace test {

inline std::string on_page(std::string_view picture) {
  return std::string(picture.substr(picture.find('\n') + 1));
}

template <class Graph>
void check_picture(std::string_view picture) {
  CHECK_EQ(cca::describe<Graph>::mermaid(), on_page(picture));
}

}  // namespace test
