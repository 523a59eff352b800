// An architecture in one loop and spread over environments tells the same, page by page.
#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include <cca/deployment.hpp>

namespace same_story {

// What `plays(played, tell)` makes of it: each call of tell() is a page, told(played).
template <class Played, class F, class Told>
std::vector<std::string> pages_of(F plays, Told told) {
  std::vector<std::string> pages;
  Played c;
  plays(c, [&] { pages.push_back(told(c)); });
  return pages;
}

template <class Architecture, class Deployment, class F, class Told>
void check(F plays, Told told) {
  const auto one_loop = pages_of<cca::controller<Architecture>>(plays, told);
  const auto spread = pages_of<cca::deployed<Deployment>>(plays, told);
  REQUIRE_EQ(one_loop.size(), spread.size());
  for (std::size_t page = 0; page < one_loop.size(); ++page) CHECK_EQ(one_loop[page], spread[page]);
}

// All that a controller's observers show.
template <class Played>
void tell_observed(std::ostream& text, const Played& c) {
  c.observed([&](const cca::observation& o) {
    text << '\n' << o.path << ' ' << o.origin << ' ' << o.fresh;
    for (const double value : o.values) text << ' ' << value;
  });
}

}  // namespace same_story
