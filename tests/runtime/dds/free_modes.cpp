// Modes with a free-running environment, over Cyclone DDS.
#include <doctest/doctest.h>

#include "../../laws/free_mode_laws.hpp"
#include "over_dds.hpp"

TEST_SUITE("free-running modes over dds") {
  TEST_CASE("in a fast run: the bits of one loop") { free_mode_laws::has_the_bits_of_one_loop<over_dds>(); }
  TEST_CASE("in a wall-clock run: results of an old mode") {
    free_mode_laws::results_of_an_old_mode<over_dds>();
  }
}
