// What is recorded of a controller: which loops it has, and what the recording says of them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/graph/marks/unmarked.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/graph/modes/plan_of_modes.hpp>
#include <cca/record/loops/recorded_loop.hpp>
#include <cca/runtime/environments/loop/active_beats.hpp>
#include <cca/runtime/environments/links/links_of_environment.hpp>

namespace cca {
template <class D>
class deployed;
}

namespace cca::recording::detail {

template <class D, int E>
struct beats_of_environment {
  static std::int64_t count(std::int64_t first, std::int64_t end) {
    std::int64_t all = 0;
    for (std::int64_t k = first; (k = cca::detail::next_active_beat<D, E>(k)) < end; ++k) ++all;
    return all;
  }
};

template <class D, int E>
struct beats_of_loop<cca::detail::part<D, E>> : beats_of_environment<D, E> {};
template <class D, int E>
struct beats_of_loop<cca::detail::modes_in<D, E>> : beats_of_environment<D, E> {};

inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& one : names) text.append(text.empty() ? "" : " ").append(one);
  return text;
}

template <class Controller>
struct recorded_loops {
  static_assert(cca::detail::holds_or_tells<
                false,
                cca::detail::not_observed<Controller, cca::detail::observer::recorder>>::value);
  struct whole : recordable {};  // so that there is one error
  using loops = std::tuple<>;
};

// A graph, or a set of modes: one loop.
template <class Graph>
struct recorded_loops<controller<Graph>> {
  using whole = Graph;
  using loops = std::tuple<std::unique_ptr<recorded_loop<Graph, Graph>>>;

  template <class F>
  static void for_each(controller<Graph>&, F f) {
    f.template operator()<0>();
  }
  static void attach(controller<Graph>& c, const loops& all) { c.record_into(std::get<0>(all).get()); }
  static void detach(controller<Graph>& c) { c.record_into(nullptr); }
  static std::vector<bool> nodes_here(const controller<Graph>&) {
    return std::vector<bool>(cca::detail::array_size(cca::detail::counts_of<Graph>.node_count), true);
  }

  static void add_outputs_of_others(const controller<Graph>&, std::vector<bool>&) {}

  static void describe(const controller<Graph>&, text_map&, [[maybe_unused]] text_map& modes) {
    if constexpr (Modes<Graph>) modes = {{"all", joined(names_of_modes())}};
  }
  static std::vector<std::string> names_of_environments() { return {{}}; }
  static std::vector<std::string> names_of_modes() {
    std::vector<std::string> all;
    if constexpr (Modes<Graph>)
      for (int m = 0; m < cca::detail::mode_count<Graph>; ++m)
        all.emplace_back(cca::detail::modes_of<Graph>::value.modes[m].name);
    return all;
  }
};

// A deployment: one for each environment of this process.
template <class D>
struct recorded_loops<deployed<D>> {
  using whole = D;
  template <class Numbers>
  struct of;
  template <int... E>
  struct of<std::integer_sequence<int, E...>> {
    using type = std::tuple<std::unique_ptr<recorded_loop<cca::detail::loop_key<D, E>, D>>...>;
  };
  using loops = typename of<std::make_integer_sequence<int, cca::detail::environment_count<D>>>::type;

  template <class F>
  static void for_each(deployed<D>& d, F f) {
    d.for_each_tap([&]<int E>(auto&) { f.template operator()<E>(); });
  }
  static void attach(deployed<D>& d, const loops& all) {
    d.for_each_tap([&]<int E>(auto& tap) { tap.set(std::get<E>(all).get()); });
    d.parameters_changed();
    if constexpr (Modes<D>) d.tell_mode_of_now();
  }
  static void detach(deployed<D>& d) {
    d.for_each_tap([&]<int E>(auto& tap) { tap.set(nullptr); });
  }
  static std::vector<bool> nodes_here(deployed<D>& d) {
    std::vector<bool> nodes(cca::detail::array_size(cca::detail::counts_of<D>.node_count), false);
    d.for_each_tap([&]<int E>(auto&) {
      for (std::size_t n = 0; n < nodes.size(); ++n)
        if (cca::detail::plan_of<D>.nodes[n].place == E) nodes[n] = true;
    });
    return nodes;
  }

  // What comes from free-running environments to the first one.
  static void add_outputs_of_others(deployed<D>& d, std::vector<bool>& outputs) {
    d.for_each_tap([&]<int E>(auto&) {
      for (std::size_t o = 0; o < outputs.size(); ++o)
        if (cca::detail::told_for_others<cca::detail::loop_key<D, E>>::holds(o)) outputs[o] = true;
    });
  }

  static void describe(deployed<D>& d, text_map& environments, [[maybe_unused]] text_map& modes) {
    if constexpr (Modes<D>) modes = {{"all", joined(names_of_modes())}};
    std::vector<std::string> here;
    d.for_each_tap([&]<int E>(auto&) { here.emplace_back(cca::detail::name_of_environment<D>(E)); });
    environments = {{"all", joined(names_of_environments())}, {"here", joined(here)}};
  }
  static std::vector<std::string> names_of_environments() {
    std::vector<std::string> all;
    for (std::size_t e = 0; e < cca::detail::array_size(cca::detail::environment_count<D>); ++e)
      all.emplace_back(cca::detail::name_of_environment<D>(e));
    return all;
  }
  static std::vector<std::string> names_of_modes() {
    std::vector<std::string> all;
    if constexpr (Modes<D>)
      for (int m = 0; m < cca::detail::mode_count<D>; ++m)
        all.emplace_back(cca::detail::modes_of<D>::value.modes[m].name);
    return all;
  }
};

}  // namespace cca::recording::detail
