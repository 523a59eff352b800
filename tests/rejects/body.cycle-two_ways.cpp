// EXPECT: body\.cycle: the parts of this body close a loop: the chain of `[a-z_ ]+` ends in the frame plate, in which another chain ends too
// Two chains that end in one frame form a closed mechanism, which a tree cannot describe.
#include <cca/robot/body.hpp>

struct trunk : cca::frame<"trunk"> {};
struct plate : cca::frame<"plate"> {};
struct other_plate : cca::frame<"other plate"> {};
struct left : cca::dimension<"left"> {};
struct right : cca::dimension<"right"> {};

template <class Axis, class Tip>
struct leg : cca::serial_chain<trunk, Tip, cca::axes<Axis>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, -0.3);
};

#if CCA_REJECT
using ends_in = plate;
#else
using ends_in = other_plate;
#endif
struct robot
    : cca::body<trunk, cca::part<"left", leg<left, plate>>, cca::part<"right", leg<right, ends_in>>> {};
