// What an input shows when its component fires: a sample where it is stored, its origin, and whether it is
// fresh.
//
// `Input` is the number of the first input that reads in the same way (graph/layout/layout.hpp); `index` says
// where in its array this one reads.
#pragma once

#include <cca/runtime/state.hpp>

namespace cca::detail {

// One number for all coordinates of an initial value. A plain array: its loop takes the fewest steps
// (docs/compilers.md).
template <class Graph, int Input>
struct equal_coordinates {
  double all[static_cast<std::size_t>(size_of_input<Graph, Input>)]{};
  constexpr equal_coordinates() {
    const double one = input_of<Graph, Input>.initial->initial[0];
    for (double& coordinate : all) coordinate = one;
  }
};
template <class Graph, int Input>
inline constexpr equal_coordinates<Graph, Input> repeated_initial{};

// What an input shows before a first sample has arrived: what its wire says, or the space's zero.
template <class Graph, int Input>
constexpr const double* initial_of_input() {
  constexpr const auto& wire = input_of<Graph, Input>.initial;
  if constexpr (!wire || !wire->initial) return space_of_input<Graph, Input>.zero;
  else if constexpr (wire->initial_count == size_of_input<Graph, Input>) return wire->initial;
  else return repeated_initial<Graph, Input>.all;
}

template <class Graph, int Input>
struct input_reader {
  static constexpr const auto& in = input_of<Graph, Input>;
  static constexpr int array = layout_of<Graph>.sources[Input].array;
  static constexpr storage_kind kind =
      array < 0 ? storage_kind::none : layout_of<Graph>.arrays[array < 0 ? 0 : array].kind;
  static constexpr int element = in.writer < 0 ? 0 : output_of<Graph, in.writer>.port;
  static constexpr bool shows_own_initial = in.own_initial && !in.in_beat;

  CCA_INLINE static auto& stored(const beat_context<Graph>& b, int index) {
    return b.template at<array>(index);
  }

  // The stored sample that is shown; null: the initial value is.
  CCA_INLINE static auto shown(const beat_context<Graph>& b, int index) {
    auto& from = b.template at<array>(index);
    if constexpr (kind == storage_kind::of_beat) {
      return &from.template output<element>();
    } else {
      auto* sample = from.show(b.k, in.delay);
      if constexpr (shows_own_initial)
        if (sample->origin() == never) sample = nullptr;
      return sample;
    }
  }
  static constexpr bool is_never_null =
      kind == storage_kind::of_beat ||
      ((kind == storage_kind::newest || kind == storage_kind::past) && !shows_own_initial);

  CCA_INLINE static std::int64_t origin(const beat_context<Graph>& b, int index) {
    if constexpr (kind == storage_kind::none) {
      return never;
    } else {
      const auto* sample = shown(b, index);
      if constexpr (is_never_null) return sample->origin();
      else return sample ? sample->origin() : never;
    }
  }

  // Does its origin count for what the component publishes? Has its sample arrived whenever the component
  // fires?
  static constexpr bool counts = in.writer >= 0 && (in.counts || in.counts_vary);
  static constexpr bool has_surely_arrived = counts && in.in_beat && in.delay == 0;

  // Of a queue into which some ways close a loop: does that of this sample?
  template <class Sample>
  CCA_INLINE static bool counts_here(const Sample& sample) {
    return (sample.counts_for >> in.mark & 1) != 0;
  }

  // Makes `oldest` the older of the two.
  CCA_INLINE static void add_origin([[maybe_unused]] std::int64_t& oldest,
                                    [[maybe_unused]] const beat_context<Graph>& b,
                                    [[maybe_unused]] int index) {
    if constexpr (counts) {
      const auto* sample = shown(b, index);
      if constexpr (in.counts_vary)
        if (sample && !counts_here(*sample)) return;
      if constexpr (has_surely_arrived) oldest = sample->origin() < oldest ? sample->origin() : oldest;
      else if constexpr (is_never_null) oldest = older(oldest, sample->origin());
      else oldest = sample ? older(oldest, sample->origin()) : oldest;
    }
  }

  // The beat in which the sample arrived; -1: nothing has.
  CCA_INLINE static std::int64_t arrived(const beat_context<Graph>& b, int index) {
    if constexpr (kind == storage_kind::none) {
      return -1;
    } else if constexpr (in.known_now) {
      return b.k;
    } else if constexpr (kind == storage_kind::of_beat) {
      return b.template at<array>(index).template arrived<element>(b.k);
    } else {
      return b.template at<array>(index).arrived(b.k, in.delay);
    }
  }

  // A sample has arrived since the component last fired, in beat `last`; with a queue: it is not empty.
  CCA_INLINE static bool is_fresh(const beat_context<Graph>& b, int index, std::int64_t last) {
    if constexpr (kind == storage_kind::queue) return !b.template at<array>(index).is_empty();
    else return arrived(b, index) > last;
  }

  // The port that the component gets; `last` is the beat in which it fired before.
  template <class Port, class = void>
  CCA_INLINE static Port get(const beat_context<Graph>& b, int index, beat, std::int64_t last) {
    Port port{to_be_filled{}};
    if constexpr (kind == storage_kind::none) {
      port.show_initial(initial_of_input<Graph, Input>());
    } else {
      const auto* sample = shown(b, index);
      if constexpr (is_never_null) {
        port.template show<kind == storage_kind::of_beat>(sample->vector(), sample->origin(),
                                                          is_fresh(b, index, last));
      } else {
        if (sample) port.show(sample->vector(), sample->origin(), is_fresh(b, index, last));
        else port.show_initial(initial_of_input<Graph, Input>());
      }
      if constexpr (requires { port.set_wired(); }) port.set_wired();
      if constexpr (kind == storage_kind::queue) port.show_dropped(b.template at<array>(index).dropped());
    }
    return port;
  }

  // After the component has seen it.
  CCA_INLINE static void take([[maybe_unused]] const beat_context<Graph>& b, [[maybe_unused]] int index) {
    if constexpr (kind == storage_kind::queue) b.template at<array>(index).take();
  }
};

// An argument of a component's function: a port, the beat, or an observer (runtime/observe.hpp).
template <class Graph, class Parameter, int Input>
struct argument : input_reader<Graph, Input> {};
template <class Graph, int Input>
struct argument<Graph, beat, Input> {
  template <class, class = void>
  CCA_INLINE static beat get(const beat_context<Graph>&, int, beat now, std::int64_t) {
    return now;
  }
};

// What follows from the sample of a port. `All`: the parameters of the function, with that port.
template <fixed_string Name, class Parameters>
struct port_named;
template <fixed_string Name, class First, class... Rest>
struct port_named<Name, list<First, Rest...>> : port_named<Name, list<Rest...>> {};
template <fixed_string Name, class Space, class... Rest>
struct port_named<Name, list<in<Name, Space>, Rest...>> {
  using type = in<Name, Space>;
};
template <fixed_string Name, class Space, class... Rest>
struct port_named<Name, list<optional_in<Name, Space>, Rest...>> {
  using type = optional_in<Name, Space>;
};
template <class Graph, class Function, fixed_string Name, int Input>
struct argument<Graph, derived<Function, Name>, Input> {
  using reader = input_reader<Graph, Input>;
  using type = derived<Function, Name>;

  template <class, class All>
  CCA_INLINE static type get(const beat_context<Graph>& b, int index, beat now, std::int64_t last) {
    using port = typename port_named<Name, All>::type;
    const auto shown = [&] { return reader::template get<port>(b, index, now, last); };
    if constexpr (shows_the_same<Graph, Input>)
      return type(&shared_value<Graph, Input, typename type::function>(b, index, shown));
    else return type(shown());
  }
};

// Where the input at a position of a call reads.
template <class Graph>
CCA_INLINE int index_of_source(const call_place& at, int position) {
  return layout_of<Graph>.sources[at.first_input + position].index;
}

}  // namespace cca::detail
