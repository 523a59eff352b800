// How an architecture is spread over environments. Each environment is a loop of its own; where a component
// runs never changes what it computes.
//
//   struct split : cca::deployment<skills<Robot>,
//       cca::environment<"robot", cca::nodes<"robot", "limits", "gait">>,
//       cca::environment<"mind",  cca::other_nodes>> {};
//
// A deployment is a graph too, that of its architecture: `check`, `diagnosis` and `describe` take it,
// and `controller<split>` runs it as one loop. `deployed<split>` runs its environments.
// The architecture may be a set of modes (cca/modes.hpp): then each of its modes is spread over the same
// environments, and all of them switch in the same beat. Paths are those of any mode.
// Errors: deployment.*, graph.unknown_item. Example: docs/environments.md.
#pragma once

#include <cca/graph/items/graph.hpp>
#include <cca/component/strategy.hpp>
#include <cca/graph/items/modes.hpp>

namespace cca {

// Components, or inner graphs (then all their components), by path.
template <fixed_string... Paths>
struct nodes {};

// All components that no other environment names.
struct other_nodes {};

// Options: how its thread runs (runtime/environments/realtime.hpp), and `free_running`.
template <fixed_string Name, class Nodes, class... Options>
struct environment {};

// An option: the environment holds components that compute as fast as they can, all of them `full_speed`. In
// a wall-clock run a cycle of it begins as soon as the last one has ended, on the newest samples that have
// come, and what it publishes arrives when the next beat begins. In a fast run, and in one loop, its
// components fire in every beat. Its wires need no `delayed`.
struct free_running {};

// In a wall-clock run: how many beats in a row a sample may come late; with more, the contact is lost.
template <int Beats>
struct tolerate {};

namespace detail {

template <>
inline constexpr std::string_view no_strategy_but<free_running> =
    "it is an option of an environment; the nodes in that are cca::full_speed";

// A type that is no graph has no items. Then the deployment is no graph either, and gets that message.
template <class Architecture>
struct items_of_architecture {};
template <Graph Architecture>
struct items_of_architecture<Architecture> {
  using cca_items = typename Architecture::cca_items;
};
template <Modes Architecture>
struct items_of_architecture<Architecture> {
  using cca_modes = typename Architecture::cca_modes;
};

}  // namespace detail

// Items: environments, and one `tolerate` (without it: 3). The first environment gives the beat.
template <class Architecture, class... Items>
struct deployment : detail::items_of_architecture<Architecture> {
  using cca_architecture = Architecture;
  using cca_environments = detail::list<Items...>;
};

template <class Type> concept Deployment = Graph<Type> && requires { typename Type::cca_environments; };

// A deployment of a set of modes.
template <class Type> concept DeploymentOfModes =
    Modes<Type> && requires { typename Type::cca_environments; };

// What cca::deployed runs.
template <class Type> concept AnyDeployment = Deployment<Type> || DeploymentOfModes<Type>;

}  // namespace cca
