// Stops that a fast joint does not run through.
//
// The engine notices a stop when a joint is beyond it: at 40 rad/s and a step of 10 ms, 0.4 rad too late. So
// before a step a joint that would be more than `near` beyond a stop at its end, or whose forces are stiff
// and could bring it there at any speed, gets the stop as a bound of its speed: the way that is left, in one
// step. The engine's own joints have only stops that were passed; this one is a passed stop with a negative
// error reduction. Joints that reach a stop slowly are left to the engine.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <ode/ode.h>

#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

class stops_in_engine {
public:
  stops_in_engine(const robot_model& model, const tree_in_engine& tree, double erp)
      : changed_(model.links.size(), 0), reach_(model.links.size(), 0), erp_(erp) {
    for (std::size_t i = 0; i < reach_.size(); ++i)
      if (tree.leads(i))
        reach_[i] =
            stop_reach(model.links[i], model.stops[static_cast<std::size_t>(model.links[i].coordinate)]);
  }

  // Before a step. `is_stiff(c)`: a force on that coordinate is.
  template <class IsStiff>
  void act(const robot_model& model,
           const tree_in_engine& tree,
           const std::vector<joint_reading>& joints,
           double step,
           IsStiff is_stiff) {
    for (std::size_t i = 0; i < reach_.size(); ++i) {
      if (!(reach_[i] > 0)) continue;
      const auto c = static_cast<std::size_t>(model.links[i].coordinate);
      const double end = joints[c].angle + step * joints[c].velocity;
      const joint_stops& s = model.stops[c];
      if (end > s.high + near || end < s.low - near || is_stiff(c)) bound(model, tree, i, end > s.middle());
      else if (changed_[i]) unbound(tree, i);
    }
  }

private:
  static constexpr double near = 0.01;  // rad, m

  void bound(const robot_model& model, const tree_in_engine& tree, std::size_t i, bool upwards) {
    constexpr double passed = 1e-3;
    const double at = tree.joint_of(i).position();
    const bool to_high = upwards == (model.links[i].ratio > 0);
    const double left = to_high ? reach_[i] - at : at + reach_[i];
    unbound(tree, i);
    if (!(left > 0)) return;  // the engine's stop holds it
    tree.joint_of(i).set(to_high ? dParamHiStop : dParamLoStop, to_high ? at - passed : at + passed);
    tree.joint_of(i).set(dParamStopERP, -left / passed);
    changed_[i] = 1;
  }
  void unbound(const tree_in_engine& tree, std::size_t i) {
    tree.joint_of(i).set(dParamLoStop, -reach_[i]);
    tree.joint_of(i).set(dParamHiStop, reach_[i]);
    tree.joint_of(i).set(dParamStopERP, erp_);
    changed_[i] = 0;
  }

  std::vector<char> changed_;  // over the links
  std::vector<double> reach_;  // of their joints, each way; 0: no stops
  double erp_;
};

}  // namespace cca::sim
