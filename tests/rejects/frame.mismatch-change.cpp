// EXPECT: frame\.mismatch: this frame change places hip in trunk, so it takes what is given in hip, but its input is paw_in_trunk
// A frame change leads from the frame that it places to the frame in which it is placed, not back.
#include <cca/mapping/rigid_motion.hpp>

struct hip : cca::frame<"hip"> {};
struct trunk : cca::frame<"trunk"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct paw_in_hip : cca::space<cca::cartesian_position<hip>, xyz> {};
struct paw_in_trunk : cca::space<cca::cartesian_position<trunk>, xyz> {};

struct hip_in_trunk : cca::placed<hip, trunk> {
  static constexpr auto where = cca::at(0.12, 0.07, 0);
};

#if CCA_REJECT
cca::frame_change<hip_in_trunk, paw_in_trunk, paw_in_hip> change;
#else
cca::frame_change<cca::inverse_of<hip_in_trunk>, paw_in_trunk, paw_in_hip> change;
#endif
