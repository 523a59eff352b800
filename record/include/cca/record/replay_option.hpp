// The option `--replay FILE` of cca::robot_main: there where this header is included and the graph is
// recordable. It compiles the controller once more, with the recorded robot in place of its own.
// docs/recordings.md.
#pragma once

#include <string>

#include <cca/record/replay.hpp>
#include <cca/runtime/observers/program_recorder.hpp>

namespace cca::detail {

// `Host`: cca::controller or cca::deployed.
template <template <class> class Host, class Graph>
  requires Recordable<Graph>
struct program_replay<Host<Graph>> {
  static recording::replay_result of(const std::string& file) { return recording::replay<Graph>(file); }
};

}  // namespace cca::detail
