// Many worlds without Python: a policy outside has the bits of the same policy in the graph.
#include <cca/python/policy_file.hpp>
#include <cca/python/worlds.hpp>
#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include "../../python/pole.hpp"

using namespace python_test;

namespace {

struct on_its_own : balanced<balance> {};

// Holds the pole upright, not too well.
template <class Parameters>
void give_weights(Parameters& w) {
  const double layers[] = {2, 1, 3, 0.6, 0.3, 0.9, 0, 0, 0, -4, -4, -4, 0.01};
  std::copy(std::begin(layers), std::end(layers), w.weights.begin());
}

}  // namespace

TEST_CASE("a policy outside has the bits of the policy in the graph") {
  cca::python::worlds<balancing> outside(3);
  outside.reset(std::vector<std::int64_t>{4, 5, 6});
  cca::controller<on_its_own> inside;
  give_weights(inside.get<"policy">().weights);
  inside.load();
  begin_with(inside, 5);
  inside.start();

  balance::network::parameters weights;
  give_weights(weights);
  bool has_moved = false;
  for (int step = 0; step < 40; ++step) {
    std::vector<double> actions;
    for (std::size_t i = 0; i < 3; ++i) {
      const balance::network::input seen(outside.now().observations.data() + 2 * i);
      actions.push_back(balance::network::answer(weights, seen)[0]);
    }
    outside.step(actions);
    for (int k = 0; k < 4; ++k) {
      look_at(inside);
      REQUIRE(inside.step());
    }
    REQUIRE(outside.now().observations[2] == inside.get<"pole">().at);
    REQUIRE(outside.now().observations[3] == inside.get<"pole">().speed);
    has_moved = has_moved || outside.now().observations[2] != outside.now().observations[0];
  }
  CHECK(has_moved);
}

TEST_CASE("the worlds are refused what no task can do") {
  using cca::python::worlds;
  CHECK_THROWS_WITH_AS(worlds<balancing>(0), "num_envs is 0: there is at least one world",
                       std::invalid_argument);
  struct never : balancing {
    static void begin(controller& c, std::uint64_t) { c.get<"pole">().speed = 1000; }
  };
  CHECK_THROWS_WITH_AS(worlds<never>(1),
                       "the task ends before its policy has fired three times: pole: the pole is too fast",
                       cca::refused);
  worlds<balancing> two(2);
  CHECK_THROWS_WITH_AS(two.step({}), "step() before reset(): reset all worlds first", std::logic_error);
  CHECK_THROWS_WITH_AS(two.reset(std::vector<std::int64_t>{1}), "1 seeds for 2 worlds: 2 are expected",
                       std::invalid_argument);
  two.reset({});
  CHECK_THROWS_WITH_AS(two.step(std::vector<double>(3)), "3 actions for 2 worlds: 2 are expected",
                       std::invalid_argument);
}
