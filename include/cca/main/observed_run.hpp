// The recording, the page and the trace of a run, for each of which a file is named.
//
//   cca::observed_run look(controller, {.record = "run.mcap", .trace = "run.json"}, "walk", true);
//   ...                                                        // load, start, run, stop
//   for (const std::string& problem : look.close()) std::cerr << problem << '\n';
//   std::cout << look.summary();
//
// Make it before the controller starts, and close it once it has stopped. A program that reads more after it
// has made this, as parameters, takes `opening::later` and calls open() when all is accepted: before that no
// file is opened. Until close() an older file stays, and the new one is in a part beside it
// (base/system/output_file.hpp).
//
// Errors: cca::refused, where the graph is not recordable or traceable, cca/record.hpp is not included, or
// two of the names are of one file; nothing is written then. cca::robot_main has one. docs/programs.md.
#pragma once

#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <cca/main/one_file.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/observers/program_recorder.hpp>
#include <cca/trace/tracer.hpp>

namespace cca {

// Empty: none.
struct run_files {
  std::string record{}, page{}, trace{};
  std::vector<std::string> record_scopes{};  // all ports, if empty
  bool door = false;                         // others look on, also where nothing is recorded
};

enum class opening { at_once, later };

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
  // `waits`: it is a fast run, so the loop may wait for the files.
  observed_run(
      Controller& controller, run_files files, std::string name, bool waits, opening when = opening::at_once)
      : of(&controller), named(std::move(files)), called(std::move(name)), may_wait(waits) {
    const std::string twice =
        complaint_of_one_file({{"--record", named.record}, {"--page", named.page}, {"--trace", named.trace}});
    if (!twice.empty()) throw refused(called + ": " + twice);
    if (!named.record.empty() || !named.page.empty() || named.door) {
      if constexpr (can_record) {
        if (!named.page.empty()) page_.emplace(named.page, named.record);
        recorder_.emplace(controller, recording_file(), named.record_scopes, waits);
      } else throw refused(called + ": this program can't record: see docs/recordings.md");
    }
    if (!named.trace.empty() && !can_trace)
      throw refused(called + ": this program can't be traced: see docs/traces.md");
    if (when == opening::at_once) open();
  }

  // With opening::later, before the first beat.
  void open() {
    if constexpr (can_record)
      if (recorder_) {
        if (!recording_file().empty()) set_aside(recording_file());
        recorder_->open();
      }
    if constexpr (can_trace)
      if (!named.trace.empty()) {
        set_aside(named.trace);
        tracer_.emplace(*of, named.trace, trace_settings{.name = called, .waits = may_wait});
      }
  }

  // For a door: there is one if something is recorded, or `door` was asked for.
  auto& recorder()
    requires can_record
  {
    return recorder_->recorder;
  }

  // What was found beside the files, a sentence for each: parts of runs that crashed.
  const std::vector<std::string>& found() const { return found_; }

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
      if (page_)
        keep(recorder_->is_complete() ? page_->write()
                                      : "the page is not written: its recording is incomplete");
    }
    if constexpr (can_trace)
      if (tracer_) {
        tracer_->close();
        if (const std::string why = tracer_->problem(); !why.empty()) keep("the trace is incomplete: " + why);
      }
    return problems;
  }

  // Instead of close(), where nothing has run: older files stay.
  void discard() {
    if constexpr (can_record)
      if (recorder_) page_.reset(), recorder_->discard();
    if constexpr (can_trace)
      if (tracer_) tracer_->discard();
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

  std::string recording_file() const {
    if constexpr (can_record)
      if (page_) return page_->recording_file();
    return named.record;
  }
  void set_aside(const std::string& file) {
    if (const std::string left = detail::set_aside_left_part(file); !left.empty()) found_.push_back(left);
  }

  Controller* of;
  run_files named;
  std::string called;
  bool may_wait;
  std::vector<std::string> found_{};
  std::optional<typename recorders::page> page_;
  std::optional<typename recorders::recorder> recorder_;
  std::optional<typename detail::tracer_of<Controller, can_trace>::type> tracer_;
};

}  // namespace cca
