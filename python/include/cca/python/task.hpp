// What Python trains: a graph around a policy, and how an episode begins.
//
//   struct walk : cca::python::task<around_policy, "gait.policy", "score"> {
//     static void begin(controller& c, std::uint64_t seed) {         // c is loaded and not started
//       c.get<"robot.simulator">().put_down(world_of(seed));
//     }
//     static void before_beat(controller& c) {                       // optional
//       c.get<"truth">().speed = c.get<"robot.simulator">().world().trunk_velocity()[0];
//     }
//   };
//
//   Graph    closed; everything that a copy of its controller holds is the episode's own
//   Policy   the path of its stand_in, which is `timed`
//   Score    the path of its score
//
// `begin` draws all that differs between episodes from the seed: the same seed, the same episode, bit for
// bit. `before_beat` gives the graph what no sensor of the robot measures. Both run on several threads, each
// with a controller of its own. An episode ends with `score.done`, with a fault, or after `seconds`.
//
// One beat is looked at ahead: to show Python what the policy sees in its beat, a copy of the controller runs
// that beat, and is thrown away. So a node that writes a file or sends a frame does it twice.
#pragma once

#include <cca/base/fixed_string.hpp>
#include <cca/runtime/controller.hpp>

namespace cca::python {

template <class Graph, fixed_string Policy = "policy", fixed_string Score = "score">
struct task {
  using controller = cca::controller<Graph>;
  static constexpr double seconds = 10;  // of an episode, unless Python says otherwise; 0: no end

  static auto& policy_of(controller& c) { return c.template get<Policy>(); }
  static auto& score_of(controller& c) { return c.template get<Score>(); }
};

}  // namespace cca::python
