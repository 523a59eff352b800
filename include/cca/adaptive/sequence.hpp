// A sequence of skills: which step runs, which condition starts the next one, and where to go when that takes
// too long.
//
//   struct plan : cca::steps<
//       cca::step<"trot">,
//       cca::step<"stop",  cca::after<6000>>,
//       cca::step<"reach", cca::is<"cpg.status.ode", cca::ode_status::converged>,
//                          cca::or_after<2000, "trot">>,
//       cca::step<"hold",  cca::is<"arm.status.component", cca::component_status::reached>,
//                          cca::held_for<200>, cca::or_after<3000, "trot">>> {};
//
// It begins with the first step. While a step runs, it waits for the condition of the next step: the
// following one, or that of `then<"name">`; with `then_one_of<"a", "b">` of these, and takes the first of
// them whose condition holds, or the one that `update_by` chooses (learned_sequencer.hpp). The last step
// stays unless it has `then` or `then_one_of`. `or_after<N, "name">`: if the condition has not held within N
// beats of the running step, it goes to that step instead. `held_for<N>`: the condition must hold for N
// consecutive beats.
//
// `needs<"reach", "aim">`: the parts that the step needs (docs/controller.md). Of the parts that any step
// names, those that the running step needs run, the others are stopped; a step that names none needs none.
//
// Conditions: is<"path", State, Axis = 0>, below<"path", value>, above<"path", value>, after<N> beats of the
// running step, all<C...>, any<C...>, no<C>. A step without a condition starts at once. Your own condition is
// a struct with a template `bool holds(const Heard&)`; `heard.template value<"path">()` is the observed
// value. A path is looked up in the graph of the component, then in the graphs around it. The compiler checks
// that names are unique, that each named step exists, and, if the component says so, that each path is
// published (`static constexpr auto asked_paths = plan::asked_paths;`).
//
// An observed NaN fulfils neither `is`, `below` nor `above`, so it fulfils `no` of them, and `held_for`
// begins again; timeouts and `after` go on. A value that has not been published yet counts as NaN, and not
// as the zero of its space. Infinity compares like a number. Neither is kept.
//
// Errors: none in a beat; `unheard()` names unknown paths. plan.unknown_path, plan.unknown_step. Cost: each
// path is searched once; then one comparison per condition. Example: tests/runtime/adaptive/sequencer.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include <cca/adaptive/plan/step_names.hpp>
#include <cca/adaptive/plan/steps.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>

namespace cca {

// The state of a sequence: a value, for your own component, or inside the component of sequencer.hpp.
template <class Plan>
class sequence {
  static_assert(detail::holds_or_tells<Plan::well_named(), detail::wrong_steps<Plan>>::value);

public:
  // Call it once in a beat. Each of `told` is an `observe<...>`.
  template <class... Told>
  void update(beat now, const Told&... told) {
    update_by(now, [](int, std::span<const int> ready) { return ready[0]; }, told...);
  }

  // The same; among several steps whose conditions hold, `choose(running step, these)` names the next one.
  // Another step than one of these is not entered: then it is the first of them.
  template <class Choose, class... Told>
  void update_by(beat now, const Choose& choose, const Told&... told) {
    const std::array<told_scope, sizeof...(Told)> scopes{scope_of(told)...};
    if (began < 0) {
      began = now.index();
      ask_all(scopes);
    }
    const heard all{*this, scopes, now.index() - began};
    if constexpr (Plan::has_choices) return update_among(now, all, choose);
    const int next = following();
    if (next < 0) return;
    const auto& wanted = Plan::table[static_cast<std::size_t>(next)];
    if (keeps_holding(0, next, now, all)) enter(next, now, false);
    else if (wanted.limit >= 0 && all.beats() >= wanted.limit)
      enter(Plan::ways[static_cast<std::size_t>(next)].otherwise, now, true);
  }

  // What the component returns for that, beside its outputs: a tuple of cca::starts and cca::stops.
  constexpr auto asks() const { return Plan::asks(current); }

  int step() const { return current; }
  std::string_view name() const { return Plan::table[static_cast<std::size_t>(current)].name; }
  template <fixed_string Name>
  bool in() const {
    return current == Plan::template at<Name>;
  }
  std::int64_t beats(beat now) const { return began < 0 ? 0 : now.index() - began; }  // since the step began
  bool timed_out() const { return by_timeout; }  // the running step began by a timeout
  bool finished() const { return Plan::next_of[static_cast<std::size_t>(current)].count == 0; }
  // A condition asks for a path that is not observed.
  bool unheard() const { return missing; }

private:
  using told_scope = observe<"">;
  using scopes_told = std::span<const told_scope>;
  // An `observe`, or observations of your own.
  template <class Told>
  static told_scope scope_of(const Told& told) {
    const std::span<const observation> all(told.begin(), told.end());
    if constexpr (requires { told.stands_in(); }) return {all.data(), all.size(), told.stands_in()};
    else return {all.data(), all.size()};
  }
  struct heard {
    sequence& of;
    scopes_told told;
    std::int64_t running;

    std::int64_t beats() const { return running; }
    template <fixed_string Path, int Axis = 0>
    double value() const {
      const place at = of.find(Path.view(), told);
      if (at.scope < 0) return std::numeric_limits<double>::quiet_NaN();
      const observation& one = told[static_cast<std::size_t>(at.scope)].begin()[at.position];
      return one.origin == never ? std::numeric_limits<double>::quiet_NaN() : one.values[Axis];
    }
  };

  struct place {
    const char* path = nullptr;
    int scope = -1, position = -1;
  };

  // The place of a path among the observations. It is searched once; the key is the address of its text,
  // which is a constant of the program.
  place find(std::string_view path, scopes_told told) {
    for (const auto& one : known)
      if (one.path == path.data()) [[likely]]
        return one;
    return look_for(path, told);
  }
  [[gnu::noinline]] place look_for(std::string_view path, scopes_told told) {
    place found{path.data()};
    for (std::size_t scope = 0; scope < told.size() && found.scope < 0; ++scope)
      if (const observation* one = told[scope].find(path))
        found = {path.data(), static_cast<int>(scope), static_cast<int>(one - told[scope].begin())};
    missing |= found.scope < 0;
    known[static_cast<std::size_t>(next_known++ % places)] = found;
    return found;
  }

  // At the beginning: so a path without a publisher is known at once, and not when its step comes.
  [[gnu::noinline]] void ask_all(scopes_told told) {
    const heard all{*this, told, 0};
    for (int i = 0; i < Plan::count; ++i) (void)Plan::holds(i, all);
  }

  // Whether the condition of a step has held long enough. `at`: which of those that may follow it is.
  bool keeps_holding(std::size_t at, int step, beat now, const heard& all) {
    if (!Plan::holds(step, all)) held_since[at] = -1;
    else if (held_since[at] < 0) held_since[at] = now.index();
    return held_since[at] >= 0 &&
           now.index() - held_since[at] >= Plan::table[static_cast<std::size_t>(step)].held;
  }

  template <class Choose>
  void update_among(beat now, const heard& all, const Choose& choose) {
    const auto& next = Plan::next_of[static_cast<std::size_t>(current)];
    std::array<int, detail::most_choices> ready{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(next.count); ++i)
      if (keeps_holding(i, next.steps[i], now, all)) ready[count++] = next.steps[i];
    if (count > 0) {
      const int chosen = choose(current, std::span<const int>(ready.data(), count));
      for (std::size_t i = 0; i < count; ++i)
        if (ready[i] == chosen) return enter(chosen, now, false);
      return enter(ready[0], now, false);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(next.count); ++i) {
      const auto at = static_cast<std::size_t>(next.steps[i]);
      if (Plan::table[at].limit >= 0 && all.beats() >= Plan::table[at].limit)
        return enter(Plan::ways[at].otherwise, now, true);
    }
  }

  int following() const { return Plan::ways[static_cast<std::size_t>(current)].next; }
  void enter(int step, beat now, bool timeout) {
    current = step;
    began = now.index();
    held_since.fill(-1);
    by_timeout = timeout;
  }

  static constexpr int places = 32;
  std::array<place, places> known{};
  int next_known = 0;
  int current = 0;
  std::int64_t began = -1;
  // Of each step that may follow: since when its condition holds; -1: it does not.
  using times = std::array<std::int64_t, Plan::has_choices ? detail::most_choices : 1>;
  static constexpr times never_held() {
    times all{};
    all.fill(-1);
    return all;
  }
  times held_since = never_held();
  bool by_timeout = false, missing = false;
};

namespace detail {

// The results of a component that holds a sequence: its own, and those that start and stop parts.
template <class Plan, class... Own>
using with_parts = joined_parts<std::tuple<Own...>, decltype(Plan::asks(0))>;
template <class Plan, class... Own>
constexpr with_parts<Plan, Own...> add_parts(int step, Own... own) {
  return std::tuple_cat(std::tuple<Own...>(std::move(own)...), Plan::asks(step));
}

}  // namespace detail
}  // namespace cca
