#pragma once
// The judge of a quadruped that sweep.hpp asks.
#include <cstdint>

#include <cca/sim/oncilla/disturbance.hpp>

#include "../../examples/trot/uncertain.hpp"
#include "sweep.hpp"

namespace uncertain {

// `start` with what is uncertain, on the ground of a disturbance, both drawn from
// the seed. rolled(controller, ground, disturbance, settings of the world) are the figures of its run; it
// goes on if it has not fallen and cruises at `least`, m/s; is_good(figures).
template <class Controller, class Rolled, class Good>
auto on_drawn_ground(const options& o, const Controller& start, double least, Rolled rolled, Good is_good) {
  return [&o, &start, least, rolled, is_good](const uncertainty& u, std::uint64_t seed) {
    Controller c = start;
    const auto figures = trot::on_drawn_ground(c, u, cca::sim::disturbance::from_seed(seed, o.seconds),
                                               cca::sim::terrain::flat(), rolled);
    return verdict{!figures.fell && figures.cruise >= least, is_good(figures)};
  };
}

}  // namespace uncertain
