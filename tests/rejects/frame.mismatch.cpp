// EXPECT: frame\.mismatch: two orientations are composed that are rotations in different frames, [a-z]+ and [a-z]+; bring both into one frame first
// Coordinates are numbers in a frame; those of two frames do not combine, nor do rotations.
#include <cca/space/domain.hpp>
#include <cca/space/sample.hpp>

struct world : cca::frame<"world"> {};
struct trunk : cca::frame<"trunk"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct trunk_attitude : cca::space<cca::orientation<world>, xyz> {};
struct foot_attitude : cca::space<cca::orientation<trunk>, xyz> {};

auto compose(const cca::sample<trunk_attitude>& a, [[maybe_unused]] const cca::sample<foot_attitude>& b) {
#if CCA_REJECT
  return a * b;  // b is a rotation about the trunk's axes, a one about the world's
#else
  return a * a;
#endif
}
