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
// following one, or that of `then<"name">`. The last step stays unless it has `then`. `or_after<N, "name">`:
// if the condition has not held within N beats of the running step, it goes to that step instead.
// `held_for<N>`: the condition must hold for N consecutive beats.
//
// Conditions: is<"path", State, Axis = 0>, below<"path", value>, above<"path", value> (never hold for an
// unknown path), after<N> beats of the running step, all<C...>, any<C...>, no<C>. A step without a condition
// starts at once. Your own condition is a struct with a template `bool holds(const Heard&)`; `heard.template
// value<"path">()` is the observed value. The compiler checks that names are unique and that each named step
// exists.
//
// An observed NaN fulfils neither `is`, `below` nor `above`, so it fulfils `no` of them, and `held_for`
// begins again; timeouts and `after` go on. Infinity compares like a number. Neither is kept.
//
// Errors: none in a beat; `unheard()` tells of unknown paths. Cost: each path is searched once; then one
// comparison per condition. Example: tests/runtime/adaptive/sequencer.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>

namespace cca {

template <fixed_string Path, auto State, int Axis = 0>
struct is {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path, Axis>() == static_cast<double>(State);
  }
};
template <fixed_string Path, double Bound>
struct below {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path>() < Bound;
  }
};
template <fixed_string Path, double Bound>
struct above {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path>() > Bound;
  }
};
template <std::int64_t Beats>
struct after {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.beats() >= Beats;
  }
};
template <class... Conditions>
struct all {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return (Conditions::holds(heard) && ...);
  }
};
template <class... Conditions>
struct any {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return (Conditions::holds(heard) || ...);
  }
};
template <class Condition>
struct no {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return !Condition::holds(heard);
  }
};

template <std::int64_t Beats>
struct held_for {};
template <std::int64_t Beats, fixed_string Name>
struct or_after {};
template <fixed_string Name>
struct then {};

template <fixed_string Name, class... Options>
struct step {};

namespace detail {

struct step_info {
  std::string_view name, next{}, otherwise{};
  std::int64_t held = 0, limit = -1;  // beats; -1: no limit
};

template <class Option>
struct step_option {
  using condition = all<Option>;
  static constexpr void set(step_info&) {}
};
template <std::int64_t Beats>
struct step_option<held_for<Beats>> {
  using condition = all<>;
  static constexpr void set(step_info& one) { one.held = Beats; }
};
template <std::int64_t Beats, fixed_string Name>
struct step_option<or_after<Beats, Name>> {
  using condition = all<>;
  static constexpr void set(step_info& one) { one.limit = Beats, one.otherwise = Name.view(); }
};
template <fixed_string Name>
struct step_option<cca::then<Name>> {
  using condition = all<>;
  static constexpr void set(step_info& one) { one.next = Name.view(); }
};

template <class Step>
struct step_facts;
template <fixed_string Name, class... Options>
struct step_facts<step<Name, Options...>> {
  using condition = all<typename step_option<Options>::condition...>;
  static constexpr step_info info = [] {
    step_info one{Name.view()};
    (step_option<Options>::set(one), ...);
    return one;
  }();
};

}  // namespace detail

template <class... Steps>
struct steps {
  static constexpr int count = sizeof...(Steps);
  static constexpr std::array<detail::step_info, sizeof...(Steps)> table{detail::step_facts<Steps>::info...};

  // The number of the step of that name; -1 if there is none.
  static constexpr int find(std::string_view name) {
    for (int i = 0; i < count; ++i)
      if (table[static_cast<std::size_t>(i)].name == name) return i;
    return -1;
  }
  template <fixed_string Name>
  static constexpr int at = [] {
    static_assert(find(Name.view()) >= 0, "cca::steps: there is no step with this name");
    return find(Name.view());
  }();

  // Where a step leads, by number: the next step (-1: none), and the step after a timeout (-1: none).
  struct way {
    int next, otherwise;
  };
  static constexpr std::array<way, sizeof...(Steps)> ways = [] {
    std::array<way, sizeof...(Steps)> all{};
    for (int i = 0; i < count; ++i) {
      const auto& one = table[static_cast<std::size_t>(i)];
      all[static_cast<std::size_t>(i)] = {!one.next.empty() ? find(one.next)
                                          : i + 1 < count   ? i + 1
                                                            : -1,
                                          find(one.otherwise)};
    }
    return all;
  }();

  template <class Heard>
  static bool holds(int step, const Heard& heard) {
    int i = 0;
    bool found = false;
    (void)((i++ == step ? (found = detail::step_facts<Steps>::condition::holds(heard), true) : false) || ...);
    return found;
  }

  static constexpr bool well_named() {
    for (int i = 0; i < count; ++i) {
      const auto& one = table[static_cast<std::size_t>(i)];
      if (find(one.name) != i || (!one.next.empty() && find(one.next) < 0) ||
          (!one.otherwise.empty() && find(one.otherwise) < 0))
        return false;
    }
    return count > 0;
  }
};

// The state of a sequence: a value, for your own component, or inside the component of sequencer.hpp.
template <class Plan>
class sequence {
public:
  // Call it once in a beat. Each of `told` is an `observe<...>`.
  template <class... Told>
  void update(beat now, const Told&... told) {
    static_assert(
        Plan::well_named(),
        "cca::steps: two steps have the same name, or then<...> or or_after<...> names an unknown step");
    if (began < 0) began = now.index();
    const std::array<std::span<const observation>, sizeof...(Told)> scopes{
        std::span<const observation>(told.begin(), told.end())...};
    const heard all{*this, scopes, now.index() - began};
    const int next = following();
    if (next < 0) return;
    const auto& wanted = Plan::table[static_cast<std::size_t>(next)];
    if (!Plan::holds(next, all)) held_since = -1;
    else if (held_since < 0) held_since = now.index();
    if (held_since >= 0 && now.index() - held_since >= wanted.held) enter(next, now, false);
    else if (wanted.limit >= 0 && all.beats() >= wanted.limit)
      enter(Plan::ways[static_cast<std::size_t>(next)].otherwise, now, true);
  }

  int step() const { return current; }
  std::string_view name() const { return Plan::table[static_cast<std::size_t>(current)].name; }
  template <fixed_string Name>
  bool in() const {
    return current == Plan::template at<Name>;
  }
  std::int64_t beats(beat now) const { return began < 0 ? 0 : now.index() - began; }  // since the step began
  bool timed_out() const { return by_timeout; }  // the running step began by a timeout
  bool finished() const { return following() < 0; }
  // A condition names a path that is not observed; known after its first evaluation.
  bool unheard() const { return missing; }

private:
  using scopes_told = std::span<const std::span<const observation>>;
  struct heard {
    sequence& of;
    scopes_told told;
    std::int64_t running;

    std::int64_t beats() const { return running; }
    template <fixed_string Path, int Axis = 0>
    double value() const {
      const place at = of.find(Path.view(), told);
      return at.scope < 0 ? std::numeric_limits<double>::quiet_NaN()
                          : told[static_cast<std::size_t>(at.scope)][static_cast<std::size_t>(at.position)]
                                .values[Axis];
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
    for (std::size_t scope = 0; scope < told.size(); ++scope)
      for (std::size_t i = 0; i < told[scope].size(); ++i)
        if (told[scope][i].path == path) found = {path.data(), static_cast<int>(scope), static_cast<int>(i)};
    missing |= found.scope < 0;
    known[static_cast<std::size_t>(next_known++ % places)] = found;
    return found;
  }

  int following() const { return Plan::ways[static_cast<std::size_t>(current)].next; }
  void enter(int step, beat now, bool timeout) {
    current = step;
    began = now.index();
    held_since = -1;
    by_timeout = timeout;
  }

  static constexpr int places = 32;
  std::array<place, places> known{};
  int next_known = 0;
  int current = 0;
  std::int64_t began = -1, held_since = -1;
  bool by_timeout = false, missing = false;
};

}  // namespace cca
