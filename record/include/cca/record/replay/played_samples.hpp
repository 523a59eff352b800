// All that an output of a free-running environment had for queues in one beat: several samples, and how many
// are missing. In a replay they enter the queues as they did, before the newest one.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/graph/items/deployment.hpp>
#include <cca/record/replay/recorded_channels.hpp>
#include <cca/record/replay/replayed.hpp>
#include <cca/runtime/publish.hpp>
#include <cca/runtime/observers/beat_tap.hpp>

namespace cca::recording::detail {

// Of one output and beat.
struct played_samples {
  std::vector<recorded_sample> earlier{};  // than the newest
  std::int64_t missing = 0;

  void forget() {
    earlier.clear();
    missing = 0;
  }
};

template <class Graph>
struct playing_tap : cca::detail::beat_tap<replaying<Graph>> {
  using cca::detail::beat_tap<replaying<Graph>>::beat_tap;

  static constexpr bool takes_several([[maybe_unused]] int output) {
    if constexpr (cca::detail::has_free_running<Graph>)
      return cca::detail::gathered_in_a_beat<Graph>[cca::detail::array_size(output)] > 0;
    else return false;
  }

  // Of several samples of one beat the last is the newest: what the frame has comes before another one.
  void keep_earlier(int o, const std::int64_t* frame) {
    constexpr const auto& layout = cca::detail::frame_layout_of<Graph>;
    const std::size_t at = cca::detail::array_size(o);
    const std::int64_t origin = frame[layout.origin[at]];
    if (origin == never) return;
    const auto* const from = reinterpret_cast<const double*>(frame + layout.at[at]);
    played[at].earlier.push_back({o, origin, {from, from + layout.size[at]}});
  }
  // What components that are played have taken from their queues.
  template <class F>
  void keep_taken(const std::int64_t* frame, F is_played) {
    constexpr int all = cca::detail::counts_of<Graph>.output_count;
    for (int o = all - cca::detail::counts_of<Graph>.taken_count; o < all; ++o)
      if (is_played(cca::detail::node_of_output<Graph>(o))) keep_earlier(o, frame);
  }
  void miss(int o, std::int64_t samples) {
    if (takes_several(o)) played[cca::detail::array_size(o)].missing += samples;
  }

  std::array<played_samples, cca::detail::array_size(cca::detail::counts_of<Graph>.output_count + 1)>
      played{};
  bool is_fast = true;  // the run that was recorded

  // Only frames are compared.
  void parameters_changed(const cca::detail::controller_state<replaying<Graph>>&,
                          std::int64_t) noexcept override {}
  void moved(state, std::int64_t) noexcept override {}
  void failed(int, const char*, std::int64_t) noexcept override {}
  void controller_is_gone() noexcept override {}
};

// What is in a frame of a node that does not compute.
template <class Graph, class Component>
void feed_frame(Component& component, int node, const std::int64_t* frame) {
  constexpr const auto& layout = cca::detail::frame_layout_of<Graph>;
  component.forget();
  for (const auto& call : cca::detail::plan_of<Graph>.calls) {
    if (call.node != node || !call.function) continue;
    for (int p = 0; p < call.function->output_count; ++p) {
      const std::size_t o = cca::detail::array_size(call.first_output + p);
      if (const std::int64_t origin = frame[layout.origin[o]]; origin != never)
        component.put(call.phase, p, origin, reinterpret_cast<const double*>(frame + layout.at[o]));
    }
  }
}

template <class Graph>
struct tap_of;
template <class Graph>
struct tap_of<replaying<Graph>> {
  using type = playing_tap<Graph>;
};
template <class Graph, int I>
struct tap_of<cca::detail::mode_part<replaying<Graph>, I>> : tap_of<replaying<Graph>> {};

// The number that all modes share.
template <class Graph, int Output>
inline constexpr int played_output = Output;
template <class M, int I, int Output>
inline constexpr int played_output<cca::detail::mode_part<M, I>, Output> =
    cca::detail::shared_plan_of<M>
        .view_of(cca::detail::shown_plan<cca::detail::mode_part<M, I>>, cca::detail::shown_plan<M>)
        .shared_output(Output);

// A resource node always does.
template <class Component>
bool plays(const Component& component) {
  if constexpr (requires { component.plays(); }) return component.plays();
  else return true;
}

}  // namespace cca::recording::detail

namespace cca::detail {

// Into the queues from reader `Input` on.
template <class Graph, int Input, class Vector>
void play_one(const beat_context<Graph>& b, std::int64_t missing, const Vector& v, std::int64_t origin) {
  constexpr const auto& in = input_of<Graph, Input>;
  if constexpr (in.delay > 0) {
    constexpr place at = layout_of<Graph>.on_the_way[Input];
    b.template at<at.array>(at.index).put_after(missing, v, origin, b.k);
  } else {
    lose_before_queue<Graph, Input>(b.state, missing);
    put_into_queue<Graph, Input>(b.state, b.outcome, v, origin, b.k);
  }
  constexpr int next = queue_from<Graph>(in.next_of_writer);
  if constexpr (next >= 0) play_one<Graph, next>(b, missing, v, origin);
}

template <class Graph, int Output, int Input, class Vector>
void play_into_queues(const beat_context<Graph>& b, const Vector& v, std::int64_t origin) {
  std::int64_t missing = 0;
  if constexpr (is_probed<Graph>) {
    using planned = typename as_planned<Graph>::type;
    using tap = typename recording::detail::tap_of<planned>::type;
    auto& of_beat = static_cast<tap&>(*b.state.tap.get())
                        .played[array_size(recording::detail::played_output<planned, Output>)];
    missing = of_beat.missing;
    for (const auto& one : of_beat.earlier)
      play_one<Graph, Input>(b, std::exchange(missing, 0), Eigen::Map<const Vector>(one.coordinates.data()),
                             one.origin);
  }
  play_one<Graph, Input>(b, missing, v, origin);
}

template <Deployment D, int Call>
  requires(has_free_running<D> && is_free_node<D>(call_of<D, Call>.node))
struct played_call<recording::replaying<D>, Call> {
  static bool is_now(const auto& state) {
    return recording::detail::plays(component_at<recording::replaying<D>, call_of<D, Call>.node>(state));
  }
};
template <DeploymentOfModes D, int I, int Call>
  requires(is_free_node<deployed_mode<D, I>>(call_of<deployed_mode<D, I>, Call>.node))
struct played_call<mode_part<recording::replaying<D>, I>, Call> {
  static bool is_now(const auto& state) {
    using whole = recording::replaying<D>;
    return recording::detail::plays(
        component_at<whole, shared_nodes<whole, I>[array_size(call_of<deployed_mode<D, I>, Call>.node)]>(
            state));
  }
};

template <DeploymentOfModes D, int I>
struct in_fast_run<mode_part<recording::replaying<D>, I>> {
  template <class Graph>
  static bool is_now([[maybe_unused]] const beat_context<Graph>& b) {
    if constexpr (is_probed<Graph>)
      return static_cast<recording::detail::playing_tap<D>&>(*b.state.tap.get()).is_fast;
    else return true;
  }
};

// What it took from a queue in this beat. `Key`: the graph, or a mode.
template <class Key, int Output>
struct played_taken_of {
  template <class Graph>
  static bool is_told([[maybe_unused]] const beat_context<Graph>& b) {
    if (!played_call<Key, output_of<Key, Output>.call>::is_now(b.state)) return false;
    if constexpr (is_probed<Graph>) {
      using vector = Eigen::Matrix<double, size_of_output<Key, Output>, 1>;
      const auto& tap = static_cast<typename recording::detail::tap_of<Key>::type&>(*b.state.tap.get());
      for (const auto& one : tap.played[array_size(recording::detail::played_output<Key, Output>)].earlier)
        publish_taken<Graph, Output>(b, Eigen::Map<const vector>(one.coordinates.data()), one.origin);
    }
    return true;
  }
};
template <Deployment D, int Output>
  requires(has_free_running<D>)
struct played_taken<recording::replaying<D>, Output> : played_taken_of<recording::replaying<D>, Output> {};
template <DeploymentOfModes D, int I, int Output>
  requires(has_free_running<D>)
struct played_taken<mode_part<recording::replaying<D>, I>, Output>
    : played_taken_of<mode_part<recording::replaying<D>, I>, Output> {};

}  // namespace cca::detail
