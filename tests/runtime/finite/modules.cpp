// The modules of motor/modules/ that are no movement primitives, under the laws of finite numbers.
#include <cca/motor/modules/gmr_module.hpp>
#include <cca/motor/modules/hmm_module.hpp>
#include <cca/motor/modules/rcpg_module.hpp>

#include "learning_modules.hpp"

using namespace finite_test;

namespace {

struct lesson : cca::space<cca::number, cca::axes<hip>> {};

}  // namespace

TEST_CASE("motor/modules/gmr_module.hpp") { laws_of<cca::gmr_module<lesson, leg, 3>>(); }
TEST_CASE("motor/modules/hmm_module.hpp") { laws_of<cca::hmm_module<leg, 3>>(); }
TEST_CASE("motor/modules/rcpg_module.hpp") {
  using least_squares = cca::recursive_least_squares<cca::readout_function<leg, 12>>;
  laws_of<cca::rcpg_module<leg, 12, least_squares, 50, 4>>();
}
