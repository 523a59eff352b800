// Commands do not jump at a switch: the limiter that both modes share goes on from its last command.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <cca/modes.hpp>
#include <cca/robot.hpp>

#include "../robot/joints.hpp"

using namespace robot_test;

namespace {

template <int Sign>
struct holds {
  auto process(cca::beat) -> cca::out<"angles", leg_angles> {
    return leg_angles::vector_type{Sign * 0.6, -1.0 + Sign * 0.5};
  }
};
struct forward : cca::graph<cca::node<"forward", holds<1>>,
                            cca::node<"limits", cca::limiter<leg_angles>>,
                            cca::node<"leg", perfect_leg>,
                            cca::wire<"forward.angles", "limits.command">,
                            cca::wire<"leg.angles", "limits.measured">,
                            cca::wire<"limits.safe", "leg.command">> {};
struct backward : cca::graph<cca::node<"backward", holds<-1>, cca::timed<1>>,
                             cca::node<"limits", cca::limiter<leg_angles>>,
                             cca::node<"leg", perfect_leg>,
                             cca::wire<"backward.angles", "limits.command">,
                             cca::wire<"leg.angles", "limits.measured">,
                             cca::wire<"limits.safe", "leg.command">> {};
struct legs : cca::modes<cca::mode<"forward", forward>, cca::mode<"backward", backward>> {};

}  // namespace

TEST_SUITE("commands") {
  TEST_CASE("a switch in any beat changes no command by more than its rate") {
    cca::controller<legs> c;
    c.load();
    c.start();
    double before = c.get<"leg">().at[0], fastest = 0;
    for (int k = 0; k < 1500; ++k) {
      c.step();
      const double now = c.get<"leg">().at[0];
      fastest = std::max(fastest, std::abs(now - before));
      CHECK_GE(now - before, -5e-3 - 1e-12);  // -5 rad/s, 4 rad/s
      CHECK_LE(now - before, 4e-3 + 1e-12);
      before = now;
      if (k % 97 == 0) c.switch_to(c.mode() == "forward" ? "backward" : "forward");
    }
    CHECK_GE(fastest, 4e-3);
  }
}
