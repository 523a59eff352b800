// What a processing strategy is. A strategy says when a component fires; each one is a struct in
// component/strategies/, and a user's own is the same kind of struct:
//
//   template <class Inputs>
//   static bool fires(cca::beat now, const Inputs& in);
//
// `in` has, of each input, what the component would read: `in.template get<"x">()` with its value, `origin()`
// and `fresh()`; `fresh<"x">()`, `waiting<"x">()`: how many samples wait in its queue (without one: 1 if it
// is fresh, else 0), and `arrivals<"x">()`: how many have arrived in this beat; and of all inputs
// `any_fresh()`, `all_fresh()`, `share_new_origin()`, `beats_since_fired()` and `is_stopped()`.
//
// `fires` is all that a strategy needs: the loop asks it in each beat, once. A strategy with data members has
// a state: then `fires` is no static member, each node has a strategy object of its own, and under any_of,
// all_of and stoppable it is asked in each beat too, whatever the others say. It begins anew when its
// component is stopped. What else it states (all optional) lets the compiler work out clocks, refuse mistakes
// and draw the strategy:
//
//   add_name(text)          its name in pictures and messages; without it, the name of the type
//   clock                   the beats in which it fires, whatever arrives
//   clock_in_combination    the same under any_of and all_of, where it differs from `clock`
//   clock_from(arrivals)    the beats in which it fires, from those in which samples arrive
//   waits_in_vain(arrivals) true if it waits for inputs of which none is wired (strategy.never_fires)
//   named_inputs            the inputs that it names (strategy.unknown_port)
//   mistake                 what is wrong with its numbers, as the end of a sentence (strategy.never_fires)
//   excludes_itself         true if no beat can satisfy it (strategy.never_fires)
//   for_resource_nodes      true if a resource node may have it (strategy.misplaced)
//   first_dt_is_period      true if `dt()` is a whole period in the first firing too; else it is one beat
//   fires_on_arrival        true if it fires only in beats in which a sample arrives
//   needs_one_origin        true if its inputs must share an origin (strategy.coordination)
//   is_stoppable            true if its component can be stopped on its own
//   counts_arrivals         true if it asks `arrivals()` of a queue; that of a strategy which states no clock
//                           is true by itself
//   parts                   detail::list of the strategies that it combines
//
// Cost: a strategy whose clock is known costs a test of the beat's index, or nothing. Example of one's own:
// tests/runtime/core/pages.cpp; docs/strategies.md.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include <cca/base/fixed_string.hpp>
#include <cca/base/ref.hpp>
#include <cca/base/text.hpp>
#include <cca/base/type_name.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/clock.hpp>
#include <cca/component/signature.hpp>

namespace cca::detail {

// Stands on a node that states no strategy: restless with inputs, timed<1> without.
struct by_default {};

// When samples arrive at one wired input.
struct arrival {
  std::string_view input;
  clock when;
  bool queued = false;
  bool observed = false;  // by a pattern: it has no origin of its own
};

// The wired inputs of one function.
struct arrivals {
  const arrival* first = nullptr;
  int count = 0;

  constexpr const arrival* begin() const { return first; }
  constexpr const arrival* end() const { return first + count; }
};

// Names of inputs that a strategy states.
struct input_names {
  const std::string_view* first = nullptr;
  int count = 0;

  constexpr const std::string_view* begin() const { return first; }
  constexpr const std::string_view* end() const { return first + count; }
  constexpr bool has(std::string_view input) const {
    for (const auto name : *this)
      if (name == input) return true;
    return false;
  }
};

constexpr clock unknown_clock(const arrivals&) { return dynamic_clock; }
constexpr bool waits_for_nothing(const arrivals&) { return false; }

// A strategy as a value: what the constexpr functions of graph/ work on. The members are explained above.
struct strategy_info {
  void (*add_name)(text&) = nullptr;
  clock alone = dynamic_clock, in_combination = dynamic_clock;
  bool has_clock_from = false;
  clock (*clock_from)(const arrivals&) = &unknown_clock;
  bool waits_for_inputs = false;
  bool (*waits_in_vain)(const arrivals&) = &waits_for_nothing;
  input_names named_inputs{};
  std::string_view mistake{};
  bool excludes_itself = false, for_resource_nodes = false, first_dt_is_period = false,
       fires_on_arrival = false, needs_one_origin = false, is_stoppable = false, is_default = false,
       counts_arrivals = false, keeps_state = false;
  const strategy_info* const* parts = nullptr;
  int part_count = 0;
};

template <class Strategy>
constexpr void add_strategy_name(text& t) {
  if constexpr (requires { Strategy::add_name(t); }) Strategy::add_name(t);
  else t << type_name<Strategy>();
}

template <class Strategy>
constexpr strategy_info make_strategy_info();

template <class Strategy>
inline constexpr strategy_info strategy_of = make_strategy_info<Strategy>();

template <class Parts>
struct infos_of;
template <class... Parts>
struct infos_of<list<Parts...>> {
  static constexpr std::array<const strategy_info*, sizeof...(Parts) + 1> all{&strategy_of<Parts>...,
                                                                              nullptr};
};

// Does a strategy ask how many samples have arrived in a queue? The parts of one are asked by themselves.
template <class Strategy>
constexpr bool counts_arrivals() {
  if constexpr (requires { Strategy::counts_arrivals; }) return Strategy::counts_arrivals;
  else
    return !requires { Strategy::clock; } && !requires { &Strategy::clock_from; } &&
           !requires { Strategy::needs_one_origin; } && !requires { typename Strategy::parts; };
}

template <class Strategy>
constexpr strategy_info make_strategy_info() {
  strategy_info s{.add_name = &add_strategy_name<Strategy>};
  s.is_default = std::is_same_v<Strategy, by_default>;
  if constexpr (requires { Strategy::clock; }) s.alone = s.in_combination = Strategy::clock;
  if constexpr (requires { Strategy::clock_in_combination; })
    s.in_combination = Strategy::clock_in_combination;
  if constexpr (requires { &Strategy::clock_from; }) {
    s.has_clock_from = true;
    s.clock_from = &Strategy::clock_from;
  }
  if constexpr (requires { &Strategy::waits_in_vain; }) {
    s.waits_for_inputs = true;
    s.waits_in_vain = &Strategy::waits_in_vain;
  }
  if constexpr (requires { Strategy::named_inputs; }) s.named_inputs = Strategy::named_inputs;
  if constexpr (requires { Strategy::mistake; }) s.mistake = Strategy::mistake;
  if constexpr (requires { Strategy::excludes_itself; }) s.excludes_itself = Strategy::excludes_itself;
  if constexpr (requires { Strategy::for_resource_nodes; })
    s.for_resource_nodes = Strategy::for_resource_nodes;
  if constexpr (requires { Strategy::first_dt_is_period; })
    s.first_dt_is_period = Strategy::first_dt_is_period;
  if constexpr (requires { Strategy::fires_on_arrival; }) s.fires_on_arrival = Strategy::fires_on_arrival;
  if constexpr (requires { Strategy::needs_one_origin; }) s.needs_one_origin = Strategy::needs_one_origin;
  if constexpr (requires { Strategy::is_stoppable; }) s.is_stoppable = Strategy::is_stoppable;
  s.counts_arrivals = counts_arrivals<Strategy>();
  s.keeps_state = !std::is_empty_v<Strategy>;
  if constexpr (requires { typename Strategy::parts; }) {
    s.parts = infos_of<typename Strategy::parts>::all.data();
    s.part_count = static_cast<int>(infos_of<typename Strategy::parts>::all.size()) - 1;
    for (int i = 0; i < s.part_count; ++i) s.counts_arrivals |= s.parts[i]->counts_arrivals;
  }
  return s;
}

// The strategy itself, or the first of its parts and their parts, for which the predicate holds.
template <class Predicate>
constexpr ref<strategy_info> find_part(const strategy_info& strategy, Predicate holds) {
  if (holds(strategy)) return &strategy;
  for (int i = 0; i < strategy.part_count; ++i)
    if (const auto found = find_part(*strategy.parts[i], holds)) return found;
  return nullptr;
}

constexpr bool uses_coordination(const strategy_info& strategy) {
  return bool(find_part(strategy, [](const strategy_info& s) { return s.needs_one_origin; }));
}

// Stands for the inputs of any component, to check a strategy.
struct any_inputs {
  struct port {
    bool fresh() const;
    std::int64_t origin() const;
  };
  template <fixed_string Name>
  port get() const;
  template <fixed_string Name>
  bool fresh() const;
  template <fixed_string Name>
  int waiting() const;
  template <fixed_string Name>
  int arrivals() const;
  bool any_fresh() const;
  bool all_fresh() const;
  bool share_new_origin() const;
  std::int64_t beats_since_fired() const;
  bool is_stopped() const;
};

// ---- of a strategy that combines others, one of which has a state ----
//
// An object of each. All of them are asked in each beat, also where the first answers tell the result.

template <int Number, class Strategy>
struct strategy_part {
  [[no_unique_address]] Strategy strategy{};
};

// What all parts have said.
struct strategy_answers {
  bool any = false, all = true;
  constexpr void add(bool fires) {
    any |= fires;
    all &= fires;
  }
};

template <class Strategies, class Numbers>
struct numbered_parts;
template <class... Strategy, int... Number>
struct numbered_parts<list<Strategy...>, std::integer_sequence<int, Number...>>
    : strategy_part<Number, Strategy>... {
  template <class Inputs>
  constexpr strategy_answers ask(beat now, const Inputs& in) {
    strategy_answers answers;
    (answers.add(strategy_part<Number, Strategy>::strategy.fires(now, in)), ...);
    return answers;
  }
};

template <class... Strategies>
using strategy_parts =
    numbered_parts<list<Strategies...>, std::make_integer_sequence<int, sizeof...(Strategies)>>;

template <class... Strategies>
inline constexpr bool keep_state = !(std::is_empty_v<Strategies> && ...);

// What a type is that is no strategy, for the message; its header specialises this.
template <class Type>
inline constexpr std::string_view no_strategy_but{};

}  // namespace cca::detail

namespace cca {

template <class Strategy> concept ProcessingStrategy = requires(beat now, const detail::any_inputs& in) {
  { Strategy{}.fires(now, in) } -> std::convertible_to<bool>;
};

}  // namespace cca
