// The plan of a sequence as a type: steps by name, the condition of each, and which step may follow which
// (sequence.hpp says what the options mean). A plan holds no numbers of a robot, so NaN does not reach it.
// Errors: plan.bad_step, plan.unknown_step.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>

#include <cca/adaptive/plan/conditions.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/messages/tell_names.hpp>
#include <cca/component/done.hpp>

namespace cca {

template <std::int64_t Beats>
struct held_for {};
template <std::int64_t Beats, fixed_string Name>
struct or_after {};
template <fixed_string Name>
struct then {};
template <fixed_string... Names>
struct then_one_of {};
// The parts that a step needs (component/done.hpp): the others of those that the plan names are stopped.
template <fixed_string... Parts>
struct needs {};

template <fixed_string Name, class... Options>
struct step {};

namespace detail {

inline constexpr int most_choices = 8;

struct step_info {
  std::string_view name, next{}, otherwise{};
  std::int64_t held = 0, limit = -1;  // beats; -1: no limit
  std::array<std::string_view, most_choices> choices{};
  int choice_count = 0;
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

template <std::size_t Count>
struct bad_count_of_choices {
  static constexpr void tell(text& m) {
    m << "plan.bad_step: a `then_one_of<...>` of cca::steps names " << static_cast<std::int64_t>(Count)
      << " steps, and it names 1 to " << static_cast<std::int64_t>(most_choices)
      << ": leave some out, or choose in two steps";
  }
};
template <fixed_string... Names>
struct step_option<then_one_of<Names...>> {
  static_assert(holds_or_tells<(sizeof...(Names) >= 1 && sizeof...(Names) <= most_choices),
                               bad_count_of_choices<sizeof...(Names)>>::value);
  using condition = all<>;
  static constexpr void set(step_info& one) { ((one.choices[one.choice_count++] = Names.view()), ...); }
};

template <fixed_string Part>
struct named_part {
  static constexpr std::string_view path = Part.view();
  using start = starts<Part>;
  using stop = stops<Part>;
};
template <fixed_string... Parts>
struct step_option<needs<Parts...>> {
  static_assert(sizeof...(Parts) >= 1, "cca::steps: a needs<...> names one part or more");
  using condition = all<>;
  using parts = std::tuple<named_part<Parts>...>;
  static constexpr void set(step_info&) {}
};
template <class Option>
struct parts_of_option {
  using type = std::tuple<>;
};
template <class Option>
  requires requires { typename step_option<Option>::parts; }
struct parts_of_option<Option> {
  using type = typename step_option<Option>::parts;
};
template <class... Tuples>
using joined_parts = decltype(std::tuple_cat(std::declval<Tuples>()...));

// Which part a step needs, and the results that start and stop parts, two for each.
template <class Parts>
struct asked_of_parts;
template <class... Part>
struct asked_of_parts<std::tuple<Part...>> {
  static constexpr std::array<std::string_view, sizeof...(Part) + 1> paths{Part::path..., {}};
  // The first of those with the same path.
  static constexpr bool is_first(std::size_t part) {
    for (std::size_t p = 0; p < part; ++p)
      if (paths[p] == paths[part]) return false;
    return true;
  }
  // Is this part one of those, or one around one of those?
  static constexpr bool need(std::string_view path) {
    for (std::size_t p = 0; p < sizeof...(Part); ++p)
      if (paths[p] == path ||
          (paths[p].size() > path.size() && paths[p].starts_with(path) && paths[p][path.size()] == '.'))
        return true;
    return false;
  }
  // Of each part once: f.template operator()<Part>() gives a tuple.
  template <class F>
  static constexpr auto join(F f) {
    return [&]<std::size_t... P>(std::index_sequence<P...>) {
      return std::tuple_cat([&] {
        if constexpr (is_first(P)) return f.template operator()<Part>();
        else return std::tuple<>();
      }()...);
    }(std::index_sequence_for<Part...>{});
  }
};

template <class>
inline constexpr bool is_step = false;
template <fixed_string Name, class... Options>
inline constexpr bool is_step<step<Name, Options...>> = true;

template <class Item>
struct no_step {
  static constexpr void tell(text& m) {
    m << "plan.bad_step: an item of cca::steps is `" << type_name<Item>()
      << "`, which is no step: write conditions and options inside a step, as in cca::step<`reach`, "
         "cca::after<100>>";
  }
};
// `Steps`: the steps of a plan.
template <class Steps, fixed_string Name>
struct unknown_step_at {
  static constexpr void tell(text& m) {
    std::array<std::string_view, Steps::table.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = Steps::table[i].name;
    m << "plan.unknown_step: at<`" << Name.view() << "`> names a step that the plan lacks";
    tell_names(m, Name.view(), names);
  }
};
// Of what is no step: nothing else is reported.
template <class Item>
struct step_facts {
  static_assert(holds_or_tells<false, no_step<Item>>::value);
  using parts = std::tuple<>;
  using condition = all<>;
  static constexpr step_info info{};
};
template <fixed_string Name, class... Options>
struct step_facts<step<Name, Options...>> {
  using parts = joined_parts<typename parts_of_option<Options>::type...>;
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
  static constexpr bool has_steps_only = (detail::is_step<Steps> && ...);
  static constexpr std::array<detail::step_info, sizeof...(Steps)> table{detail::step_facts<Steps>::info...};

  // What its conditions ask for: a component that runs a plan has the same member.
  static constexpr auto asked_paths =
      detail::all_paths_asked<typename detail::step_facts<Steps>::condition...>();

  // The number of the step of that name; -1 if there is none.
  static constexpr int find(std::string_view name) {
    for (int i = 0; i < count; ++i)
      if (table[static_cast<std::size_t>(i)].name == name) return i;
    return -1;
  }
  template <fixed_string Name>
  static constexpr int at = [] {
    static_assert(detail::holds_or_tells<(find(Name.view()) >= 0 || !has_steps_only),
                                         detail::unknown_step_at<steps, Name>>::value);
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

  // The steps that may follow each step, in the order in which the plan names them.
  struct followers {
    std::array<int, detail::most_choices> steps{};
    int count = 0;
  };
  static constexpr std::array<followers, sizeof...(Steps)> next_of = [] {
    std::array<followers, sizeof...(Steps)> all{};
    for (std::size_t i = 0; i < sizeof...(Steps); ++i) {
      for (int k = 0; k < table[i].choice_count; ++k)
        all[i].steps[static_cast<std::size_t>(all[i].count++)] =
            find(table[i].choices[static_cast<std::size_t>(k)]);
      if (all[i].count == 0 && ways[i].next >= 0) all[i] = {{ways[i].next}, 1};
    }
    return all;
  }();
  static constexpr bool has_choices = [] {
    for (const auto& one : table)
      if (one.choice_count > 0) return true;
    return false;
  }();

  // What a component asks for in a step: that the parts which it needs run, and the others rest. Empty if the
  // plan names no part.
  using parts = detail::asked_of_parts<detail::joined_parts<typename detail::step_facts<Steps>::parts...>>;
  static constexpr auto asks(int step) {
    return parts::join([step]<class Part>() {
      bool is_needed = false;
      int i = 0;
      ((is_needed = is_needed ||
                    (i == step &&
                     detail::asked_of_parts<typename detail::step_facts<Steps>::parts>::need(Part::path)),
        ++i),
       ...);
      return std::tuple<typename Part::start, typename Part::stop>(is_needed, !is_needed);
    });
  }

  template <class Heard>
  static bool holds(int step, const Heard& heard) {
    int i = 0;
    bool found = false;
    (void)((i++ == step ? (found = detail::step_facts<Steps>::condition::holds(heard), true) : false) || ...);
    return found;
  }

  static constexpr bool well_named() {
    if (!has_steps_only) return true;  // the first mistake is reported
    for (int i = 0; i < count; ++i) {
      const auto& one = table[static_cast<std::size_t>(i)];
      if (find(one.name) != i || (!one.next.empty() && find(one.next) < 0) ||
          (!one.otherwise.empty() && find(one.otherwise) < 0))
        return false;
      for (int k = 0; k < one.choice_count; ++k)
        if (find(one.choices[static_cast<std::size_t>(k)]) < 0) return false;
    }
    return count > 0;
  }
};

}  // namespace cca
