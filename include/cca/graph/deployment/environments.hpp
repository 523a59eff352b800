// The environments of a deployment as values.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <cca/base/array_size.hpp>
#include <cca/graph/diagnosis/message_writer.hpp>
#include <cca/graph/items/deployment.hpp>
#include <cca/graph/modes/mode_info.hpp>
#include <cca/graph/plan/items.hpp>

namespace cca {

// Options of an environment: runtime/environments/realtime.hpp.
template <int Number>
struct on_core;
template <int Priority, class... Where>
struct realtime;
template <int Priority, class... Where>
struct realtime_if_allowed;

}  // namespace cca

namespace cca::detail {

// A type that does not belong where it stands in a deployment; or a second option where one is enough.
enum class misplaced : std::uint8_t { none, item, nodes, option, second_option };

struct environment_info {
  std::string_view name{};
  const std::string_view* paths = nullptr;
  int path_count = 0;
  bool has_others = false;  // other_nodes
  bool is_free_running = false;
  misplaced mistake = misplaced::none;
  std::string_view unknown_type{};
};

// What a deployment states beside its environments.
struct deployment_info {
  std::string_view name{};
  std::string_view of_deployment{};  // its architecture is this deployment
  std::string_view mode{};           // of a set of modes: the one that is looked at
  int tolerate_count = 0, tolerated = 3;
};

template <class Option>
inline constexpr bool is_environment_option = false;
template <>
inline constexpr bool is_environment_option<free_running> = true;
template <int Priority, int... Core>
inline constexpr bool is_environment_option<realtime<Priority, on_core<Core>...>> = sizeof...(Core) <= 1;
template <int Priority, int... Core>
inline constexpr bool is_environment_option<realtime_if_allowed<Priority, on_core<Core>...>> =
    sizeof...(Core) <= 1;

template <fixed_string... Paths>
inline constexpr std::array<std::string_view, sizeof...(Paths) + 1> placed_paths{Paths.view()...,
                                                                                 std::string_view()};

template <class Nodes>
inline constexpr environment_info nodes_of_environment{.mistake = misplaced::nodes,
                                                       .unknown_type = type_name<Nodes>()};
template <>
inline constexpr environment_info nodes_of_environment<other_nodes>{.has_others = true};
template <fixed_string... Paths>
inline constexpr environment_info nodes_of_environment<nodes<Paths...>>{
    .paths = placed_paths<Paths...>.data(), .path_count = static_cast<int>(sizeof...(Paths))};

template <class Option>
constexpr void check_option(environment_info& info) {
  if (is_environment_option<Option> || info.mistake != misplaced::none) return;
  info.mistake = misplaced::option;
  info.unknown_type = type_name<Option>();
}

template <class Nodes, class... Options>
constexpr environment_info environment_item(std::string_view name) {
  environment_info info = nodes_of_environment<Nodes>;
  info.name = name;
  (check_option<Options>(info), ...);
  const int free = (0 + ... + std::is_same_v<Options, free_running>), others = sizeof...(Options) - free;
  info.is_free_running = free > 0;
  if ((free > 1 || others > 1) && info.mistake == misplaced::none) info.mistake = misplaced::second_option;
  return info;
}

template <class Item>
struct item_of_deployment {
  static constexpr bool is_environment = true;
  static constexpr environment_info info{.mistake = misplaced::item, .unknown_type = type_name<Item>()};
  using options = list<>;
};
template <fixed_string Name, class Nodes, class... Options>
struct item_of_deployment<environment<Name, Nodes, Options...>> {
  static constexpr bool is_environment = true;
  static constexpr environment_info info = environment_item<Nodes, Options...>(Name.view());
  using options = list<Options...>;
};
template <int Beats>
struct item_of_deployment<tolerate<Beats>> {
  static constexpr bool is_environment = false;
  static constexpr int tolerated = Beats;
};

template <class Items>
struct environments_in;
template <class... Items>
struct environments_in<list<Items...>> {
  static constexpr int count = (0 + ... + item_of_deployment<Items>::is_environment);
  static constexpr auto all = [] {
    std::array<environment_info, static_cast<std::size_t>(count) + 1> infos{};
    std::size_t n = 0;
    [[maybe_unused]] const auto add = [&]<class Item>(list<Item>) {
      if constexpr (item_of_deployment<Item>::is_environment) infos[n++] = item_of_deployment<Item>::info;
    };
    (add(list<Items>{}), ...);
    return infos;
  }();
  static constexpr deployment_info facts = [] {
    deployment_info info;
    [[maybe_unused]] const auto read = [&]<class Item>(list<Item>) {
      if constexpr (!item_of_deployment<Item>::is_environment) {
        info.tolerated = item_of_deployment<Item>::tolerated;
        ++info.tolerate_count;
      }
    };
    (read(list<Items>{}), ...);
    return info;
  }();
  static constexpr int tolerated = facts.tolerated;
};

// The options of environment E.
template <int E, class Items>
struct options_among;
template <int E, class First, class... More>
struct options_among<E, list<First, More...>>
    : options_among<E - item_of_deployment<First>::is_environment, list<More...>> {};
template <class First, class... More>
  requires item_of_deployment<First>::is_environment
struct options_among<0, list<First, More...>> {
  using type = typename item_of_deployment<First>::options;
};
template <class D, int E>
using options_of_environment = typename options_among<E, typename D::cca_environments>::type;

template <class D>
using environments_of = environments_in<typename D::cca_environments>;

template <class D>
inline constexpr int environment_count = environments_of<D>::count;

template <class D, int E>
inline constexpr bool is_free_running = environments_of<D>::all[array_size(E)].is_free_running;
template <class Graph>
inline constexpr bool has_free_running = false;
template <AnyDeployment D>
inline constexpr bool has_free_running<D> = [] {
  for (const environment_info& e : environments_of<D>::all)
    if (e.is_free_running) return true;
  return false;
}();

template <class D>
constexpr std::string_view name_of_environment(std::size_t environment) {
  return environments_of<D>::all[environment].name;
}

// A deployment that is no named struct has its architecture in its name.
constexpr std::string_view deployment_name(std::string_view name) {
  return name.starts_with("deployment<") ? "the deployment" : name;
}

template <Deployment D>
inline constexpr deployment_info facts_of_deployment = [] {
  deployment_info info = environments_of<D>::facts;
  info.name = deployment_name(type_name<D>());
  if constexpr (Deployment<typename D::cca_architecture>)
    info.of_deployment = deployment_name(type_name<typename D::cca_architecture>());
  if constexpr (requires { typename D::cca_whole; }) {
    info.name = deployment_name(type_name<typename D::cca_whole>());
    info.mode = D::cca_mode_name;
    using architecture = typename D::cca_whole::cca_architecture;
    if constexpr (DeploymentOfModes<architecture>)
      info.of_deployment = deployment_name(type_name<architecture>());
  }
  return info;
}();

// What a deployment hangs on its plan, and on those of its modes and environments.
struct deployment_placement : hung_facts {
  constexpr deployment_placement(const environment_info* first,
                                 int number,
                                 const deployment_info* of,
                                 const modes_info* whole_set)
      : environments(first), count(number), deployment(of), modes(whole_set) {}
  const environment_info* environments;
  int count;
  const deployment_info* deployment;
  const modes_info* modes;  // the whole set, where the plan is that of one mode
};
// The whole set, if D is one mode of a deployment of modes.
template <class D>
inline constexpr const modes_info* set_of_mode = nullptr;
template <Deployment D>
inline constexpr deployment_placement placement_of{environments_of<D>::all.data(), environment_count<D>,
                                                   &facts_of_deployment<D>, set_of_mode<D>};

// Of a plan that is spread over environments.
constexpr const deployment_placement& placement_in(const flat_view& g) {
  return static_cast<const deployment_placement&>(*g.hung);
}
constexpr const environment_info& environment_in(const flat_view& g, int environment) {
  return placement_in(g).environments[environment];
}
constexpr int environment_of(const flat_view& g, int call) { return place_of(g, call); }

// Inside of a graph its environments would be ignored.
template <Deployment D>
struct deployment_as_node {
  static constexpr void refuse(flat_view& g, const finding& facts) {
    if (g.found.is_broken()) return;
    g.found = facts;
    g.found.rule = "deployment.bad_environment";
    g.found.tell = &tell;
  }
  static constexpr void tell(message_writer& m) {
    m.at_node();
    m.say() << "`" << m.where.view() << "` is the deployment " << facts_of_deployment<D>.name
            << ", but inside of a graph its environments would be ignored: make it a node of the "
               "architecture, "
            << m.item().inner->name << ", and deploy the graph around it";
  }
};

// As a graph it is called like its architecture, in which its nodes and wires are written.
template <Deployment D>
struct graph_facts<D> {
  static constexpr graph_info value = [] {
    graph_info info = graph_facts<typename D::cca_architecture>::value;
    info.refuse_as_node = &deployment_as_node<D>::refuse;
    return info;
  }();
};

}  // namespace cca::detail
