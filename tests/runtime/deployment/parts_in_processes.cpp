// Parts that are stopped and started from outside, over POSIX shared memory.
#include <doctest/doctest.h>

#include <unistd.h>

#include <string>

#include <cca/runtime/transports/shared_memory.hpp>

#include "../../laws/part_laws.hpp"

namespace {

struct over_shared_memory {
  static auto transport(const std::string& name) { return cca::shared_memory(name); }
  static std::string other_name() {
    static int number = 0;
    return "/cca_parts_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
  }
};

}  // namespace

TEST_SUITE("parts in processes") {
  TEST_CASE_TEMPLATE("they stop in the same beat, whoever asks", D, part_laws::spread, part_laws::whole) {
    part_laws::stops_in_the_same_beat<over_shared_memory, D>();
    part_laws::stops_in_the_same_beat_of_a_wall_clock_run<over_shared_memory, D>();
  }
  TEST_CASE("a process stops what another one runs") {
    part_laws::stops_what_another_process_runs<over_shared_memory, part_laws::whole>();
    part_laws::stops_what_another_process_runs<over_shared_memory, part_laws::spread>();
  }
}
