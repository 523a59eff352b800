// How much uncertainty the Combination of Skills bears (sweep.hpp): its own judge says whether it succeeded.
//
//   uncertainty_skills --shape trot.shape --seeds 10 --engine compiled
#include <string>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../../examples/combination_of_skills/command_line.hpp"
#include "../../examples/combination_of_skills/rollout.hpp"
#include "../../examples/combination_of_skills/summary.hpp"
#include "../../examples/trot/uncertain.hpp"
#include "sweep.hpp"

namespace {

template <class World>
struct skilled : skills::architecture<trot::uncertain_oncilla<World>> {};

template <class World>
int run(const uncertain::options& o, const std::string& shape) {
  cca::controller<skilled<World>> start;
  skills::load(start, shape, {});
  return uncertain::sweep(o, [&](const uncertain::uncertainty& u, std::uint64_t seed) {
    auto c = start;
    c.template set<"robot.simulator">(u);
    skills::circumstances around;
    around.seed = seed;
    around.paw = seed % 2 == 0 ? skills::paw_side::left : skills::paw_side::right;
    around.ground = uncertain::ground_under(u, 1);
    around.physics = cca::sim::drawn_settings(u);
    const skills::result r = skills::roll_out(c, around, [] { return true; });
    return uncertain::verdict{!r.fell && r.last == skills::plan::at<"trot on">, skills::succeeded(r)};
  });
}

}  // namespace

int main(int count, char** words) {
  uncertain::options o;
  std::string shape = "trot.shape";
  cca::command_line line("how much uncertainty of each kind the Combination of Skills bears, on all cores");
  o.offer(line);
  skills::offer_shape(line, shape);
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? run<cca::sim::compiled_oncilla_world>(o, shape)
                                              : run<cca::sim::world>(o, shape);
  });
}
