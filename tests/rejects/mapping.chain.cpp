// EXPECT: mapping\.chain: a mapping of this chain gives paw_in_trunk \(.*\), and the next one takes paw_in_world \(.*\): the frames differ
// The first mapping returns the paw in the trunk's frame, but the last takes it in the world's.
#include <cca/mapping/mapping_chain.hpp>
#include <cca/mapping/rigid_motion.hpp>

#include "parts.hpp"

struct hip_frame : cca::frame<"hip"> {};
struct paw_in_hip : cca::space<cca::cartesian_position<hip_frame>, xyz> {};
struct paw_in_trunk : cca::space<cca::cartesian_position<trunk>, xyz> {};
struct paw_in_world : cca::space<cca::cartesian_position<world>, xyz> {};
struct height : cca::space<cca::number, cca::axes<cca::z>> {};

struct hip_in_trunk : cca::placed<hip_frame, trunk> {
  static constexpr auto where = cca::at(0.12, 0.07, 0);
};
struct trunk_at_start : cca::placed<trunk, world> {
  static constexpr auto where = cca::at(0, 0, 0.17);
};
struct above_ground {
  double operator()(const cca::sample<paw_in_world>& p) const { return p[cca::z{}]; }
};

struct height_of_paw : cca::mapping_chain<cca::frame_change<hip_in_trunk, paw_in_hip, paw_in_trunk>,
#if !CCA_REJECT
                                          cca::frame_change<trunk_at_start, paw_in_trunk, paw_in_world>,
#endif
                                          cca::mapping<paw_in_world, height, above_ground>> {
};

struct paw {
  auto process(cca::beat) -> cca::out<"position", paw_in_hip> { return {}; }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"paw", paw>,
                         cca::node<"height", height_of_paw>,
                         cca::wire<"paw.position", "height.input">> {};

cca::controller<walk> c;
