// A graph, deployment or set of modes whose resource nodes sense what a recording says, and act on nothing:
// the same nodes, wires and ports, with `replayed<Robot>` in the place of each resource node. Its hooks don't
// run, so no bus is opened and no world simulated. Of free-running environments also the components publish
// what was recorded (replayed_freely.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/component/component.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/parameters.hpp>
#include <cca/graph/items/deployment.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/graph/deployment/part.hpp>
#include <cca/graph/marks/recordable.hpp>
#include <cca/record/replay/replayed_freely.hpp>
#include <cca/record/replay/replayed_results.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/environments/exchange/crossing.hpp>

namespace cca::recording::detail {

template <class Function, bool IsFree>
struct replayed_sense;
template <class Returned, bool IsFree, class... Parameters>
struct replayed_sense<cca::detail::list<Returned, Parameters...>, IsFree> {
  using result = std::conditional_t<IsFree, irregular_result<Returned>, Returned>;
  result next{};
  result sense(const Parameters&...) { return next; }
};
template <class Function, bool IsFree>
struct replayed_act;
template <bool IsFree, class... Parameters>
struct replayed_act<cca::detail::list<void, Parameters...>, IsFree> {
  void act(const Parameters&...) {}
};
template <class Returned, bool IsFree, class... Parameters>
struct replayed_act<cca::detail::list<Returned, Parameters...>, IsFree> {
  using result = std::conditional_t<IsFree, irregular_result<Returned>, Returned>;
  result acted{};
  result act(const Parameters&...) { return acted; }
};

template <class Robot, bool IsFree, bool Senses = cca::detail::HasSense<Robot>>
struct senses_again {};
template <class Robot, bool IsFree>
struct senses_again<Robot, IsFree, true> : replayed_sense<signature_of<decltype(&Robot::sense)>, IsFree> {};
template <class Robot, bool IsFree, bool Acts = cca::detail::HasAct<Robot>>
struct acts_again {};
template <class Robot, bool IsFree>
struct acts_again<Robot, IsFree, true> : replayed_act<signature_of<decltype(&Robot::act)>, IsFree> {};
template <class Robot, bool HasSome = HasParameters<Robot>>
struct parameters_again {};
template <class Robot>
struct parameters_again<Robot, true> {
  using parameters = typename Robot::parameters;
  parameters p = Robot().p;
};

}  // namespace cca::recording::detail

namespace cca::recording {

// `IsFree`: of a free-running environment, whose samples arrived in any beat.
template <ResourceNode Robot, bool IsFree = false>
struct replayed : detail::senses_again<Robot, IsFree>,
                  detail::acts_again<Robot, IsFree>,
                  detail::parameters_again<Robot> {
  // Nothing is published in the next beat, but what `put` and `fail` say.
  void forget() {
    with_results([](auto& results) { results = {}; });
  }
  // The output number `port` of sense, or of act.
  void put(cca::detail::phase_of_beat phase, int port, std::int64_t origin, const double* coordinates) {
    with_results(phase, [&](auto& results) { detail::put_result(results, port, origin, coordinates); });
  }
  // In the beat in which it failed. Whether sense or act did is not recorded: what both published is fed.
  void fail(const char* reason) {
    with_results([&](auto& results) { detail::fail_result(results, reason); });
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

// Of a deployment of modes each mode knows what runs freely.
template <class Item, class Mode>
struct replaying_mode;
template <fixed_string Name, class Graph, class Mode>
struct replaying_mode<mode<Name, Graph>, Mode> {
  using type = mode<Name, replaying<Mode>>;
};
template <class D, class Numbers = std::make_integer_sequence<int, cca::detail::mode_count<D>>>
struct replaying_deployed;
template <class D, int... I>
struct replaying_deployed<D, std::integer_sequence<int, I...>>
    : modes<
          typename replaying_mode<cca::detail::mode_item<D, I>, cca::detail::deployed_mode<D, I>>::type...> {
};
template <DeploymentOfModes D>
  requires cca::detail::has_free_running<D>
struct replaying<D> : replaying_deployed<D>, recordable {};

}  // namespace cca::recording

namespace cca::detail {

template <class Graph>
inline constexpr bool is_always_probed<recording::replaying<Graph>> = true;

template <class Component, bool IsFree>
struct component_in_replay {
  using type = Component;
};
template <class Component>
  requires(!ResourceNode<Component>)
struct component_in_replay<Component, true> {
  using type = recording::detail::replayed_freely<Component>;
};
template <ResourceNode Component, bool IsFree>
struct component_in_replay<Component, IsFree> {
  using type = recording::replayed<Component, IsFree>;
};

template <class Graph, int Node>
  requires(!Modes<Graph>)
struct node_types<recording::replaying<Graph>, Node> {
  using component = typename component_in_replay<typename node_types<Graph, Node>::component,
                                                 is_free_node<Graph>(Node)>::type;
  using strategy = typename node_types<Graph, Node>::strategy;
};

// The clocks that hold after a switch are those of the deployment, whose samples are played.
template <DeploymentOfModes D>
  requires has_free_running<D>
inline constexpr bool is_checked_set<recording::replaying<D>> = true;

// A replay does not know in which beats the samples of a free-running environment will arrive. Of a set of
// modes what reads them fires by its clock while a fast run is replayed, as it did.
template <Deployment D>
  requires has_free_running<D>
inline constexpr flat_of<recording::replaying<D>> plan_of<recording::replaying<D>> =
    then<recording::replaying<D>>(finished<recording::replaying<D>>(), [](flat_view g) {
      for (int c = 0; c < g.call_count; ++c) {
        auto& one = g.calls[c];
        one.irregular = is_free_node<D>(one.node);
        if constexpr (DeployedMode<D>) {
          const auto& played = plan_of<D>.calls[array_size(c)];
          one.open_clock = played.open_clock;
          if (!one.irregular) one.fast_clock = played.own_clock;
        }
      }
      for (int i = 0; i < g.input_count; ++i) g.inputs[i].in_beat = g.inputs[i].own_initial = false;
      for (int o = 0; o < g.output_count; ++o) {
        auto& out = g.outputs[o];
        if (const int several = gathered_in_a_beat<D>[array_size(o)]; several > 0) out.in_a_beat = several;
        out.storage = storage_kind::none;
        out.depth = 0;
        out.initial_of = nullptr;
      }
      g = find_clocks(g);
      for (int c = 0; c < g.call_count; ++c)
        if (g.calls[c].own_clock.known()) g.calls[c].fast_clock = dynamic_clock;
      return choose_storage(g);
    });

}  // namespace cca::detail
