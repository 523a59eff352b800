// EXPECT: frame\.mismatch: the power of a wrench at foot with a twist that acts at another point, trunk; move one to the point of the other first
// A wrench and a twist that act at two points make no power.
#include <cca/space/domain.hpp>
#include <cca/space/sample.hpp>

struct world : cca::frame<"world"> {};
struct foot : cca::frame<"foot"> {};
struct trunk : cca::frame<"trunk"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct trunk_twist : cca::space<cca::twist<trunk, world>, xyz> {};
struct ground_force : cca::space<cca::wrench<foot, world>, xyz> {};
struct lever : cca::space<cca::cartesian_position<world>, xyz> {};

double power(const cca::sample<ground_force>& f,
             const cca::sample<trunk_twist>& v,
             [[maybe_unused]] const cca::sample<lever>& foot_to_trunk) {
#if CCA_REJECT
  return f.power(v);
#else
  return f.moved_to<trunk>(foot_to_trunk).power(v);
#endif
}
