#pragma once
// The trace and the recording of a form: for each form and process a file.
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/cca.hpp>
#include <cca/deployment.hpp>
#include <cca/trace.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>
#endif
#include <cca/runtime/recording/program_recorder.hpp>

namespace deployed {

struct observing {
  std::string trace{}, record{};  // files; empty: none

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
    return {named(trace), named(record)};
  }
};

// `waits`: nothing is on a clock, so the loops may wait for the files.
template <class Played>
class observed_run {
public:
  observed_run(Played& played, const observing& files, const std::string& name, bool waits) {
    if (!files.trace.empty())
      trace.emplace(played, files.trace, cca::trace_settings{.name = name, .waits = waits});
    if constexpr (cca::detail::HasRecorder<Played>)
      if (!files.record.empty()) recorded.emplace(played, files.record, std::vector<std::string>{}, waits);
  }
  // The summary of the trace, and what could not be written.
  std::string end() {
    std::ostringstream text;
    if constexpr (cca::detail::HasRecorder<Played>)
      if (recorded)
        if (const std::string problem = recorded->close(); !problem.empty()) text << problem << '\n';
    if (!trace) return text.str();
    trace->close();
    text << trace->summary();
    if (const std::string problem = trace->problem(); !problem.empty()) text << problem << '\n';
    return text.str();
  }

private:
  struct nothing {
    template <class... All>
    explicit nothing(const All&...) {}
  };
  template <class Of, bool CanRecord>
  struct choose {
    using type = nothing;
  };
  template <class Of>
  struct choose<Of, true> {
    using type = cca::detail::program_recorder<Of>;
  };
  std::optional<cca::tracer<Played>> trace;
  std::optional<typename choose<Played, cca::detail::HasRecorder<Played>>::type> recorded;
};

}  // namespace deployed
