#pragma once
// The demonstrator with the arm on drives: one type is another than in the simulator.
#include <utility>

#include "architecture.hpp"
#include "behind_drives.hpp"
#include "drives.hpp"
#include "rollout.hpp"

namespace touch {

// [on drives]
struct with_canopen : architecture<on_canopen::robot<memory_end>> {};
struct with_moteus : architecture<on_moteus::robot<memory_end>> {};
// [on drives end]

// Where the arm is: behind virtual drives.
template <class Joints, class Board>
struct on_virtual_drives {
  template <class Controller>
  void put_down(Controller& c, arm_world&& world) {
    far.connect(c);
    far.put_down(std::move(world));
  }
  template <class Controller>
  arm_world& world(Controller&) {
    return far.world();
  }
  template <class Controller>
  void after_beat(Controller&) {
    far.pass_millisecond();
  }

  behind_drives<Joints, Board> far{};
};
using behind_canopen = on_virtual_drives<on_canopen::joints, on_canopen::board>;
using behind_moteus = on_virtual_drives<on_moteus::joints, on_moteus::board>;

}  // namespace touch
