// The values that follow from samples of a beat (component/ports/derived.hpp), each once for all components
// that ask for it. A graph without such a component has nothing of this.
//
// A value is known by its function and by the output from whose sample it follows: for the twins of a call,
// by the array of that output and the index in it.
#pragma once

#include <new>
#include <type_traits>

#include <cca/base/inlining.hpp>
#include <cca/graph/layout/lookup.hpp>

namespace cca::detail {

// Whether an input shows the newest sample of its output: all do that have no delay, because they are read
// after its writer has run. One with an initial value of its own may still show that.
template <class Graph, int Input>
inline constexpr bool shows_the_same = [] {
  const input& in = plan_of<Graph>.inputs[array_size(Input)];
  constexpr int array = layout_of<Graph>.sources[Input].array;
  if (in.writer < 0 || in.queue >= 0 || in.delay > 0 || (in.own_initial && !in.in_beat) || array < 0)
    return false;
  const storage_kind kind = layout_of<Graph>.arrays[array < 0 ? 0 : array].kind;  // also where it is no array
  return kind == storage_kind::of_beat || kind == storage_kind::newest || kind == storage_kind::past;
}();

// Output: its number among those of the call whose result is in the array.
template <class Function, int Array, int Output>
struct derived_key {
  using function = Function;
  static constexpr int array = Array;
};
template <class Graph, int Input, class Function>
using key_of_derived =
    derived_key<Function,
                layout_of<Graph>.sources[Input].array,
                layout_of<Graph>.arrays[layout_of<Graph>.sources[Input].array].kind == storage_kind::of_beat
                    ? plan_of<Graph>.outputs[array_size(plan_of<Graph>.inputs[array_size(Input)].writer)].port
                    : 0>;

// ---- which there are ----

template <class Done, class... Types>
struct keys_once {
  using type = Done;
};
template <class... Done, class Type, class... Rest>
struct keys_once<list<Done...>, Type, Rest...>
    : keys_once<std::conditional_t<(std::is_same_v<Done, Type> || ...), list<Done...>, list<Done..., Type>>,
                Rest...> {};
template <class List>
struct distinct_keys;
template <class... Types>
struct distinct_keys<list<Types...>> : keys_once<list<>, Types...> {};

// A function, and those on whose values it builds.
template <class Graph, int Input, class Function>
struct keys_of_function {
  using type = list<key_of_derived<Graph, Input, Function>>;
};
template <class Graph, int Input, class Function, class... Before>
auto keys_from(from<Before...>) ->
    typename joined<list<key_of_derived<Graph, Input, Function>>,
                    typename keys_of_function<Graph, Input, Before>::type...>::type;
template <class Graph, int Input, class Function>
  requires requires { typename Function::from; }
struct keys_of_function<Graph, Input, Function> {
  using type = decltype(keys_from<Graph, Input, Function>(typename Function::from()));
};

template <class Graph, int Input, class Parameter>
struct keys_of_parameter {
  using type = list<>;
};
template <class Graph, int Input, class Function, fixed_string Port>
  requires(shows_the_same<Graph, Input>)
struct keys_of_parameter<Graph, Input, derived<Function, Port>>
    : keys_of_function<Graph, Input, typename derived<Function, Port>::function> {};

template <class Graph, int Call, class Parameters = typename function_called<Graph, Call>::parameters>
struct keys_of_call;
template <class Graph, int Call, class... Parameters>
struct keys_of_call<Graph, Call, list<Parameters...>> {
  static constexpr auto& positions = function_ports<list<Parameters...>, list<>>::source_of_parameter;

  template <std::size_t... I>
  static auto all(std::index_sequence<I...>) -> typename joined<
      list<>,
      typename keys_of_parameter<Graph,
                                 layout_of<Graph>.input_twin[call_of<Graph, Call>.first_input +
                                                             (positions[I] < 0 ? 0 : positions[I])],
                                 Parameters>::type...>::type;
  using type = decltype(all(std::index_sequence_for<Parameters...>()));
};

template <class Graph>
struct derives_values {
  static constexpr bool holds(std::size_t c) {
    const call& one = plan_of<Graph>.calls[c];
    return !one.elsewhere && one.function->derives && layout_of<Graph>.twin[c] == static_cast<int>(c);
  }
};
template <class Graph, class Calls>
struct keys_of_calls;
template <class Graph, int... Call>
struct keys_of_calls<Graph, std::integer_sequence<int, Call...>>
    : distinct_keys<typename joined<list<>, typename keys_of_call<Graph, Call>::type...>::type> {};
template <class Graph>
using derived_keys =
    typename keys_of_calls<Graph, chosen<counts_of<Graph>.call_count, derives_values<Graph>>>::type;

// ---- in a beat ----

template <class Graph, class Key>
struct rooms_of_derived {
  using value = typename Key::function::value;
  static constexpr std::size_t count = array_size(array_of<Graph, Key::array>.count);

  alignas(value) unsigned char rooms[count][sizeof(value)];
};
template <class Graph, class Key>
struct marks_of_derived {
  bool is_known[rooms_of_derived<Graph, Key>::count] = {};
};

// The rooms begin with nothing, and what makes a value gets their address. The marks are apart: no function
// gets theirs, so the compiler knows what they are.
template <class Graph, class Keys = derived_keys<Graph>>
struct derived_rooms;
template <class Graph, class... Keys>
struct derived_rooms<Graph, list<Keys...>> : rooms_of_derived<Graph, Keys>... {
  CCA_INLINE derived_rooms() {}
};
template <class Graph, class Keys = derived_keys<Graph>>
struct derived_marks;
template <class Graph, class... Keys>
struct derived_marks<Graph, list<Keys...>> : marks_of_derived<Graph, Keys>... {};

template <class Graph, class Keys = derived_keys<Graph>>
struct derived_in_beat {
  derived_rooms<Graph>& rooms;
  derived_marks<Graph>& marks;

  CCA_INLINE derived_in_beat(derived_rooms<Graph>& r, derived_marks<Graph>& m) : rooms(r), marks(m) {}
};
template <class Graph>
struct derived_in_beat<Graph, list<>> {
  CCA_INLINE derived_in_beat(derived_rooms<Graph>&, derived_marks<Graph>&) {}
};

template <class Graph, int Input, class Function, class Shown>
CCA_INLINE const typename Function::value& shared_value(const derived_in_beat<Graph>& b,
                                                        int index,
                                                        const Shown& shown);
template <class Graph, int Input, class Function, class Shown, class... Before>
CCA_INLINE typename Function::value new_value(const derived_in_beat<Graph>& b,
                                              int index,
                                              const Shown& shown,
                                              from<Before...>) {
  return Function::of(shared_value<Graph, Input, Before>(b, index, shown)...);
}

// The value at an index; it is made if no component has asked for it. `shown()` is the port.
template <class Graph, int Input, class Function, class Shown>
CCA_INLINE const typename Function::value& shared_value(const derived_in_beat<Graph>& b,
                                                        int index,
                                                        const Shown& shown) {
  using key = key_of_derived<Graph, Input, Function>;
  using value = typename Function::value;
  bool& is_known = static_cast<marks_of_derived<Graph, key>&>(b.marks).is_known[index];
  unsigned char* const room = static_cast<rooms_of_derived<Graph, key>&>(b.rooms).rooms[index];
  if (!is_known) {
    if constexpr (requires { typename Function::from; })
      ::new (static_cast<void*>(room))
          value(new_value<Graph, Input, Function>(b, index, shown, typename Function::from()));
    else ::new (static_cast<void*>(room)) value(value_for<Function>(shown()));
    is_known = true;
  }
  return *std::launder(reinterpret_cast<const value*>(room));
}

}  // namespace cca::detail
