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

// A limiter in front of a splitter: the whole way to each joint counts.
template <class Axis>
struct joint {
  void act(cca::in<"command", cca::sub_space<leg_angles, Axis>>) {}
};
template <cca::fixed_string Limits, class Wire, class... More>
using split_leg = cca::graph<cca::node<Limits, cca::limiter<leg_angles>>,
                             cca::node<"split", cca::splitter<"angles", leg_angles>>,
                             cca::node<"hip", joint<hip>>,
                             cca::node<"knee", joint<knee>>,
                             Wire,
                             cca::wire<"split.hip", "hip.command">,
                             cca::wire<"split.knee", "knee.command">,
                             More...>;
struct split_forward : split_leg<"limits",
                                 cca::wire<"limits.safe", "split.angles">,
                                 cca::node<"forward", holds<1>>,
                                 cca::wire<"forward.angles", "limits.command">> {};
struct split_backward : split_leg<"limits",
                                  cca::wire<"limits.safe", "split.angles">,
                                  cca::node<"backward", holds<-1>>,
                                  cca::wire<"backward.angles", "limits.command">> {};
struct split_otherwise : split_leg<"others",
                                   cca::wire<"others.safe", "split.angles">,
                                   cca::node<"backward", holds<-1>>,
                                   cca::wire<"backward.angles", "others.command">> {};
struct split_legs : cca::modes<cca::mode<"forward", split_forward>, cca::mode<"backward", split_backward>> {};
struct parted_legs : cca::modes<cca::mode<"forward", split_forward>,
                                cca::mode<"backward", split_backward>,
                                cca::mode<"otherwise", split_otherwise>> {};
static_assert(cca::well_formed<split_legs>);
static_assert(cca::diagnosis<parted_legs>.rule == "modes.command_jumps");
static_assert(cca::diagnosis<parted_legs>.where == "split.angles");
static_assert(cca::diagnosis<parted_legs>.message.starts_with(
    "modes.command_jumps: `split.angles` gets its commands from `limits.safe` in mode `forward` but from "
    "`others.safe` in mode `otherwise`"));

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
