// How much uncertainty the trot bears (sweep.hpp): bounds.hpp of the trot judges it. It goes on if it does
// not fall, and is half as fast as that asks.
//
//   uncertainty_trot --config trot.toml --seeds 10 --engine compiled
#include <string>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../../examples/trot/report/bounds.hpp"
#include "../../examples/trot/rollout.hpp"
#include "on_drawn_ground.hpp"

namespace {

template <class World>
int run(const uncertain::options& o, const std::string& config) {
  cca::controller<trot::uncertain_trot<World>> start;
  if (config.empty()) start.load();
  else start.load(config);
  const double commanded = start.template get<"gait">().p.duty;
  const auto rolled = [&](auto& c, const auto& ground, const auto& disturbance, const auto& settings) {
    return trot::evaluate(trot::roll_out(c, ground, disturbance, o.seconds, [] { return true; }, settings));
  };
  return uncertain::sweep(
      o, uncertain::on_drawn_ground(o, start, 0.5 * trot::bounds().least_cruise, rolled,
                                    [&](const auto& figures) { return trot::keeps(figures, commanded); }));
}

}  // namespace

int main(int count, char** words) {
  uncertain::options o;
  std::string config;
  cca::command_line line("how much uncertainty of each kind the trot bears, on all cores");
  o.offer(line);
  line.text("--config FILE", config, "parameters (the defaults in the code)");
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? run<cca::sim::compiled_oncilla_world>(o, config)
                                              : run<cca::sim::world>(o, config);
  });
}
