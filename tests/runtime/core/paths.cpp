// Components by path, and their parameters between two beats.
#include <doctest/doctest.h>

#include <cmath>

#include "counting.hpp"

using namespace core_test;

namespace {

// [parameters]
struct wave {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::bounded<double, 0, 10>, amplitude), (double, offset));
    const char* check() const {
      return amplitude + std::abs(offset) <= 10 ? "" : "the wave would leave its range";
    }
  };
  parameters p{1, 0};

  auto process(cca::beat now) -> cca::out<"y", reading> {
    return p.offset + p.amplitude * std::sin(static_cast<double>(now.index()));
  }
};
// [parameters end]

struct inner : cca::graph<cca::node<"wave", wave>, cca::node<"sum", adder>, cca::wire<"wave.y", "sum.x">> {};
struct middle : cca::graph<cca::node<"inner", inner>, cca::node<"wave", wave>> {};
struct outer : cca::graph<cca::rate<1000>, cca::node<"middle", middle>, cca::node<"counter", counter>> {};
using controller = cca::controller<outer>;

static_assert(std::is_same_v<decltype(std::declval<controller&>().get<"middle.inner.wave">()), wave&>);
static_assert(std::is_same_v<decltype(std::declval<const controller&>().get<"counter">()), const counter&>);

}  // namespace

TEST_SUITE("paths and parameters") {
  TEST_CASE("a component by its path, in one step or through its graph") {
    auto c = started<outer>();
    c.step();
    CHECK_EQ(c.get<"counter">().value, 1);
    CHECK_EQ(&c.get<"middle.inner.sum">(), &c.get<"middle">().get<"inner">().get<"sum">());
    CHECK_EQ(&c.get<"middle.inner.sum">(), &c.get<"middle">().get<"inner.sum">());
    CHECK_EQ(&c.get<"middle.inner.sum">(), &c.get<"middle.inner">().get<"sum">());
    CHECK_NE(&c.get<"middle.wave">(), &c.get<"middle.inner.wave">());
    const auto& constant = c;
    CHECK_EQ(&constant.get<"middle">().get<"wave">(), &c.get<"middle.wave">());
    auto copy = c;
    CHECK_NE(&copy.get<"counter">(), &c.get<"counter">());
  }

  TEST_CASE("all components, depth first in the order of declaration") {
    auto c = started<outer>();
    std::vector<std::string> paths;
    std::vector<const void*> at;
    c.for_each_component([&](std::string_view path, auto& component) {
      paths.emplace_back(path);
      at.push_back(&component);
    });
    CHECK_EQ(paths,
             std::vector<std::string>{"middle.inner.wave", "middle.inner.sum", "middle.wave", "counter"});
    CHECK_EQ(at[1], static_cast<const void*>(&c.get<"middle.inner.sum">()));
    int count = 0;
    std::as_const(c).for_each_component([&](std::string_view, const auto&) { ++count; });
    CHECK_EQ(count, 4);
  }

  TEST_CASE("parameters are checked, then all set, between two beats") {
    auto c = started<outer>();
    c.run(cca::for_beats<5>{}, cca::as_fast_as_possible{}, [](auto& running) {
      if (running.beat_index() == 3)
        running.template set<"middle.wave">(wave::parameters{0, 3});  // while it runs, too
    });
    CHECK_EQ(c.get<"middle.wave">().p.offset, 3);
    CHECK_EQ(c.get<"middle.inner.wave">().p.offset, 0);
    CHECK_EQ(c.get<"middle.wave">().process(cca::beat{5, 1, 1})[cca::x{}], 3);

    const auto refuse = [&](double amplitude, double offset) {
      return words_of([&] { c.set<"middle.wave">(wave::parameters{amplitude, offset}); });
    };
    CHECK_NE(refuse(11, 0).find("11 is out of range, expected 0 to 10"), std::string::npos);
    CHECK_NE(refuse(9, -2).find("the wave would leave its range"), std::string::npos);
    CHECK_NE(refuse(1, std::nan("")).find("nan is not allowed, expected a finite number"), std::string::npos);
    CHECK_EQ(c.get<"middle.wave">().p.amplitude, 0);  // all old values
    CHECK_EQ(c.get<"middle.wave">().p.offset, 3);
    CHECK_EQ(c.state(), cca::state::started);
  }
}
