// Two joints, the second driven by the first, and a door: what the page shows of a test of an input that has
// several axes. Each joint follows what drives it with a time constant of 20 ms, so every response is known.
//
//   cca_two_joints --door --quiet --seconds 600
#include <tuple>

#include <cca/cca.hpp>
#include <cca/main.hpp>
#include <cca/door.hpp>

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct knee_angle : cca::space<cca::joint_angles, cca::axes<knee>, cca::rate<1000>> {};

struct rest {
  auto process() -> cca::out<"angles", leg_angles> { return leg_angles::vector_type{0, 0}; }
};

struct leg {
  auto sense() -> std::tuple<cca::out<"angles", leg_angles>, cca::out<"knee", knee_angle>> {
    return {at, at[1]};
  }
  void act(cca::in<"command", leg_angles> to) {
    constexpr double share = 1e-3 / 0.02;
    at[1] += share * (at[0] - at[1]);
    at[0] += share * (to[hip{}] - at[0]);
  }
  leg_angles::vector_type at{0, 0};
};

struct two_joints : cca::graph<cca::node<"rest", rest>,
                               cca::node<"limits", cca::limiter<leg_angles>>,
                               cca::node<"leg", leg>,
                               cca::wire<"rest.angles", "limits.command">,
                               cca::wire<"limits.safe", "leg.command">,
                               cca::test_input<"limits.command", cca::up_to<0.2>>>,
                    cca::recordable {};

struct program : cca::robot_program<two_joints> {
  program() { purpose = "two joints, one driven by the other, to be tested through a door"; }
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
