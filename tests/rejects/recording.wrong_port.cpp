// EXPECT: recording\.wrong_port: cca::shows names `cpg\.phase` for the angles, but gait_phase \(phase over x\) lacks the axis `hip` of the body body
// LINES: 15
// What a recording shows has the angle of each axis of the body.
#include <cca/robot/body.hpp>

#include "parts.hpp"

struct chain : cca::serial_chain<trunk, world, cca::axes<hip, knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y, cca::at(0, 0, 0)),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.3))};
  static constexpr cca::placement tip = cca::at(0, 0, -0.3);
  static constexpr std::array links{cca::link_inertia{1, {}, {0.01, 0.01, 0.01}},
                                    cca::link_inertia{1, {}, {0.01, 0.01, 0.01}}};
};
struct body : cca::body<trunk, cca::part<"leg", chain>> {
  static constexpr cca::link_inertia base{3, {}, {0.1, 0.1, 0.1}};
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"stance", stance>,
                         cca::node<"log", logbook>>,
              cca::recordable,
#if CCA_REJECT
              cca::shows<body, "cpg.phase">
#else
              cca::shows<body, "stance.angles">
#endif
{
};

static_assert(cca::check<walk>());
