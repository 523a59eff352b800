// EXPECT: modes\.two_types: `robot\.leg` is leg_with_angles in mode `walk` but leg_without in mode `rest`: the modes of a set run on one robot, so give it one type in all of them
// All modes of a set run on the same robot.
#include <cca/modes.hpp>

#include "parts.hpp"

struct leg_with_angles {
  auto sense() -> cca::out<"angles", leg_angles> { return {}; }
};
struct leg_without {
  auto sense() -> cca::maybe<"angles", leg_angles> { return {}; }
};

template <class Leg>
struct one_leg : cca::graph<cca::node<"leg", Leg>, cca::expose<"leg.angles", "angles">> {};
template <class Leg>
struct watching : cca::graph<cca::rate<1000>,
                             cca::node<"robot", one_leg<Leg>>,
                             cca::node<"recorder", recorder>,
                             cca::wire<"robot.angles", "recorder.angles">> {};

struct walk : watching<leg_with_angles> {};
#if CCA_REJECT
struct rest : watching<leg_without> {};
#else
struct rest : watching<leg_with_angles> {};
#endif

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

cca::controller<legs> c;
