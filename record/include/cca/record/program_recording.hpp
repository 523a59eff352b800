// The options `--record FILE` and `--page FILE` of cca::robot_main: there where <cca/record.hpp> is included
// and the graph is recordable. docs/recordings.md.
#pragma once

#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <cca/record/page.hpp>
#include <cca/record/recorder.hpp>
#include <cca/runtime/observers/program_recorder.hpp>

namespace cca::detail {

// `Host`: cca::controller or cca::deployed.
template <template <class> class Host, class Graph>
  requires Recordable<Graph>
struct program_recorder<Host<Graph>> {
  // `waits`: it is a fast run, so the loop may wait for the file; for those who look on, it never does.
  program_recorder(Host<Graph>& c, const std::string& file, std::vector<std::string> scopes, bool waits)
      : recorder(c,
                 file,
                 {.scopes = std::move(scopes),
                  .waits = waits && !file.empty(),
                  .looks_every = std::chrono::microseconds(file.empty() ? 500 : 2000),
                  .opens_later = true}) {}

  void open() { recorder.open(); }
  void discard() { recorder.discard(); }

  void note(const std::map<std::string, std::string>& entries) {
    if (!entries.empty()) recorder.note("cca.program", entries);
  }
  // After close(): the file is there.
  bool is_complete() const { return recorder.problem().empty(); }
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

// `--page`: whatever is recorded, in a page. Without a file of its own the recording is in one beside the
// page, which goes when the page is there.
template <class Controller>
class program_page {
public:
  program_page(const std::string& name, const std::string& record)
      : page(name),
        empty(recording::page_without_recording()),
        recorded(record.empty() ? name + ".mcap" : record),
        is_temporary(record.empty()) {}
  program_page(const program_page&) = delete;
  program_page& operator=(const program_page&) = delete;

  const std::string& recording_file() const { return recorded; }

  // After the recording has ended. What went wrong, as a sentence; empty: nothing.
  std::string write() {
    try {
      recording::write_page(page, recorded, empty);
      if (is_temporary) std::remove(recorded.c_str());
      return {};
    } catch (const std::exception& e) {
      return std::string("the page can't be written: ") + e.what() + "; the recording is in " + recorded;
    }
  }

private:
  std::string page, empty, recorded;
  bool is_temporary;
};

}  // namespace cca::detail
