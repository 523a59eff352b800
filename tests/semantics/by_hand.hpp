// Small components for the tests whose expected values were worked out by hand from the text of the
// Semantics.
#pragma once

#include <ostream>
#include <vector>

#include <doctest/doctest.h>

#include <cca/cca.hpp>

namespace by_hand {

struct axis : cca::dimension<"axis"> {};
struct value : cca::space<cca::number, cca::axes<axis>> {};

// What a reader sees in one firing.
struct seen_input {
  std::int64_t beat;
  double value;
  std::int64_t origin;
  bool fresh;
  friend bool operator==(const seen_input&, const seen_input&) = default;
};
using seen_inputs = std::vector<seen_input>;

inline std::ostream& operator<<(std::ostream& to, const seen_inputs& all) {
  to << '{';
  for (const auto& s : all) {
    to << "{" << s.beat << ", " << s.value << ", ";
    if (s.origin == cca::never) to << "never";
    else to << s.origin;
    to << (s.fresh ? ", fresh} " : "} ");
  }
  return to << '}';
}

// Publishes the beat's index.
struct count {
  auto process(cca::beat now) -> cca::out<"y", value> { return static_cast<double>(now.index()); }
};

// Publishes the beat's index, in beats that N divides.
template <int N>
struct sometimes {
  auto process(cca::beat now) -> cca::maybe<"y", value> {
    if (now.index() % N != 0) return {};
    return static_cast<double>(now.index());
  }
};

// Records what it sees.
struct look {
  seen_inputs log;
  void process(cca::in<"x", value> x, cca::beat now) {
    log.push_back({now.index(), x[axis{}], x.origin(), x.fresh()});
  }
};

struct look_at_two {
  seen_inputs x, z;
  void process(cca::in<"x", value> a, cca::in<"z", value> b, cca::beat now) {
    x.push_back({now.index(), a[axis{}], a.origin(), a.fresh()});
    z.push_back({now.index(), b[axis{}], b.origin(), b.fresh()});
  }
};

// Passes on what it sees.
struct relay {
  auto process(cca::in<"x", value> x) -> cca::out<"y", value> { return x[axis{}]; }
};

struct sum {
  auto process(cca::in<"x", value> x, cca::in<"z", value> z) -> cca::out<"y", value> {
    return x[axis{}] + z[axis{}];
  }
};

template <class Graph>
cca::controller<Graph> after(int beats) {
  cca::controller<Graph> c;
  c.load();
  c.start();
  for (int k = 0; k < beats; ++k) CHECK(c.step());
  return c;
}

// The beats in which a reader fired.
inline std::vector<std::int64_t> beats_of(const seen_inputs& all) {
  std::vector<std::int64_t> beats;
  for (const auto& s : all) beats.push_back(s.beat);
  return beats;
}
using beats = std::vector<std::int64_t>;

inline constexpr auto never = cca::never;
inline constexpr std::int64_t ms = 1'000'000;

}  // namespace by_hand

namespace doctest {
template <>
struct StringMaker<std::vector<std::int64_t>> {
  static String convert(const std::vector<std::int64_t>& all) {
    String s = "{";
    for (const auto one : all) s += toString(one) + ", ";
    return s + "}";
  }
};
}  // namespace doctest
