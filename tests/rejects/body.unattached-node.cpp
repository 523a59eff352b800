// EXPECT: body\.unattached: the part `[a-z_]+` of this body is driven by the resource node `left_leg`, which walk lacks
// The body names the resource nodes that move its parts; the graph must have them.
#include <cca/robot/body.hpp>

#include "parts.hpp"

struct paw : cca::frame<"paw"> {};

struct leg_chain : cca::serial_chain<trunk, paw, cca::axes<hip, knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1))};
  static constexpr auto tip = cca::at(0, 0, -0.1);
};
struct dog : cca::body<trunk, cca::part<"leg", leg_chain, cca::driven_by<"left_leg">>> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
#if CCA_REJECT
                         cca::node<"right_leg", leg>,
                         cca::wire<"limits.safe", "right_leg.command">,
#else
                         cca::node<"left_leg", leg>,
                         cca::wire<"limits.safe", "left_leg.command">,
#endif
                         cca::wire<"stance.angles", "limits.command">> {
};
static_assert(cca::well_formed<walk>);

constexpr bool has_all = cca::embodied<dog, walk>;
