// The controller of examples/trot, told what a robot sensed.
//
//   topics: /robot/angles/whole /robot/simulator/orientation
#include "told.hpp"

#include "../../../examples/trot/architecture.hpp"

namespace oncilla = cca::robots::oncilla;

struct told_robot {
  auto sense(cca::beat now) -> std::tuple<cca::out<"angles", oncilla::leg_angles>,
                                          cca::out<"orientation", oncilla::trunk_orientation>> {
    same_bits::all_sensed().of_beat(now.index(), [this](const same_bits::entry& e) {
      if (e.topic == 0) same_bits::put(e, angles);
      else same_bits::put(e, orientation);
    });
    return {angles, orientation};
  }
  void act(cca::in<"command", oncilla::leg_angles>) {}

  oncilla::leg_angles::vector_type angles = oncilla::leg_angles::vector_type::Zero();
  Eigen::Vector4d orientation{0, 0, 0, 1};
};

struct told_trot : trot::architecture<told_robot>, cca::recordable {};

int main() {
  return same_bits::run<told_trot>([](auto&) {}, [](auto&) {});
}
