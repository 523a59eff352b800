// Modes with a free-running environment, over POSIX shared memory.
#include <doctest/doctest.h>

#include <unistd.h>

#include <string>

#include <cca/runtime/transports/shared_memory.hpp>

#include "../../laws/free_mode_laws.hpp"

namespace {

struct over_shared_memory {
  static auto transport(const std::string& name) { return cca::shared_memory(name); }
  static std::string other_name() {
    static int number = 0;
    return "/cca_free_modes_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
  }
};

}  // namespace

TEST_SUITE("free-running modes in processes") {
  TEST_CASE("in a fast run: the bits of one loop") {
    free_mode_laws::has_the_bits_of_one_loop<over_shared_memory>();
  }
  TEST_CASE("in a wall-clock run: results of an old mode") {
    free_mode_laws::results_of_an_old_mode<over_shared_memory>();
  }
}
