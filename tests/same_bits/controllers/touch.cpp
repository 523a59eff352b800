// The controller of examples/touch, told what an arm sensed.
//
//   topics: /robot/angles/whole /robot/velocities/whole /robot/torques/whole /robot/simulator/flange_load
#include "told.hpp"

#include "../../../examples/touch/architecture.hpp"
#include "../../../examples/touch/learn.hpp"

namespace arm = touch::arm;

struct told_robot {
  auto sense(cca::beat now) -> std::tuple<cca::out<"angles", arm::angles>,
                                          cca::out<"velocities", arm::velocities>,
                                          cca::out<"torques", arm::torques>,
                                          cca::out<"flange_load", touch::load_in_flange>> {
    same_bits::all_sensed().of_beat(now.index(), [this](const same_bits::entry& e) {
      if (e.topic == 0) same_bits::put(e, angles);
      else if (e.topic == 1) same_bits::put(e, velocities);
      else if (e.topic == 2) same_bits::put(e, torques);
      else same_bits::put(e, load);
    });
    return {angles, velocities, torques, load};
  }
  void act(cca::in<"torque", arm::torques>) {}

  arm::angles::vector_type angles = arm::angles::vector_type::Zero(), velocities = angles, torques = angles;
  touch::load_in_flange::vector_type load = touch::load_in_flange::vector_type::Zero();
};

struct told_arm : touch::architecture<told_robot>, cca::recordable {};

int main() {
  int step = 0;
  return same_bits::run<told_arm>(
      [](auto& c) {
        c.template get<"orders">().p.shift = {0.08856639605533007, -0.03714614156885028,
                                              -0.02785960617663771};  // of seed 0
      },
      [&step](auto& c) {  // learns as examples/touch does
        const int now = c.template get<"sequencer">().steps.step();
        if (now != step && now == touch::plan::at<"learn">) touch::learn(c);
        step = now;
      });
}
