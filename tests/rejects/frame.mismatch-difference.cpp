// EXPECT: frame\.mismatch: samples of foot_in_world \(cartesian_position<world> over x, y, z\) and of foot_in_hip \(cartesian_position<hip> over x, y, z\) are of different frames
// A distance lies within one frame.
#include <cca/space/domain.hpp>
#include <cca/space/sample.hpp>

struct world : cca::frame<"world"> {};
struct hip : cca::frame<"hip"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct foot_in_world : cca::space<cca::cartesian_position<world>, xyz> {};
struct foot_in_hip : cca::space<cca::cartesian_position<hip>, xyz> {};
struct hip_pose : cca::space<cca::pose<world>, xyz> {};

double step_length(const cca::sample<foot_in_world>& from,
                   const cca::sample<foot_in_hip>& to,
                   [[maybe_unused]] const cca::sample<hip_pose>& hip_in_world) {
#if CCA_REJECT
  return from.distance(to);
#else
  return from.distance(hip_in_world.express(to));
#endif
}
