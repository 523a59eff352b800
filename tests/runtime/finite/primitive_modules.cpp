// Discrete movement primitives as modules, under the laws of finite numbers.
#include <cca/motor/modules/dmp_discrete_module.hpp>
#include <cca/motor/modules/dmp_pose_module.hpp>

#include "learning_modules.hpp"

using namespace finite_test;

namespace {

struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct hand_in_trunk : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};

}  // namespace

TEST_CASE("motor/modules/dmp_discrete_module.hpp") { laws_of<cca::dmp_discrete_module<leg, 5>>(); }
TEST_CASE("motor/modules/dmp_pose_module.hpp") { laws_of<cca::dmp_pose_module<hand_in_trunk, hand, 3>>(); }
