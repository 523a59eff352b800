// The first broken rule of a graph, as a constexpr value; a controller of such a graph fails to compile with
// its message.
//
//   static_assert(cca::well_formed<trot<cca::sim::oncilla>>);
//   static_assert(cca::diagnosis<broken>.rule == "space.mismatch");
#pragma once

// First: where this refuses something, the compilers tell of each file around it.
#include <cca/component/port.hpp>

#include <array>
#include <string_view>
#include <utility>

#include <cca/graph/message.hpp>
#include <cca/graph/plan/types.hpp>

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

// The first broken rule. What is no graph at all is told so.
template <class Type>
consteval rule broken_by() {
  if constexpr (Graph<Type>) return counts_of<Type>.found.broken;
  else return rule::graph_unknown_item;
}

template <class Type, class Telling, class Report>
consteval Report make_report() {
  Report r;
  if constexpr (Graph<Type>) {
    auto plan = plan_of<Type>;
    Telling t{plan.view(), flattened_of<Type>.unknown_trigger};
    tell(t);
    r = {t.where, t.message};
  } else {
    r.where << type_name<Type>();
    r.message << rule_ids[static_cast<std::size_t>(broken_by<Type>())] << ": `" << type_name<Type>()
              << "` is no graph: what runs is a struct derived from cca::graph<...>; a component is put into "
                 "one as cca::node<`name`, "
              << type_name<Type>() << ">";
  }
  return {as_written(r.where), as_written(r.message)};
}
template <class Graph>
inline constexpr auto report_of = make_report<Graph, telling, report>();

template <class Graph>
consteval diagnosis_value make_diagnosis() {
  constexpr auto broken = broken_by<Graph>();
  if constexpr (broken == rule::none) return {};
  else
    return {rule_ids[static_cast<std::size_t>(broken)], report_of<Graph>.where.view(),
            report_of<Graph>.message.view()};
}

// Never defined: the compiler names it, and with it the message. g++ prints text in a template argument
// whole; clang cuts it after 35 letters, so there it goes in lines of at most so many, broken between words.
template <auto... Text>
struct refused_graph;

#if defined(__clang__)
struct line {
  char text[36]{};
};

struct broken_lines {
  std::array<line, 96> lines{};
  std::size_t count = 0;
};

constexpr broken_lines in_lines(std::string_view whole) {
  constexpr std::size_t width = 35;
  broken_lines broken;
  while (!whole.empty() && broken.count < broken.lines.size()) {
    std::size_t size = whole.size();
    if (size > width) {
      size = whole.rfind(' ', width);
      if (size == whole.npos || size == 0) size = width;
    }
    auto& letters = broken.lines[broken.count++].text;
    for (std::size_t i = 0; i < width; ++i) letters[i] = i < size ? whole[i] : ' ';
    letters[width] = '\0';
    whole.remove_prefix(size);
    if (!whole.empty() && whole.front() == ' ') whole.remove_prefix(1);
  }
  return broken;
}

template <class Graph>
inline constexpr broken_lines lines_of = in_lines(report_of<Graph>.message.view());
template <class Graph, std::size_t... Line>
auto refusal_of(std::index_sequence<Line...>) -> refused_graph<line(lines_of<Graph>.lines[Line])...>;
template <class Graph>
using refusal = decltype(refusal_of<Graph>(std::make_index_sequence<lines_of<Graph>.count>{}));
#else
template <std::size_t Size>
struct message {
  char text[Size + 1]{};
  constexpr explicit message(std::string_view whole) {
    for (std::size_t i = 0; i < Size; ++i) text[i] = whole[i];
  }
};
template <class Graph>
using refusal = refused_graph<message<report_of<Graph>.message.size>(report_of<Graph>.message.view())>;
#endif

}  // namespace detail

template <class Graph>
inline constexpr bool well_formed = detail::broken_by<Graph>() == detail::rule::none;

template <class Graph>
inline constexpr diagnosis_value diagnosis = detail::make_diagnosis<Graph>();

}  // namespace cca
