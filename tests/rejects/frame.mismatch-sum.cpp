// EXPECT: frame\.mismatch: samples of left_force \(wrench<world, world> over x, y, z\) and of right_force \(wrench<world, foot> over x, y, z\) are of different frames
// Forces are added in one frame.
#include <cca/space/domain.hpp>
#include <cca/space/sample.hpp>

struct world : cca::frame<"world"> {};
struct foot : cca::frame<"foot"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct left_force : cca::space<cca::wrench<world, world>, xyz> {};
struct right_force : cca::space<cca::wrench<world, foot>, xyz> {};
struct foot_attitude : cca::space<cca::orientation<world>, xyz> {};

auto total(const cca::sample<left_force>& a,
           const cca::sample<right_force>& b,
           [[maybe_unused]] const cca::sample<foot_attitude>& o) {
#if CCA_REJECT
  return a + b;
#else
  return a + o.express(b);
#endif
}
