// Values derived from samples where environments run the graph: each environment derives its own.
#include <doctest/doctest.h>

#include <cca/deployment.hpp>

#include "../core/derived.hpp"

using namespace derived_test;

namespace {

struct apart : cca::deployment<
                   ways,
                   cca::environment<"front", cca::nodes<"source", "a", "b", "c", "behind", "queued", "rare">>,
                   cca::environment<"back", cca::other_nodes>> {};

}  // namespace

TEST_SUITE("derived in environments") {
  TEST_CASE("as in one loop") {
    cca::deployed<apart> d;
    d.load();
    d.start();
    d.run(cca::for_beats<240>{});
    expect_right(d, 240);
  }
}
