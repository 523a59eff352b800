#pragma once
// The forms of one run: as one loop, in threads, in processes. What each of them did can be compared.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <unistd.h>
#include <utility>
#include <vector>

#include <cca/cca.hpp>
#include <cca/main/command_line.hpp>
#include <cca/runtime/interruption.hpp>

#include "architecture.hpp"
#include "process.hpp"
#include "settings.hpp"
#include "transports.hpp"
#include "wake_up.hpp"

namespace deployed {

struct outcome {
  std::string form, pace;
  std::int64_t beats = 0;        // done
  std::int64_t exact_beats = 0;  // up to here nothing was late
  record seen{};
  skills::result judged{};
  std::int64_t late = 0, overruns = 0, lost_periods = 0;
  double wake_p99_us = 0;  // of the environment that wakes worst
  std::string figures{};   // the table of all environments; empty without a clock
  std::string traced{};    // the summary of the trace
  std::string failure{};
};

inline constexpr std::string_view fast = "as_fast_as_possible", wall_clock = "wall_clock";

// What the process with the simulation knows when the run is over.
template <class Played>
outcome result_of(std::string_view form, std::string_view pace, Played& played) {
  outcome one{std::string(form), std::string(pace), played.beat_index(), played.beat_index()};
  one.seen = std::move(played.template get<"recorder">().seen);
  one.judged = played.template get<"robot.simulator">().judgement();
  if (played.fault()) one.failure = std::string(played.fault_path()) + " " + played.fault().reason();
  return one;
}

inline const std::vector<std::string> all_environments{"simulation", "robot", "reflexes", "mind"};

inline outcome run_loop(const settings& s, const cca::interruption& interrupted) {
  cca::controller<split> loop;
  cca::observed_run look(loop, s.files.of("loop", fast), "loop", true);
  set_up(loop, s, all_environments);
  loop.run(cca::for_some_beats{s.most_beats}, {},
           [&](const auto& c) { return !interrupted && !c.template get<"robot.simulator">().is_over(); });
  outcome one = result_of("loop", fast, loop);
  one.traced = end(look);
  return one;
}

// Nothing was late so far, so all results are those of the loop.
inline bool is_exact(const cca::deployed<split>& d) { return d.late() == 0 && d.lost_periods() == 0; }

// All beats of the loop, in whichever processes the environments are. In a fast run it looks at the
// signals from time to time, in a wall-clock run after each beat.
template <class Pace>
outcome run_deployed(std::string_view form,
                     cca::deployed<split>& d,
                     std::int64_t beats,
                     Pace pace,
                     const cca::interruption& interrupted) {
  constexpr bool is_timed = !std::is_same_v<Pace, cca::as_fast_as_possible>;
  constexpr std::int64_t at_once = 1000, warm_up = 100;
  std::int64_t exact = 0;
  bool is_ended = false;  // by another process
  // Touches all memory, so that the first beats by the clock are as short as the others. The robot stands.
  if (is_timed) d.run(cca::for_some_beats{std::min(beats, warm_up)}), exact = d.beat_index();
  while (d.beat_index() < beats && !d.fault() && !interrupted) {
    const std::int64_t first = d.beat_index(), left = beats - first;
    if constexpr (is_timed)
      d.run(cca::for_some_beats{left}, pace, [&](const auto& running) {
        if (is_exact(running)) exact = running.beat_index();
        return !interrupted;
      });
    else d.run(cca::for_some_beats{std::min(left, at_once)});
    is_ended = d.beat_index() == first && !interrupted;
    if (is_ended) break;
  }
  outcome one = result_of(form, is_timed ? wall_clock : fast, d);
  if (is_timed) one.exact_beats = exact;
  one.late = d.late();
  one.overruns = d.overruns();
  one.lost_periods = d.lost_periods();
  if (is_timed) one.figures = table_of(d.figures());
  for (const auto& e : d.figures()) one.wake_p99_us = std::max(one.wake_p99_us, wake_p99_us(e));
  if (is_ended) one.failure += " another process has ended the run";
  if (d.state() == cca::state::started || d.state() == cca::state::faulted) d.stop();  // all processes
  return one;
}

template <class Pace>
outcome run_threads(const settings& s, Pace pace, const cca::interruption& interrupted) {
  constexpr bool is_timed = !std::is_same_v<Pace, cca::as_fast_as_possible>;
  cca::deployed<split> d;
  cca::observed_run look(d, s.files.of("threads", is_timed ? wall_clock : fast), "threads", !is_timed);
  set_up(d, s, all_environments);
  outcome one = run_deployed("threads", d, s.most_beats, pace, interrupted);
  one.traced = end(look);
  return one;
}

// What another process has told of its environment. Memory that is shared has told it already.
inline void add_figures(outcome& to, const std::string& printed, const std::string& environment) {
  const told_figures told = figures_in(printed, environment);
  if (!told.wake_p99_us) {
    to.failure += " no figures of `" + environment + "`";
    return;
  }
  to.wake_p99_us = std::max(to.wake_p99_us, *told.wake_p99_us);
  if (figures_in(to.figures, environment).row.empty()) to.figures += told.row;
}

// The simulation in this process, each other environment in one of its own.
template <class Pace>
outcome run_processes(const std::string& transport,
                      const settings& s,
                      Pace pace,
                      const cca::interruption& interrupted) {
  static int number = 0;
  const std::string address = std::to_string(::getpid()) + std::to_string(number++);
  return with_transport(transport, address, [&](const auto& connection) {
    cca::deployed<split> d(cca::only{"simulation"}, connection);
    std::vector<process> others;
    const std::vector<std::string> elsewhere{"robot", "reflexes", "mind"};
    constexpr std::string_view pace_name = std::is_same_v<Pace, cca::as_fast_as_possible> ? fast : wall_clock;
    for (const std::string& one : elsewhere) {
      std::vector<std::string> words{"--only", one,       "--form", transport, "--address",
                                     address,  "--shape", s.shape,  "--beats", std::to_string(s.most_beats)};
      const observing files = s.files.of(transport, pace_name, one);
      if (!files.trace.empty()) words.insert(words.end(), {"--trace", files.trace});
      if (!files.record.empty()) words.insert(words.end(), {"--record", files.record});
      if (!files.page.empty()) words.insert(words.end(), {"--page", files.page});
      others.push_back(process(words));
    }
    cca::observed_run look(d, s.files.of(transport, pace_name, "simulation"), transport, pace_name == fast);
    set_up(d, s, {"simulation"});
    outcome one = run_deployed(transport, d, s.most_beats, pace, interrupted);
    one.traced = end(look);
    if (interrupted) return one;
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (others[i].wait() != 0) one.failure += " the process of `" + elsewhere[i] + "` failed";
      else if (one.pace == wall_clock) add_figures(one, others[i].printed(), elsewhere[i]);
    }
    return one;
  });
}

// From paw to ball, for people.
inline std::string distance_of(const skills::result& r) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f mm", r.reach_error * 1e3);
  return r.touched() ? text : "-";
}

// What such another process does: the simulation decides when it begins, at which pace, and when it ends. A
// signal ends the run of all processes, and each stops its environment in order.
inline int run_environment(const std::string& name,
                           const std::string& transport,
                           const std::string& address,
                           const settings& s) {
  return with_transport(transport, address, [&](const auto& connection) {
    const cca::interruption interrupted;
    cca::deployed<split> d(cca::only(std::vector{name}), connection);
    cca::observed_run look(d, s.files, name, false);
    set_up(d, s, {name});
    bool is_ended = false;  // by another process
    while (d.beat_index() < s.most_beats && !d.fault() && !interrupted && !is_ended) {
      const std::int64_t first = d.beat_index();
      d.run(cca::for_some_beats{s.most_beats - first}, {}, [&](const auto&) { return !interrupted; });
      is_ended = d.beat_index() == first;
    }
    const std::string fault = d.fault() ? d.fault().reason() : "";
    if (d.state() == cca::state::started || d.state() == cca::state::faulted) d.stop();
    std::fputs(told_of(d.figures(), name).c_str(), stdout);
    std::fputs(end(look).c_str(), stderr);
    if (name == "simulation")
      std::printf("%lld beats; from paw to ball: %s\n", static_cast<long long>(d.beat_index()),
                  distance_of(d.template get<"robot.simulator">().judgement()).c_str());
    if (!fault.empty()) std::fprintf(stderr, "%s: %s\n", name.c_str(), fault.c_str());
    if (interrupted) std::fprintf(stderr, "%s: interrupted, stopped in order\n", name.c_str());
    return !fault.empty() ? 1 : interrupted.exit_code();
  });
}

}  // namespace deployed
