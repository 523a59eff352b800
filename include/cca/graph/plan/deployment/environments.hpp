// The environments of a deployment as values.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/array_size.hpp>
#include <cca/graph/deployment.hpp>
#include <cca/graph/plan/items.hpp>

namespace cca::detail {

struct environment_info {
  std::string_view name{};
  const std::string_view* paths = nullptr;
  int path_count = 0;
  bool has_others = false;          // other_nodes
  std::string_view unknown_type{};  // an item of a deployment that is none
};

template <fixed_string... Paths>
inline constexpr std::array<std::string_view, sizeof...(Paths) + 1> placed_paths{Paths.view()...,
                                                                                 std::string_view()};

template <class Nodes>
constexpr environment_info placement_of(std::string_view name) {
  return {.name = name, .unknown_type = type_name<Nodes>()};
}
template <>
constexpr environment_info placement_of<other_nodes>(std::string_view name) {
  return {.name = name, .has_others = true};
}
template <class Nodes>
struct named_paths {
  static constexpr environment_info in(std::string_view name) { return placement_of<Nodes>(name); }
};
template <fixed_string... Paths>
struct named_paths<nodes<Paths...>> {
  static constexpr environment_info in(std::string_view name) {
    return {.name = name,
            .paths = placed_paths<Paths...>.data(),
            .path_count = static_cast<int>(sizeof...(Paths))};
  }
};

template <class Item>
struct item_of_deployment {
  static constexpr bool is_environment = true;
  static constexpr environment_info info{.unknown_type = type_name<Item>()};
  using options = list<>;
};
template <fixed_string Name, class Nodes, class... Options>
struct item_of_deployment<environment<Name, Nodes, Options...>> {
  static constexpr bool is_environment = true;
  static constexpr environment_info info = named_paths<Nodes>::in(Name.view());
  using options = list<Options...>;
};
template <int Beats>
struct item_of_deployment<tolerate<Beats>> {
  static_assert(Beats >= 0, "cca::tolerate: a number of late beats, 0 or more");
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
    const auto add = [&]<class Item>(list<Item>) {
      if constexpr (item_of_deployment<Item>::is_environment) infos[n++] = item_of_deployment<Item>::info;
    };
    (add(list<Items>{}), ...);
    return infos;
  }();
  static constexpr int tolerated = [] {
    int beats = 3;
    const auto read = [&]<class Item>(list<Item>) {
      if constexpr (!item_of_deployment<Item>::is_environment) beats = item_of_deployment<Item>::tolerated;
    };
    (read(list<Items>{}), ...);
    return beats;
  }();
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

}  // namespace cca::detail
