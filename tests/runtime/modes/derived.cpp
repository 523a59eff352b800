// Values derived from samples in a set of modes: as in one graph, before and after a switch.
#include <doctest/doctest.h>

#include <cca/modes.hpp>

#include "../core/derived.hpp"

using namespace derived_test;

namespace {

struct halved : cca::graph<cca::rate<1000>,
                           cca::node<"source", source>,
                           cca::node<"half", length_reader>,
                           cca::node<"a", length_reader>,
                           cca::node<"c", area_reader>,
                           cca::wire<"source.y", "half.x">,
                           cca::wire<"half.y", "a.x">,
                           cca::wire<"half.y", "c.x">> {};
struct either : cca::modes<cca::mode<"ways", ways>, cca::mode<"halved", halved>> {};

}  // namespace

TEST_SUITE("derived in modes") {
  TEST_CASE("each mode derives from its own samples, each once") {
    cca::controller<either> c;
    c.load();
    c.start();
    for (int k = 0; k < 24; ++k) c.step();
    c.switch_to<"halved">();
    lengths = areas = 0;
    for (int k = 0; k < 24; ++k) c.step();
    CHECK_EQ(lengths, 48);
    CHECK_EQ(areas, 24);
    CHECK_EQ(c.get<"half">().wrong, 0);
    CHECK_EQ(c.get<"half">().fired, 24);
    c.switch_to<"ways">();
    for (int k = 0; k < 24; ++k) c.step();
    expect_right(c, 48);
  }
}
