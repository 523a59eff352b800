#pragma once
// The circumstances of a run of the training: what is commanded, the disturbance, and how far robot and
// ground are from their description. Each trial has a number of its own, and all is drawn from it, so a judge
// that takes other numbers has other trials.
#include <cstdint>

#include <cca/cca.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/uncertain/uncertainty.hpp>

#include "../trot/uncertain.hpp"
#include "rollout.hpp"
#include "way.hpp"

namespace walking {

using trot::uncertain_oncilla;

// A training with the seed n takes the numbers from n times this on; those below are left to a judge.
inline constexpr std::uint64_t first_of_training = 1'000'000;

struct trial {
  std::uint64_t number = 0;
  command wanted{};
  cca::sim::uncertainty uncertain{};
};

// A third of all trials goes straight on.
inline trial drawn_trial(std::uint64_t number) {
  cca::sim::uniform_numbers draw(number * 104729 + 7);
  trial t;
  t.number = number;
  t.wanted.speed = draw.between(0.15, 0.7);
  t.wanted.turn = draw.between(-0.55, 0.55);
  if (number % 3 == 0) t.wanted.turn = 0;
  t.uncertain = trot::uncertainty_of(number, draw.between(0, 1));
  return t;
}

// A run of a loaded controller whose robot is uncertain, in steps.
template <class Controller, class Between>
auto attempt(Controller& c,
             const trial& t,
             double seconds,
             Between between,
             const cca::sim::terrain& like = cca::sim::terrain::flat()) {
  command_walk(c, t.wanted);
  return trot::on_drawn_ground(
      c, t.uncertain, cca::sim::disturbance::from_seed(t.number, seconds), like,
      [&](auto& of, const auto& ground, const auto& disturbance, const auto& settings) {
        return trot::run_in_steps(of, begin(of, ground, disturbance, seconds, settings), seconds, between);
      });
}

}  // namespace walking
