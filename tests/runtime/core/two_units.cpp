// One translation unit makes a controller, another one steps it.
#include <doctest/doctest.h>

#include "two_units.hpp"

using namespace core_test;

TEST_SUITE("two translation units") {
  TEST_CASE("step the same controller") {
    auto c = started<shared>();
    c.step();
    step_elsewhere(c);
    CHECK_EQ(c.beat_index(), 4);
    CHECK_EQ(c.get<"log">().all.back(), seen{3, 4, 3'000'000, true});
    CHECK_EQ(picture_elsewhere(), cca::describe<shared>::mermaid());
  }
}
