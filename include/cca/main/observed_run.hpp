// The recording, the page and the trace of a run, for each of which a file is named.
//
//   cca::observed_run look(controller, {.record = "run.mcap", .trace = "run.json"}, "walk", true);
//   ...                                                        // load, start, run, stop
//   for (const std::string& problem : look.close()) std::cerr << problem << '\n';
//   std::cout << look.summary();
//
// Make it before the controller starts, and close it once it has stopped. Errors: cca::refused, where the
// graph is not recordable or traceable, or cca/record.hpp is not included; nothing is written then.
// cca::robot_main has one. docs/programs.md.
#pragma once

#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/runtime/recording/program_recorder.hpp>
#include <cca/trace/tracer.hpp>

namespace cca {

// Empty: none.
struct run_files {
  std::string record{}, page{}, trace{};
  std::vector<std::string> record_scopes{};  // all ports, if empty
};

namespace detail {

template <class Controller>
inline constexpr bool can_trace = false;
template <template <class> class Host, class Graph>
inline constexpr bool can_trace<Host<Graph>> = Traceable<Graph>;

template <class Controller, bool Can>
struct recorder_of {
  struct recorder {};
  struct page {};
};
template <class Controller>
struct recorder_of<Controller, true> {
  using recorder = program_recorder<Controller>;
  using page = program_page<Controller>;
};
template <class Controller, bool Can>
struct tracer_of {
  struct type {};
};
template <class Controller>
struct tracer_of<Controller, true> {
  using type = tracer<Controller>;
};

}  // namespace detail

template <class Controller>
class observed_run {
  static constexpr bool can_record = detail::HasRecorder<Controller>,
                        can_trace = detail::can_trace<Controller>;

public:
  // `waits`: nothing is on a clock, so the loop may wait for the files.
  observed_run(Controller& controller, const run_files& files, const std::string& name, bool waits) {
    if (!files.record.empty() || !files.page.empty()) {
      if constexpr (can_record) {
        if (!files.page.empty()) page_.emplace(files.page, files.record);
        recorder_.emplace(controller, page_ ? page_->recording_file() : files.record, files.record_scopes,
                          waits);
      } else throw refused(name + ": this program can't record: see docs/recordings.md");
    }
    if (!files.trace.empty()) {
      if constexpr (can_trace)
        tracer_.emplace(controller, files.trace, trace_settings{.name = name, .waits = waits});
      else throw refused(name + ": this program can't be traced: see docs/traces.md");
    }
  }

  // Into the recording.
  void note([[maybe_unused]] const std::map<std::string, std::string>& entries) {
    if constexpr (can_record)
      if (recorder_) recorder_->note(entries);
  }

  // What could not be written, a sentence for each; empty: all is there.
  std::vector<std::string> close() {
    std::vector<std::string> problems;
    const auto keep = [&](std::string problem) {
      if (!problem.empty()) problems.push_back(std::move(problem));
    };
    if constexpr (can_record) {
      if (recorder_) keep(recorder_->close());
      if (page_) keep(page_->write());
    }
    if constexpr (can_trace)
      if (tracer_) {
        tracer_->close();
        if (const std::string why = tracer_->problem(); !why.empty()) keep("the trace is incomplete: " + why);
      }
    return problems;
  }

  // Of the trace, a table.
  std::string summary() const {
    std::ostringstream text;
    if constexpr (can_trace)
      if (tracer_) text << tracer_->summary();
    return text.str();
  }

private:
  using recorders = detail::recorder_of<Controller, can_record>;

  std::optional<typename recorders::page> page_;
  std::optional<typename recorders::recorder> recorder_;
  std::optional<typename detail::tracer_of<Controller, can_trace>::type> tracer_;
};

}  // namespace cca
