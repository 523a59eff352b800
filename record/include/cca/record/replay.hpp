// Replays a recording: the controller of the same graph senses what was recorded, goes through the same
// life-cycle with the same parameters, and each sample that it publishes is compared with the recorded one,
// bit for bit.
//
//   const auto result = cca::recording::replay<trot>("trot.mcap");
//   std::cout << result << '\n';      // 160000 samples of 20000 beats, bit for bit as recorded
//   assert(result);                   // or: `cpg.phase`, beat 1234: recorded [0.1], replayed [0.2]
//
// What else a program gives to its components before the first beat, as the name of a file, it gives in a
// second argument: replay<trot>("trot.mcap", [](auto& c) { c.template get<"gait">().file = ...; }). It is
// called before the parameters are applied. What a program does to components between two beats by other
// ways than parameters and the life-cycle is not recorded.
//
// `Graph` is what was recorded: a graph, a set of modes or a deployment, which is replayed in one loop. Where
// samples came late to an environment, or it left out beats, a loop computes something else: the result says
// so.
//
// The file may have been rewritten by another tool, as long as it has the metadata and the topics: without
// chunks, compressed by lz4, with other numbers of channels.
//
// Errors: cca::refused if the file is no recording, can't be read, is of another architecture, begins after
// the first beat, holds parameters that a component can't have, or lacks samples of a resource node, as that
// of a process which ran only some environments. A recording that was cut off is replayed as far as it goes.
// Test: tests/runtime/record/replay.cpp; docs/recordings.md.
#pragma once

#include <memory>
#include <string>

#include <cca/graph/marks/unmarked.hpp>
#include <cca/record/replay/recorded_beats.hpp>
#include <cca/record/replay/replay_run.hpp>
#include <cca/record/replay/result.hpp>

namespace cca::recording {

template <class Graph, class Prepare>
replay_result replay(const std::string& file, Prepare prepare) {
  constexpr bool is_recordable = cca::detail::Recordable<Graph>;
  static_assert(
      cca::detail::holds_or_tells<is_recordable,
                                  cca::detail::unmarked<Graph, cca::detail::observer::replay>>::value);
  if constexpr (!is_recordable) {
    return {};
  } else if constexpr (well_formed<Graph>) {
    const auto run = std::make_unique<detail::replay_run<Graph, detail::recorded_items<Graph>>>(file);
    prepare(run->robot());
    return run->go();
  } else {
    static_assert(sizeof(controller<Graph>) != 0);  // the message
    return {};
  }
}
template <class Graph>
replay_result replay(const std::string& file) {
  return replay<Graph>(file, [](auto&) {});
}

}  // namespace cca::recording
