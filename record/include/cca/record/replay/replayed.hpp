// A graph, deployment or set of modes whose resource nodes sense what a recording says, and act on nothing:
// the same nodes, wires and ports, with `replayed<Robot>` in the place of each resource node. Its hooks don't
// run, so no bus is opened and no world simulated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/component/component.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/parameters.hpp>
#include <cca/graph/deployment.hpp>
#include <cca/graph/modes.hpp>
#include <cca/graph/recordable.hpp>
#include <cca/runtime/controller.hpp>

namespace cca::recording::detail {

template <class Function>
struct replayed_sense;
template <class Result, class... Parameters>
struct replayed_sense<cca::detail::list<Result, Parameters...>> {
  Result next{};
  Result sense(const Parameters&...) { return next; }
};
template <class Function>
struct replayed_act;
template <class... Parameters>
struct replayed_act<cca::detail::list<void, Parameters...>> {
  void act(const Parameters&...) {}
};
template <class Result, class... Parameters>
struct replayed_act<cca::detail::list<Result, Parameters...>> {
  Result acted{};
  Result act(const Parameters&...) { return acted; }
};

template <class Result, class Parameters>
struct signature_list;
template <class Result, class... Parameters>
struct signature_list<Result, cca::detail::list<Parameters...>> {
  using type = cca::detail::list<Result, Parameters...>;
};
template <class Function>
using signature_of =
    typename signature_list<typename cca::detail::function_facts<Function>::result,
                            typename cca::detail::function_facts<Function>::parameters>::type;

template <class Robot, bool Senses = cca::detail::HasSense<Robot>>
struct senses_again {};
template <class Robot>
struct senses_again<Robot, true> : replayed_sense<signature_of<decltype(&Robot::sense)>> {};
template <class Robot, bool Acts = cca::detail::HasAct<Robot>>
struct acts_again {};
template <class Robot>
struct acts_again<Robot, true> : replayed_act<signature_of<decltype(&Robot::act)>> {};
template <class Robot, bool HasSome = HasParameters<Robot>>
struct parameters_again {};
template <class Robot>
struct parameters_again<Robot, true> {
  using parameters = typename Robot::parameters;
  parameters p = Robot().p;
};

}  // namespace cca::recording::detail

namespace cca::recording {

template <ResourceNode Robot>
struct replayed : detail::senses_again<Robot>, detail::acts_again<Robot>, detail::parameters_again<Robot> {
  // Nothing is published in the next beat, but what `put` and `fail` say.
  void forget() {
    with_results([](auto& results) { results = {}; });
  }
  // The output number `port` of sense, or of act.
  void put(cca::detail::phase_of_beat phase, int port, std::int64_t origin, const double* coordinates) {
    with_results(phase, [&](auto& results) {
      int n = 0;
      each(results, [&]<class One>(One& one) {
        if constexpr (cca::detail::result_facts<One>::kind == cca::detail::result_kind::output)
          if (n++ == port) {
            for (int c = 0; c < One::space::size; ++c) one.vector()[c] = coordinates[c];
            one.with_origin(origin);
          }
      });
    });
  }
  // In the beat in which it failed. Whether sense or act did is not recorded: what both published is fed.
  void fail(const char* reason) {
    with_results([&](auto& results) {
      each(results, [&]<class One>(One& one) {
        if constexpr (std::is_same_v<One, fault>) one = fault(reason);
      });
    });
  }

private:
  template <class F>
  void with_results(F f) {
    with_results(cca::detail::phase_of_beat::sense, f);
    with_results(cca::detail::phase_of_beat::act, f);
  }
  template <class F>
  void with_results([[maybe_unused]] cca::detail::phase_of_beat phase, [[maybe_unused]] F f) {
    if constexpr (requires(replayed& r) { r.next; })
      if (phase == cca::detail::phase_of_beat::sense) f(this->next);
    if constexpr (requires(replayed& r) { r.acted; })
      if (phase == cca::detail::phase_of_beat::act) f(this->acted);
  }
  template <class Results, class F>
  static void each(Results& results, F f) {
    if constexpr (requires { std::tuple_size<Results>::value; })
      std::apply([&](auto&... all) { (f(all), ...); }, results);
    else f(results);
  }
};

template <class Graph>
struct replaying : Graph {};

// A deployment is replayed in one loop, which computes the same.
template <Deployment D>
struct replaying<D> : recordable {
  using cca_items = typename D::cca_items;
};

// Of a set of modes each mode.
template <class Items>
struct replaying_modes;
template <fixed_string... Name, class... Graph>
struct replaying_modes<cca::detail::list<mode<Name, Graph>...>> : modes<mode<Name, replaying<Graph>>...> {};
template <Modes M>
struct replaying<M> : replaying_modes<typename M::cca_modes>, recordable {};

}  // namespace cca::recording

namespace cca::detail {

template <class Component>
struct component_in_replay {
  using type = Component;
};
template <ResourceNode Component>
struct component_in_replay<Component> {
  using type = recording::replayed<Component>;
};

template <class Graph, int Node>
  requires(!Modes<Graph>)
struct node_types<recording::replaying<Graph>, Node> {
  using component = typename component_in_replay<typename node_types<Graph, Node>::component>::type;
  using strategy = typename node_types<Graph, Node>::strategy;
};

}  // namespace cca::detail
