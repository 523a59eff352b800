// Used by all tests of skeletons: sources whose values a test sets, and a sink that records what arrives.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <cca/cca.hpp>

namespace skeleton_test {

// Publishes `now` with its origin, only if `publishes`.
template <class Space, int Number = 0>
struct by_hand {
  cca::sample<Space> now;
  bool publishes = true;
  auto process(cca::beat) -> cca::maybe<"y", Space> {
    if (!publishes) return {};
    return cca::maybe<"y", Space>(now).with_origin(now.origin());
  }
};

template <class Space>
struct listener {
  struct note {
    std::int64_t beat;
    cca::sample<Space> sample;
  };
  cca::sample<Space> last;
  std::vector<note> all;
  void process(cca::in<"x", Space> x, cca::beat now) { last = x, all.push_back({now.index(), x}); }
};

template <class Graph>
cca::controller<Graph> started() {
  cca::controller<Graph> c;
  c.load();
  c.start();
  return c;
}

template <class Space>
cca::sample<Space> number(double n, std::int64_t origin = cca::never) {
  return cca::sample<Space>(Space::vector_type::Constant(n), origin);
}

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace skeleton_test
