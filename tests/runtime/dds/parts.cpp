// Parts that are stopped and started from outside, over Cyclone DDS.
#include <doctest/doctest.h>

#include "../../laws/part_laws.hpp"
#include "over_dds.hpp"

TEST_SUITE("parts over dds") {
  TEST_CASE_TEMPLATE("they stop in the same beat, whoever asks", D, part_laws::spread, part_laws::whole) {
    part_laws::stops_in_the_same_beat<over_dds, D>();
    part_laws::stops_in_the_same_beat_of_a_wall_clock_run<over_dds, D>();
  }
  TEST_CASE("a process stops what another one runs") {
    part_laws::stops_what_another_process_runs<over_dds, part_laws::whole>();
    part_laws::stops_what_another_process_runs<over_dds, part_laws::spread>();
  }
}
