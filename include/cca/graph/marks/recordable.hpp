// cca::recordable: a base of what a controller runs, of a graph for example, that may be recorded.
//
//   struct trot : cca::graph<...>, cca::recordable {};
//
// The controller of such a graph has two beats: the usual one, and one that also tells a recorder what each
// component publishes. While nothing is recorded, the usual one runs, and costs one comparison more. The
// controller of any other graph has no trace of it. Compile time: the beat is compiled twice.
// docs/recordings.md.
#pragma once

#include <concepts>
#include <cstdint>

#include <cca/graph/layout/types.hpp>

namespace cca {

struct recordable {};

namespace detail {

template <class Graph> concept Recordable = std::derived_from<Graph, recordable>;

// The same graph as the key of the second beat: plan and places are equal.
template <class Graph>
struct probed : Graph {};

template <class Graph>
inline constexpr graph_sizes graph_size<probed<Graph>> = graph_size<Graph>;
template <class Graph>
inline constexpr heard_count heard_count_of<probed<Graph>> = heard_count_of<Graph>;
template <class Graph>
inline constexpr int calls_in_part<probed<Graph>> = calls_in_part<Graph>;
template <class Graph>
inline constexpr flat_of<Graph> plan_of<probed<Graph>> = plan_of<Graph>;
template <class Graph>
inline constexpr auto layout_of<probed<Graph>> = layout_of<Graph>;

template <class Graph>
inline constexpr bool is_probed = false;
template <class Graph>
inline constexpr bool is_probed<probed<Graph>> = true;

// Where an observed beat writes what it publishes. A variable of the beat: a member of the state would be
// loaded anew after each store into the frame.
template <class Graph>
struct frame_of_beat {};
template <class Graph>
struct frame_of_beat<probed<Graph>> {
  std::int64_t* frame = nullptr;
};

// Only its second beat ever runs, and may be slow: a replay. The usual one is not compiled.
template <class Graph>
inline constexpr bool is_always_probed = false;

template <class Graph, int Node>
struct node_types<probed<Graph>, Node> : node_types<Graph, Node> {};

}  // namespace detail
}  // namespace cca
