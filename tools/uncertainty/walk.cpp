// How much uncertainty the learned gait bears (sweep.hpp): worth.hpp of the walking policy judges it. It goes
// on if it does not fall, and is half as fast as commanded.
//
//   uncertainty_walk --weights walk.policy --seeds 10 --engine compiled
#include <string>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>
#include <cca/sim/uncertain/uncertain_robot.hpp>

#include "../../examples/walking_policy/trial.hpp"
#include "../../examples/walking_policy/worth.hpp"
#include "on_drawn_ground.hpp"

namespace {

template <class World>
struct walking_robot : walking::architecture<walking::uncertain_oncilla<World>> {};

template <class World>
int run(const uncertain::options& o, const std::string& weights) {
  cca::controller<walking_robot<World>> start;
  walking::name_weights(start, weights);
  start.load();
  const walking::command wanted{start.template get<"gait.throttle">().p.speed};
  const auto rolled = [&](auto& c, const auto& ground, const auto& disturbance, const auto& settings) {
    return walking::along_its_way(
        walking::roll_out(c, ground, disturbance, o.seconds, [] { return true; }, settings));
  };
  return uncertain::sweep(
      o, uncertain::on_drawn_ground(o, start, 0.5 * wanted.speed, rolled,
                                    [&](const auto& figures) { return walking::walks(figures, wanted); }));
}

}  // namespace

int main(int count, char** words) {
  uncertain::options o;
  o.first = 1000;  // the training has not used these
  std::string weights = "walk.policy";
  cca::command_line line("how much uncertainty of each kind the learned gait bears, on all cores");
  o.offer(line);
  line.text("--weights FILE", weights, "of the policy (walk.policy)");
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? run<cca::sim::compiled_oncilla_world>(o, weights)
                                              : run<cca::sim::world>(o, weights);
  });
}
