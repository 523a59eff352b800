#pragma once
// Small components for the tests of the controller.
#include <cstdint>
#include <string>
#include <vector>

#include <cca/cca.hpp>

namespace core_test {

struct reading : cca::space<cca::number, cca::axes<cca::x>> {};

struct counter {
  auto process() -> cca::out<"y", reading> { return ++value; }
  double value = 0;
};

struct adder {
  auto process(cca::in<"x", reading> x) -> cca::out<"y", reading> { return sum += x[cca::x{}]; }
  double sum = 0;
};

// Records what arrived at an input, and when.
struct seen {
  std::int64_t beat;
  double value;
  std::int64_t origin;
  bool fresh;
  bool operator==(const seen&) const = default;
};
struct journal {
  void process(cca::in<"x", reading> x, cca::beat now) {
    all.push_back({now.index(), x[cca::x{}], x.origin(), x.fresh()});
  }
  std::vector<seen> all;
};

template <class Graph>
cca::controller<Graph> started() {
  cca::controller<Graph> c;
  c.load();
  c.start();
  return c;
}

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace core_test
