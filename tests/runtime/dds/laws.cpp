// The environments of a deployment in processes of their own, over Cyclone DDS.
#include <doctest/doctest.h>

#include "../../laws/cut_skeletons.hpp"
#include "../../laws/free_running_laws.hpp"
#include "../../laws/free_running_queue_laws.hpp"
#include "../../laws/transport_laws.hpp"
#include "over_dds.hpp"

TEST_SUITE("deployed over dds") {
  TEST_CASE("each process has the bits of the one loop") {
    transport_laws::has_the_bits_of_one_loop<over_dds>();
    transport_laws::has_the_same_bits_at_wall_clock_speed<over_dds>();
  }
  TEST_CASE("a farm whose workers run in processes has the bits of the one loop") {
    cut_skeletons::a_farm_in_processes<over_dds>();
  }
  TEST_CASE("a killed process is lost contact for the others, at any pace") {
    transport_laws::loses_contact_with_the_killed<over_dds>();
  }
  TEST_CASE("a fault in a follower stops every resource node within two beats") {
    transport_laws::stops_all_within_two_beats_of_a_fault<over_dds>();
  }
  TEST_CASE("a process may come late, and come again") {
    transport_laws::waits_for_who_comes_late_or_again<over_dds>();
  }
  TEST_CASE("stop in one process is stop in the other, which waits in run") {
    transport_laws::stops_with_the_others<over_dds>();
  }
  TEST_CASE("the robot's side idles while another process stands still") {
    transport_laws::idles_while_another_stands<over_dds>();
  }
  TEST_CASE("a reader that stops costs the writer nothing") {
    transport_laws::is_not_held_up_by_a_stopped_reader<over_dds>();
  }
  TEST_CASE("who stood still for 3 s goes on") { transport_laws::goes_on_after_a_standstill<over_dds>(); }
  TEST_CASE("a second process and one of another deployment are refused") {
    transport_laws::refuses_whom_it_must<over_dds>();
  }

  TEST_CASE("free-running: the bits of one loop, results in a wall-clock run, lost contact with the killed") {
    free_running_laws::has_the_bits_of_one_loop<over_dds>();
    free_running_laws::runs_freely_at_wall_clock_speed<over_dds>();
    free_running_laws::loses_contact_with_the_killed<over_dds>();
  }
  TEST_CASE("free-running queues: the bits of one loop, and what is lost in a wall-clock run is counted") {
    free_running_laws::queues_have_the_bits_of_one_loop<over_dds>();
    free_running_laws::queues_count_what_they_lose<over_dds>();
  }
}
