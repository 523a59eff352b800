// Deployments of modes over POSIX shared memory.
#include <doctest/doctest.h>

#include <unistd.h>

#include <string>

#include <cca/runtime/transports/shared_memory.hpp>

#include "../../laws/modes_laws.hpp"

namespace {

struct over_shared_memory {
  static auto transport(const std::string& name) { return cca::shared_memory(name); }
  static std::string other_name() {
    static int number = 0;
    return "/cca_modes_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
  }
};

}  // namespace

TEST_SUITE("modes in processes") {
  TEST_CASE("all environments switch in the same beat, whoever asks") {
    modes_laws::switches_in_the_same_beat<over_shared_memory>();
  }
  TEST_CASE("in a wall-clock run, too") {
    modes_laws::switches_in_the_same_beat_of_a_wall_clock_run<over_shared_memory>();
  }
  TEST_CASE("a process that comes again joins the mode of the others") {
    modes_laws::joins_the_mode_of_the_others<over_shared_memory>();
  }
}
