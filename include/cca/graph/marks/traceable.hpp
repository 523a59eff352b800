// cca::traceable: a base of what a controller runs, of a graph for example, whose beats may be traced.
//
//   struct trot : cca::graph<...>, cca::traceable {};
//
// After each firing it is tested whether a tracer is there (cca/trace.hpp): two instructions. The beat of a
// graph that is recordable too has them only while it is recorded or traced. The beat of any other graph has
// no trace of it. docs/traces.md.
#pragma once

#include <concepts>
#include <type_traits>

#include <cca/graph/marks/recordable.hpp>

namespace cca {

struct traceable {};

namespace detail {

template <class Graph> concept Traceable = std::derived_from<Graph, traceable>;

// Whether the beat with this key tells a trace of its firings.
template <class Graph>
inline constexpr bool has_trace_hooks = Traceable<Graph> && !Recordable<Graph>;
template <class Graph>
inline constexpr bool has_trace_hooks<probed<Graph>> = Traceable<Graph>;

// A base of what is a part of a whole: recordable and traceable as the whole is.
template <int>
struct no_mark {};
template <class Whole>
struct marks_of : std::conditional_t<Recordable<Whole>, recordable, no_mark<0>>,
                  std::conditional_t<Traceable<Whole>, traceable, no_mark<1>> {};

}  // namespace detail
}  // namespace cca
