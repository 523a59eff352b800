// EXPECT: transform\.leaves_space: the function [a-z_]+ of this transformation returns paw_in_trunk \(.*\), but its input is in paw_in_hip
// A transformation returns the space that it takes: here it takes the paw in the hip's frame and returns it
// in the trunk's.
#include <cca/mapping/mapping.hpp>

#include "parts.hpp"

struct hip_frame : cca::frame<"hip"> {};
struct paw_in_hip : cca::space<cca::cartesian_position<hip_frame>, xyz> {};
struct paw_in_trunk : cca::space<cca::cartesian_position<trunk>, xyz> {};

struct lifted {
#if CCA_REJECT
  auto operator()(const cca::sample<paw_in_hip>& p) const { return cca::sample<paw_in_trunk>(p.vector()); }
#else
  auto operator()(const cca::sample<paw_in_hip>& p) const { return p.plus(Eigen::Vector3d(0, 0, 0.03)); }
#endif
};

struct paw {
  auto process(cca::beat) -> cca::out<"position", paw_in_hip> { return {}; }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"paw", paw>,
                         cca::node<"lift", cca::transformation<paw_in_hip, lifted>>,
                         cca::wire<"paw.position", "lift.input">> {};

cca::controller<walk> c;
