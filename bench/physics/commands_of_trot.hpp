#pragma once
// What the trot of examples/trot tells the drives of the Oncilla, beat by beat, and where it begins: recorded
// once, so that every world gets the same.
#include <array>
#include <span>
#include <vector>

#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/engine/moving_frame.hpp>
#include <cca/sim/robot/model/joint_law.hpp>

namespace bench {

using walking = cca::robots::oncilla::as_built;
using laws_of_oncilla = std::array<cca::sim::joint_law, 16>;

struct recorded_trot {
  std::array<double, 16> start{};  // rad
  double height = 0;               // m, of the trunk
  std::vector<laws_of_oncilla> beats;
};

// On flat ground, undisturbed, in the compiled world.
recorded_trot trot_of(double seconds);

// Puts a world down there.
template <class World>
void put_down(World& w, const recorded_trot& t) {
  constexpr std::array<double, 16> still{};
  if constexpr (requires { w.place(t.start, still, cca::at(0, 0, 0), {}, {}); }) {
    w.place(t.start, still, cca::at(0, 0, t.height), {}, {});
  } else {
    cca::sim::moving_frame base;
    base.where.at[2] = t.height;
    w.place(t.start, still, base);
  }
}

}  // namespace bench
