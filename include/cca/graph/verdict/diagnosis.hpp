// The first broken rule of a graph, as a constexpr value, which prints nothing. A controller of such a graph
// fails to compile with its message, and so does cca::check (runtime/refusal.hpp).
//
//   static_assert(cca::diagnosis<broken>.rule == "space.mismatch");
//   static_assert(!cca::well_formed<broken>);
#pragma once

// Included first: compilers list the files around a message, and so there are fewer.
#include <cca/component/port.hpp>

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/graph/diagnosis/as_written.hpp>
#include <cca/base/messages/printed.hpp>
#include <cca/graph/layout/types.hpp>

namespace cca {

struct diagnosis_value {
  std::string_view rule;     // id of the rule; empty for a sound graph
  std::string_view where;    // the wire, node or port
  std::string_view message;  // what, where, why and what to do
};

namespace detail {

struct report {
  text where{}, message{};
};

// What a controller runs: a graph, or what a wing makes of some. `diagnosed` is where its first mistake may
// be: the type itself, or a part of it.
template <class Type>
inline constexpr bool has_plan = Graph<Type>;
template <class Type>
struct diagnosed {
  using type = Type;
};

// The id of the first broken rule, or nothing. A type that is no graph gets its own message.
template <class Type>
consteval std::string_view broken_by() {
  using type = typename diagnosed<Type>::type;
  if constexpr (has_plan<type>) return counts_of<type>.found.rule;
  else return graph_unknown_item::id;
}

// The rules that a plan may break, and who writes their messages. A wing adds its own.
template <class Type>
struct told_of {
  using rules = detail::rules;
  using writer = message_writer;
};

// The message about a type that is no graph, after its name.
template <class Type>
struct no_graph {
  static constexpr void tell(auto& message) {
    message
        << "` is no graph: a controller runs a struct derived from cca::graph<...>; put a component into one "
           "as cca::node<`name`, "
        << type_name<Type>() << ">; if another error names " << type_name<Type>()
        << ", mend that first: a comma may be missing between two items of the graph, or a value (a lambda, "
           "an object) stands where a type should";
  }
  using named = Type;
};

template <class... Rules>
auto as_tuple(list<Rules...>) -> std::tuple<Rules*...>;

template <class Type, class Writer, class Report>
consteval Report make_report() {
  Report r;
  if constexpr (has_plan<Type>) {
    const auto& plan = plan_of<Type>;
    Writer m{};
    m.g = plan.view();
    m.say() << broken_by<Type>() << ": ";
    if constexpr (constexpr auto tell = counts_of<Type>.found.tell; tell != nullptr) {
      tell(m);
    } else {
      using all = typename told_of<Type>::rules;
      constexpr auto number = number_of_rule(broken_by<Type>(), all{});
      using rule = std::remove_pointer_t<std::tuple_element_t<number, decltype(as_tuple(all{}))>>;
      rule::tell(m);
    }
    r = {m.where, m.message};
  } else {
    r.where << type_name<Type>();
    r.message << broken_by<Type>() << ": `" << type_name<typename no_graph<Type>::named>();
    no_graph<Type>::tell(r.message);
  }
  return {as_written(r.where), as_written(r.message)};
}
template <class Graph>
inline constexpr auto report_of = make_report<typename diagnosed<Graph>::type,
                                              typename told_of<typename diagnosed<Graph>::type>::writer,
                                              report>();

template <class Graph>
consteval diagnosis_value make_diagnosis() {
  if constexpr (broken_by<Graph>().empty()) return {};
  else return {broken_by<Graph>(), report_of<Graph>.where.view(), report_of<Graph>.message.view()};
}

template <class Graph>
struct said_of_graph {
  static constexpr std::string_view view() { return report_of<Graph>.message.view(); }
};
// Whether an error of a type in the graph has said it already; then the refusal prints nothing.
template <class Graph>
consteval bool is_told() {
  using type = typename diagnosed<Graph>::type;
  if constexpr (has_plan<type>) return counts_of<type>.found.is_told;
  else return false;
}
template <class Graph>
using refusal = std::conditional_t<is_told<Graph>(), report, printed<said_of_graph<Graph>>>;

}  // namespace detail

template <class Graph>
inline constexpr bool well_formed = detail::broken_by<Graph>().empty();

namespace detail {

template <class Type> concept WellFormed = well_formed<Type>;

}  // namespace detail

template <class Graph>
inline constexpr diagnosis_value diagnosis = detail::make_diagnosis<Graph>();

}  // namespace cca
