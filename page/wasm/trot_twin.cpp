// The twin of examples/trot, whichever physics its robot is in: the robot's part of it only says its ports.
#include <cca/cca.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "engines/any.hpp"

#include "twin.hpp"

// [twin]
namespace {

struct twin_of_trot : trot::architecture<cca::sim::compiled_oncilla>, cca::recordable {};

}  // namespace

cca::page::twin_program& cca::page::twin() {
  static twin_of<twin_of_trot> trot;
  return trot;
}
// [twin end]
