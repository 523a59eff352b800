// The option `--record FILE` of cca::robot_main: there where <cca/record.hpp> is included and the graph is
// recordable. docs/recordings.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <cca/record/recorder.hpp>
#include <cca/runtime/recording/program_recorder.hpp>

namespace cca::detail {

// `Host`: cca::controller or cca::deployed.
template <template <class> class Host, class Graph>
  requires Recordable<Graph>
struct program_recorder<Host<Graph>> {
  // `waits`: nothing is on a clock, so the loop may wait for the file.
  program_recorder(Host<Graph>& c, const std::string& file, std::vector<std::string> scopes, bool waits)
      : recorder(c, file, {.scopes = std::move(scopes), .waits = waits}) {}

  void note(const std::map<std::string, std::string>& entries) {
    if (!entries.empty()) recorder.note("cca.program", entries);
  }
  // Ends the recording. What went wrong, as a sentence; empty: nothing.
  std::string close() {
    recorder.close();
    if (std::string why = recorder.problem(); !why.empty()) return "the recording is incomplete: " + why;
    if (recorder.lost_beats() > 0)
      return "the recording lost " + std::to_string(recorder.lost_beats()) + " beats";
    return {};
  }

  cca::recording::recorder<Host<Graph>> recorder;
};

}  // namespace cca::detail
