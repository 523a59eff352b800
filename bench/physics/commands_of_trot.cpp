// The recording: the architecture of examples/trot in the compiled world.
#include "commands_of_trot.hpp"

#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../../examples/trot/rollout.hpp"

namespace bench {

namespace {
struct compiled_trot : trot::architecture<cca::sim::compiled_oncilla> {};
}  // namespace

recorded_trot trot_of(double seconds) {
  namespace sim = cca::sim;
  cca::controller<compiled_trot> c;
  c.load();
  recorded_trot t;
  auto run = trot::begin(c, sim::terrain::flat(), sim::disturbance::none(), seconds);
  const auto& world = c.get<"robot.simulator">().world();
  for (std::size_t k = 0; k < 16; ++k) t.start[k] = world.joints()[k].angle;
  t.height = world.frame(-1).where.at[2];
  trot::walked(c, std::move(run), seconds, [&](const auto& w, double) {
    t.beats.push_back(w.laws());
    return true;
  });
  return t;
}

}  // namespace bench
