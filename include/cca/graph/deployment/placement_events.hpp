// The events of a deployment, at which its rules are asked (graph/diagnosis/rule.hpp), the facts that these
// add, and who writes their messages.
#pragma once

#include <cca/graph/deployment/environments.hpp>
#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct deployment_rules;

// The environment that a rule is about, or -1.
constexpr int environment_of(const finding& f) { return f.numbers[0]; }

struct deployment_writer : message_writer {
  constexpr const deployment_info& deployment() const { return *placement_in(g).deployment; }
  // environment `mind`
  constexpr void environment(int e) { say() << "environment `" << environment_in(g, e).name << "`"; }
  // Of a deployment of modes, while one of them is looked at: of mode `trot`
  constexpr void of_mode() {
    if (const auto& in = deployment().mode; !in.empty()) say() << " of mode `" << in << "`";
  }
};

namespace when {

struct of_deployment {
  using asked = deployment_rules;
};

struct stated_deployment : of_deployment {};   // [no item]
struct stated_environment : of_deployment {};  // [environment, no item]
struct placed_path : of_deployment {};         // a path that names nothing [name, environment, no item]
struct placed_node : of_deployment {};  // named by a second environment [environment], or by none [node]
struct finished_environment : of_deployment {};  // all components have their place [environment, no item]
struct free_node : of_deployment {};             // a component of a free-running one [node, environment]
struct crossing : of_deployment {};              // a wire, or an observer's node, between two [input, output]
struct queue_shown_elsewhere : of_deployment {};  // an observer's node, of a queue in another [input, output]

}  // namespace when

}  // namespace cca::detail
