// The trot of examples/trot with its robot in compiled physics, three seconds: nothing is sensed but what the
// simulated robot senses.
#include "told.hpp"

#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../../../examples/trot/any_engine.hpp"

struct simulated_trot : trot::architecture<cca::sim::compiled_oncilla>, cca::recordable {};

int main() {
  constexpr double seconds = 3;
  return same_bits::run<simulated_trot>(
      [](auto& c) {
        trot::begin(c, cca::sim::terrain::flat(), cca::sim::disturbance::from_seed(1, seconds), seconds);
      },
      [](auto&) {}, [](const auto& c) { return c.beat_index() < 1000 * seconds; });
}
