// Deployments of modes over Cyclone DDS.
#include <doctest/doctest.h>

#include "../../laws/modes_laws.hpp"
#include "over_dds.hpp"

TEST_SUITE("modes over dds") {
  TEST_CASE("all environments switch in the same beat, whoever asks") {
    modes_laws::switches_in_the_same_beat<over_dds>();
  }
  TEST_CASE("in a wall-clock run, too") {
    modes_laws::switches_in_the_same_beat_of_a_wall_clock_run<over_dds>();
  }
  TEST_CASE("a process that comes again joins the mode of the others") {
    modes_laws::joins_the_mode_of_the_others<over_dds>();
  }
}
