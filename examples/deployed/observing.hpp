#pragma once
// The options for the recording, the page and the trace of a run, and the names of their files.
#include <filesystem>
#include <string>
#include <string_view>

#include <cca/cca.hpp>
#include <cca/deployment.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/observed_run.hpp>
#include <cca/trace.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

namespace deployed {

struct observing : cca::run_files {
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
    return {{named(record), named(page), named(trace), record_scopes}};
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

// The summary of the trace, and what could not be written.
template <class Played>
std::string end(cca::observed_run<Played>& look) {
  std::string problems;
  for (const std::string& note : look.found()) problems += note + '\n';
  for (const std::string& problem : look.close()) problems += problem + '\n';
  return look.summary() + problems;
}

}  // namespace deployed
