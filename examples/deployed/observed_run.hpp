#pragma once
// The trace, the recording and the page of a run, and the options that ask for them.
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/cca.hpp>
#include <cca/deployment.hpp>
#include <cca/main/command_line.hpp>
#include <cca/trace.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>
#endif
#include <cca/runtime/recording/program_recorder.hpp>

namespace deployed {

struct observing {
  std::string trace{}, record{}, page{};  // files; empty: none

  // "run.json" of a form, and of a process: "run.threads.wall_clock.json".
  observing of(std::string_view form, std::string_view pace, std::string_view process = {}) const {
    const auto named = [&](const std::string& whole) {
      if (whole.empty()) return whole;
      std::filesystem::path file(whole);
      const std::string end = file.extension();
      file.replace_extension();
      for (const std::string_view part : {form, pace, process})
        if (!part.empty()) (file += '.') += part;
      return (file += end).string();
    };
    return {named(trace), named(record), named(page)};
  }
};

// `of_what`: of which runs, as "of the first run".
template <class Played>
void offer_observing(cca::command_line& line, observing& files, const std::string& of_what) {
  if constexpr (cca::detail::HasRecorder<Played>) {
    line.text("--record FILE", files.record, "records all ports " + of_what);
    line.text("--page FILE", files.page, "the recording as HTML, which any browser shows, " + of_what);
  }
  line.text("--trace FILE", files.trace, "when each component fires, for ui.perfetto.dev, " + of_what);
}

// `waits`: nothing is on a clock, so the loops may wait for the files.
template <class Played>
class observed_run {
  static constexpr bool can_record = cca::detail::HasRecorder<Played>;

public:
  observed_run(Played& played, const observing& files, const std::string& name, bool waits) {
    if (!files.trace.empty())
      trace.emplace(played, files.trace, cca::trace_settings{.name = name, .waits = waits});
    if constexpr (can_record) {
      if (!files.page.empty()) page.emplace(files.page, files.record);
      const std::string file = page ? page->recording_file() : files.record;
      if (!file.empty()) recorded.emplace(played, file, std::vector<std::string>{}, waits);
    }
  }
  // The summary of the trace, and what could not be written.
  std::string end() {
    std::ostringstream text;
    const auto tell = [&text](const std::string& problem) {
      if (!problem.empty()) text << problem << '\n';
    };
    if constexpr (can_record) {
      if (recorded) tell(recorded->close());
      if (page) tell(page->write());
    }
    if (!trace) return text.str();
    trace->close();
    text << trace->summary();
    tell(trace->problem());
    return text.str();
  }

private:
  struct nothing {
    template <class... All>
    explicit nothing(const All&...) {}
  };
  template <class Of, bool CanRecord>
  struct choose {
    using recorder = nothing;
    using page = nothing;
  };
  template <class Of>
  struct choose<Of, true> {
    using recorder = cca::detail::program_recorder<Of>;
    using page = cca::detail::program_page<Of>;
  };
  std::optional<cca::tracer<Played>> trace;
  std::optional<typename choose<Played, can_record>::page> page;
  std::optional<typename choose<Played, can_record>::recorder> recorded;
};

}  // namespace deployed
