// The components of a deployment, each in the loop of its environment. `Self` is the deployment, which runs
// the environments that are `here`.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <cca/base/refused.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/environments/loop/environment_loops.hpp>
#include <cca/runtime/observe.hpp>

namespace cca::detail {

struct live_components;  // of cca::live_access

template <class D>
class placed_components {
protected:
  template <int Node>
  static constexpr int environment_of = plan_of<D>.nodes[Node].place;
  static std::size_t environment_at(int node) { return array_size(plan_of<D>.nodes[array_size(node)].place); }

  template <int Node>
  auto& component() {
    refuse_if_elsewhere(Node);
    return component_of<Node>(*this);
  }
  template <int Node>
  const auto& component() const {
    refuse_if_elsewhere(Node);
    return component_of<Node>(*this);
  }
  bool is_here(int node) const { return here[environment_at(node)]; }
  void refuse_if_elsewhere(int node) const {
    if (!is_here(node)) refuse_elsewhere(node);
  }
  [[noreturn]] static void refuse_elsewhere(int node) {
    throw refused("cca::deployed: `" + path_of_node<D>(node) + "` runs in environment `" +
                  std::string(name_of_environment<D>(environment_at(node))) +
                  "`, which another process runs");
  }
  // Also one that another process runs.
  template <int Node, class Placed>
  static auto& component_of(Placed& self) {
    constexpr int e = environment_of<Node>;
    return component_at<loop_key<D, e>, Node>(self.loops.template at<e>().state);
  }
  // f.template operator()<part<D, E>>(state, next beat or cycle) for each environment here that has a node of
  // a part; of a set of modes with the part in the active mode.
  template <class F, class Placed>
  static void for_each_part_state(int number, F f, Placed& self) {
    self.loops.for_each([&]<int E>(auto& loop) {
      if (self.here[E] && has_part<D, E>(number))
        loop.in_mode([&]<class Part>() { f.template operator()<Part>(loop.state, next_of<E>(self)); });
    });
  }
  // The next beat of an environment, or cycle, as its loop counts.
  template <int E, class Placed>
  static std::int64_t next_of(const Placed& self) {
    if constexpr (is_free_running<D, E>) return self.loops.template at<E>().index();
    else return self.next_beat_of(E);
  }
  bool is_part_here(int number) const {
    for (int node = 0; node < counts_of<D>.node_count; ++node)
      if (is_in_part<D>(node, number) && !is_here(node)) return false;
    return true;
  }
  // f(number, component) for each, in declaration order.
  template <class F, class Placed>
  static void visit(F f, Placed& self) {
    [&]<int... Node>(std::integer_sequence<int, Node...>) {
      const int all[] = {0, (f(Node, component_of<Node>(self)), 0)...};
      (void)all;
    }(std::make_integer_sequence<int, counts_of<D>.node_count>{});
  }

  template <class F>
  void for_each_state(F f) const {
    loops.for_each([&]<int E>(const auto& loop) {
      if (here[E]) f.template operator()<loop_key<D, E>>(loop.state);
    });
  }

  // f(observation) for each output that an `observe` names, before beat k, in declaration order. Of a set of
  // modes those of the active one.
  template <class F>
  void observe_here(std::int64_t k, F& f) const {
    in_mode([&]<class Mode>() {
      observe_newest_here<Mode, is_watched_newest<Mode>>(k, f);
      loops.for_each([&]<int E>(const auto& loop) {
        if (here[E]) observe_outside<part<Mode, E>>(loop.state, is_free_running<D, E> ? loop.index() : k, f);
      });
    });
  }
  template <class F>
  void observe_and_take_here(std::int64_t k, F& f) {
    observe_here(k, f);
    loops.for_each([&]<int E>(auto& loop) {
      if (here[E]) loop.in_mode([&]<class Part>() { take_outside<Part>(loop.state); });
    });
  }
  // The newest samples, whatever the policies, of which only the origins matter.
  template <class F>
  void observed_newest(F f) const {
    loops.for_each([&]<int E>(const auto&) {
      if (here[E]) observed_in<E>(f);
    });
  }
  // Of one environment, between two of its beats.
  template <int Environment, class F>
  void observed_in(F& f) const {
    const auto& loop = loops.template at<Environment>();
    loop.in_mode([&]<class Part>() {
      using mode = deployment_of_part<Part>;
      for_each_watched<mode, is_watched<mode>>([&]<int E, class Observed>() {
        if constexpr (E == Environment) Observed::template show<Part>(loop.state, loop.index(), f);
      });
    });
  }
  // Of an output that more than one mode has, once for each.
  template <class F>
  void observed_in_any_mode(F f) const
    requires(DeploymentOfModes<D>)
  {
    for_each_deployed_mode<D>(
        [&]<class Mode>() { observe_newest_here<Mode, is_watched<Mode>>(loops.template at<0>().k, f); });
  }

  environment_loops<D> loops;
  environments_here<D> here{};

private:
  // f.template operator()<D>(), or with the active mode of the first environment here: all have the same.
  template <class F>
  void in_mode(F f) const {
    if constexpr (DeploymentOfModes<D>) {
      bool is_done = false;
      loops.for_each([&]<int E>(const auto& loop) {
        if (here[E] && !std::exchange(is_done, true))
          loop.in_mode([&]<class Part>() { f.template operator()<deployment_of_part<Part>>(); });
      });
    } else {
      f.template operator()<D>();
    }
  }
  template <class Mode, class Outputs, class F>
  void observe_newest_here(std::int64_t k, F& f) const {
    for_each_watched<Mode, Outputs>([&]<int E, class Observed>() {
      const auto& loop = loops.template at<E>();
      if (here[E])
        Observed::template show<part<Mode, E>>(loop.state, is_free_running<D, E> ? loop.index() : k, f);
    });
  }

  // A watched port, in the state of its environment.
  template <int Output>
  struct watched_output {
    template <class Part, class State, class F>
    static void show(const State& state, std::int64_t k, F& f) {
      observe_newest<Part, Output>(state, k, f);
    }
  };
  template <int Input>
  struct watched_input {
    template <class Part, class State, class F>
    static void show(const State& state, std::int64_t k, F& f) {
      observe_shown<Part, Input>(state, k, f);
    }
  };
  template <class Mode, class Outputs, class F>
  static void for_each_watched(F f) {
    [&]<int... Output>(std::integer_sequence<int, Output...>) {
      (f.template
       operator()<environment_of_call<Mode, output_of<Mode, Output>.call>, watched_output<Output>>(),
       ...);
    }(chosen<counts_of<Mode>.output_count, Outputs>{});
    [&]<int... Input>(std::integer_sequence<int, Input...>) {
      (f.template operator()<environment_of_call<Mode, input_of<Mode, Input>.call>, watched_input<Input>>(),
       ...);
    }(chosen<counts_of<Mode>.first_link, is_watched_input<Mode>>{});
  }
  template <class Mode, int Call>
  static constexpr int environment_of_call = plan_of<Mode>.nodes[call_of<Mode, Call>.node].place;
};

// The environments as a tracer and a recorder know them: each loop of this process tells them of its beats.
template <class D>
class told_environments : protected placed_components<D> {
public:
  // f(number of the environment, the observer of its beats)
  template <class F>
  void for_each_trace(F f) noexcept
    requires(Traceable<D>)
  {
    this->loops.for_each([&]<int E>(auto& loop) {
      if (this->here[E]) f(E, loop.state.trace);
    });
  }
  trace_track* traced_into() const noexcept
    requires(Traceable<D>)
  {
    trace_track* first = nullptr;
    this->loops.for_each([&]<int E>(const auto& loop) {
      if (this->here[E] && !first) first = loop.state.trace.get();
    });
    return first;
  }

  // f.template operator()<E>(where loop E keeps its observer)
  template <class F>
  void for_each_tap(F f) noexcept
    requires(Recordable<D>)
  {
    this->loops.for_each([&]<int E>(auto& loop) {
      if (this->here[E]) f.template operator()<E>(loop.state.tap);
    });
  }
  loop_tap* recorded_into() const noexcept
    requires(Recordable<D>)
  {
    loop_tap* first = nullptr;
    this->loops.for_each([&]<int E>(const auto& loop) {
      if (this->here[E] && !first) first = loop.state.tap.get();
    });
    return first;
  }

  // Between two beats of all of them, or, in a wall-clock run, of the first here.
  void parameters_changed(bool is_running, int first) noexcept {
    if constexpr (Recordable<D>)
      this->loops.for_each([&]<int E>(auto& loop) {
        if (this->here[E] && (!is_running || loop.state.is_exact || E == first)) parameters_changed_in<E>();
      });
  }
  // In the thread of an environment.
  template <int E>
  void parameters_changed_in() noexcept {
    if constexpr (Recordable<D>) {
      auto& loop = this->loops.template at<E>();
      if (auto* const tap = loop.state.tap.get()) tap->parameters_changed(loop.state, loop.beat_of_change());
    }
  }
};

}  // namespace cca::detail
