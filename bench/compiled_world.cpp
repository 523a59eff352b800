// A beat of physics of the described Oncilla, compiled from its description, and in the Open Dynamics Engine.
//
//   compiled_world compiled|engine flying|standing|treading|table|balls BEATS
//
//   flying    nothing is below it; hips and knees follow sines of 4 Hz
//   standing  on a floor, at rest
//   treading  the same sines on the floor: feet land and leave
//   table     the same on a box, with three more of them near
//   balls     as treading, with four balls beside it on the floor
//
// Cables, springs and stops are as described. Instructions of a beat are the difference of two runs under
// valgrind --tool=callgrind; docs/physics.md has them.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <cca/robots/oncilla/description.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

namespace bench {

namespace sim = cca::sim;
using walking = cca::robots::oncilla::description;

std::array<sim::joint_law, 16> targets(int beat, bool moves) {
  std::array<sim::joint_law, 16> laws;
  for (std::size_t c = 0; c < laws.size(); ++c) {
    const auto& d = walking::drives[c];
    const double side = c / 4 % 3 == 0 ? 1 : -1, phase = 0.025 * beat;  // 4 Hz
    const double swing = !moves       ? 0
                         : c % 4 == 1 ? 0.25 * side * std::sin(phase)
                         : c % 4 == 2 ? 0.3 * (1 - std::cos(phase))
                                      : 0;
    laws[c] = {
        .position = walking::start[c] + swing, .stiffness = d.position_stiffness(), .damping = d.damping};
  }
  return laws;
}

template <class World>
int run(World world, int beats, bool moves) {
  for (int i = 0; i < beats; ++i) world.advance(targets(i, moves));
  std::printf("%.9f\n", world.joints()[2].angle);
  return world.trouble() ? 1 : 0;
}

}  // namespace bench

int main(int argc, char** argv) {
  const std::string_view world = argc > 1 ? argv[1] : "", what = argc > 2 ? argv[2] : "";
  const bool flies = what == "flying", stands = what == "standing", on_table = what == "table",
             has_balls = what == "balls";
  const bool is_right = (flies || stands || what == "treading" || on_table || has_balls) &&
                        (world == "compiled" || world == "engine");
  if (argc != 4 || !is_right) {
    std::fprintf(stderr,
                 "usage: compiled_world compiled|engine flying|standing|treading|table|balls BEATS\n");
    return 2;
  }
  constexpr double floor = -0.19;
  bench::sim::scene around;
  if (on_table) {
    around.add(bench::sim::fixed_box{{4, 4, 0.1}, cca::at(0, 0, floor - 0.05)});
    for (const double y : {-0.5, 0.5, 1.0})
      around.add(bench::sim::fixed_box{{4, 0.1, 0.4}, cca::at(0, y, 0)});
  } else if (!flies) {
    around.floor = floor;
  }
  for (int i = 0; has_balls && i < 4; ++i)
    around.add(bench::sim::ball{.radius = 0.05, .mass = 0.1, .position = {0.2 * i, 1, floor + 0.05}});
  const int beats = std::atoi(argv[3]);
  if (world == "compiled")
    return bench::run(bench::sim::compiled_world<bench::walking>(around), beats, !stands);
  return bench::run(bench::sim::robot_world(bench::sim::model_of<bench::walking>(), around), beats, !stands);
}
