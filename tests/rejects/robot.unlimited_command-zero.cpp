// EXPECT: robot\.unlimited_command: `split\.angles` may be read before a first command has passed a limiter, and would then hold zero, which lies outside of the limits of `ankle`, on its way to the actuator `drive\.command`
// Where zero is no allowed command, a wire that an actuator may read before a first one has come says what it holds until then.
#include "parts.hpp"

struct ankle : cca::dimension<"ankle"> {
  static constexpr auto limits = cca::limits{cca::angle{0.3, 1.5}};
};
struct ankle_angle : cca::space<cca::joint_angles, cca::axes<ankle>> {};

struct flexed {
  auto process() -> cca::out<"angles", ankle_angle> { return 0.7; }
};

struct drive {
  void act(cca::in<"command", cca::sub_space<ankle_angle, ankle>>) {}
};

struct walk : cca::graph<
    cca::rate<1000>,
    cca::node<"flexed", flexed, cca::timed<10, 9>>,
    cca::node<"limits", cca::limiter<ankle_angle>>,
    cca::node<"split", cca::splitter<"angles", ankle_angle>, cca::timed<1>>,
    cca::node<"drive", drive>,
    cca::wire<"flexed.angles", "limits.command">,
#if CCA_REJECT
    cca::wire<"limits.safe", "split.angles", cca::latest>,
#else
    cca::wire<"limits.safe", "split.angles", cca::latest, cca::initial<0.5>>,
#endif
    cca::wire<"split.ankle", "drive.command">> {};

cca::controller<walk> c;
