// The graphs whose pictures are compared.
#pragma once

#include "counting.hpp"

namespace core_test {

// [describe]
struct angle_of_joint : cca::space<cca::joint_angles, cca::axes<cca::x>, cca::rate<1000>> {};

struct joint {
  auto sense() -> cca::out<"angle", angle_of_joint> { return 0; }
};
struct filter {
  auto process(cca::in<"raw", angle_of_joint> x) -> cca::out<"smooth", angle_of_joint> { return x; }
};
struct display {
  void process(cca::in<"angle", angle_of_joint>, cca::in<"count", reading>) {}
};

struct smoothing : cca::graph<cca::node<"first", filter>,
                              cca::node<"second", filter>,
                              cca::wire<"first.smooth", "second.raw", cca::delayed<2>>,
                              cca::expose<"first.raw", "angle">,
                              cca::expose<"second.smooth", "angle_out">> {};

struct shown : cca::graph<cca::node<"joint", joint>,
                          cca::node<"smooth", smoothing>,
                          cca::node<"counter", counter, cca::timed<20>>,
                          cca::node<"display", display, cca::any_of<cca::moderate, cca::timeout<50>>>,
                          cca::wire<"joint.angle", "smooth.angle">,
                          cca::wire<"smooth.angle_out", "display.angle", cca::latest>,
                          cca::wire<"counter.y", "display.count", cca::queue<4, cca::drop_oldest>>> {};
// [describe end]

}  // namespace core_test
