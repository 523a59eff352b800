// The laws of an Adaptive Component, stated once and run for each kind.
//
// A case is a graph with the component as node "skill", its feedback from the node "robot", and an item
// `observe<"skill.**.*">`. Within `Case::beats` beats it takes each status of `Case::expected()`, and no
// other.
#pragma once

#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <cca/adaptive/component_status.hpp>
#include <cca/runtime/controller.hpp>

#include "ode_laws.hpp"

namespace laws {

template <class Graph>
std::map<std::string, std::vector<double>> told(const cca::controller<Graph>& c) {
  std::map<std::string, std::vector<double>> all;
  c.observed([&](const cca::observation& one) {
    all[std::string(one.path)] = {one.values.begin(), one.values.end()};
  });
  return all;
}

template <class Case>
void runs_as_it_states() {
  using graph = typename Case::graph;
  cca::controller<graph> c;
  Case::prepare(c);
  c.load();
  c.start();
  auto at = c.template get<"skill">();
  const auto limits = at.template get<"criterion">().p.limits;
  std::set<cca::component_status> seen;
  std::size_t allocated = 0;
  bool true_status = true, true_state = true, same = true;
  cca::controller<graph> copy = c;
  for (int k = 0; k < Case::beats; ++k) {
    if (k == Case::beats / 2) copy = c;
    const std::size_t before = allocations();
    c.step();
    allocated += allocations() - before;
    const auto now = told(c);
    const auto state = static_cast<cca::criterion_state>(now.at("skill.criterion.state")[0]);
    const auto component = static_cast<cca::component_status>(now.at("skill.status.component")[0]);
    const auto& module = now.at("skill.status.module");
    const bool rests =
        !Case::at_rest || now.at("skill.status.ode")[0] == cca::status_of(cca::ode_status::converged);
    true_status &=
        component == cca::component_status_from(state, static_cast<cca::trained_region>(module[1]), rests);
    const double error = now.at("skill.criterion.error")[0];
    true_state &= state != cca::criterion_state::fulfilled || error <= limits.until;
    true_state &= state != cca::criterion_state::lost || !(error <= limits.until);
    seen.insert(component);
    if (k < Case::beats / 2) continue;
    copy.step();
    same &= told(copy) == now;
  }
  CHECK_MESSAGE(allocated == 0, "nothing allocates in a beat");
  CHECK_MESSAGE(true_status, "component status follows from ode status, module status and criterion");
  CHECK_MESSAGE(true_state, "fulfilled means near, lost means far");
  CHECK_MESSAGE(same, "a copy continues like the original, bit for bit");
  CHECK_MESSAGE(seen == Case::expected(), "it took all expected statuses");
}

template <class Case>
void adaptive_component() {
  law("runs as its statuses state", runs_as_it_states<Case>);
}

}  // namespace laws
