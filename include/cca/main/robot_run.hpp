// One run of a robot's program: load, start, run, stop, figures, in this order whatever happens in it.
#pragma once

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/base/separate/compiled.hpp>
#include <cca/base/separate/function_ref.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/main/counted_pace.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/runtime/live/held_run.hpp>
#include <cca/main/observed_run.hpp>
#include <cca/runtime/observers/program_door.hpp>
#include <cca/main/robot_program.hpp>
#include <cca/main/run_commands.hpp>
#include <cca/main/run_program.hpp>
#include <cca/main/run_settings.hpp>
#include <cca/main/end_of_run.hpp>
#include <cca/runtime/environments/figures.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/runtime/observers/program_recorder.hpp>
#include <cca/runtime/signals/stop_progress.hpp>

namespace cca::detail {

void refuse_one_file(const run_settings& s);
void refuse_unfinished_recording(const std::string& file);  // to replay

std::string text_of_time(std::int64_t nanoseconds);  // "after 1.234 s"

// What a second SIGINT says of a program: `called` is its name, `what` was left behind.
std::string left_behind(const std::string& called,
                        const run_settings& s,
                        bool has_others,
                        const std::string& what);

// Counted in wall-clock runs only.
void print_figures(const std::vector<environment_figures>& all);

void tell_as(const std::string& called, const std::string& what);

// Looks for a sentence a few times a second, in a thread of its own, and says it once: for what a run that
// can't return does not tell.
class told_meanwhile {
public:
  // `look`: the sentence; empty: there is none. It is told when it was there in two looks. Cost: a thread
  // that sleeps.
  told_meanwhile(std::function<std::string()> look, std::function<void(const std::string&)> tell);

private:
  std::mutex sleeping{};
  std::condition_variable_any woken{};
  std::jthread looking;
};
// Of a deployment whose fault has ended a run that has not returned.
std::string told_of_fault(std::int64_t period,
                          const fault_of_run& fault,
                          const std::vector<std::string>& waits_for);

template <class Program>
class robot_run {
  using controller_type = typename Program::controller_type;
  static constexpr bool is_deployed = AnyDeployment<typename Program::architecture>;

public:
  robot_run(Program& of, std::string name) : program(of), called(std::move(name)) {}

  int go() {
    refuse_one_file(program.settings);
    if (!program.settings.replay.empty()) return replay();
    const auto made = program.others.open ? program.others.open(only(program.settings.only))
                                          : std::make_unique<controller_type>();
    controller_type& c = *made;
    const std::string unstopped = left(
                          "its robot was not stopped: drives hold the last command until "
                          "their watchdogs stop them"),
                      unwritten = left("its robot is stopped, what it had not yet written is lost");
    const interruption interrupted;
    interrupted.leaves_behind(unstopped.c_str());
    program.prepare(c);
    observed_run<controller_type> look(c, files(), called, !program.settings.speed, opening::later);
    for (const std::string& file : program.settings.configs) read_parameters(c, file);
    c.load();
    program.loaded(c);
    look.open();  // all that is read has been accepted
    for (const std::string& note : look.found()) tell(note);
    look.note(program.settings.notes);
    const at_the_end closed{[this] { opened.reset(); }};  // before what it shows
    open_door(c, look);
    is_to_stop = true;
    const std::int64_t first = c.beat_index();
    const auto give_up = [&] {
      const bool has_run = c.beat_index() > first;
      stop(c);
      if (!has_run) look.discard();
    };
    try {
      if (gives_beat()) typed.emplace(program.control, called, program.settings.commands);
      if (begins(c, interrupted)) {
        program.started(c);
        run_and_rest(
            c, program.control,
            held_run{.holds = program.settings.on_fault == "hold",
                     .run = [&](controller_type& runs) { run(runs, interrupted, first); },
                     .held = [&](controller_type& faulted) { tell_held(faulted, interrupted); },
                     .goes_on = [&](controller_type& rests) { return goes_on_at_rest(rests, interrupted); },
                     .rested = [&](controller_type& rests) { program.rests(rests); },
                     .begins = [&](controller_type& started) { return begins_anew(started, first); }});
      }
    } catch (const refused&) {
      give_up();
      if (!interrupted) throw;
    } catch (...) {
      give_up();
      throw;
    }
    program.control.anew.ends();
    if constexpr (HasDoor<controller_type>)
      if (const std::string by = opened ? opened->ended_by() : ""; !by.empty())
        ended_by_others = by + ' ' + at(c);
    if (!ended_by_others.empty()) look.note({{"ended", ended_by_others}});
    const std::vector<std::string> causes = causes_of(c);
    stop(c);  // before anything is written: a robot does not wait for a terminal
    interrupted.leaves_behind(unwritten.c_str());
    const std::vector<std::string> problems = look.close();
    if (!is_fault_told)
      for (const std::string& cause : causes) tell(cause);
    for (const std::string& problem : problems) tell(problem);
    if (!ended_by_others.empty()) tell(ended_by_others);
    if (interrupted) tell("interrupted " + at(c));
    if (!program.settings.quiet) {
      print_figures(figures_of(c));
      for (const std::string& line : summaries_of(c)) std::cout << line << '\n';
      std::cout << look.summary() << std::flush;
    }
    const int own = program.finish(c);
    return has_faulted || !causes.empty()                ? exit_code::fault
           : interrupted                                 ? interrupted.exit_code()
           : !problems.empty() && own == exit_code::done ? exit_code::error
                                                         : own;
  }

private:
  // The same controller with what the recorded robot sensed; the program's own functions are not called.
  int replay() {
    if constexpr (HasReplay<controller_type>) {
      refuse_unfinished_recording(program.settings.replay);
      const auto result = program_replay<controller_type>::of(program.settings.replay);
      std::cout << called << ": " << result << '\n';
      return result ? exit_code::done : exit_code::fault;
    } else {
      throw refused(called + ": this program can't replay: see docs/recordings.md");
    }
  }

  run_files files() const {
    const run_settings& s = program.settings;
    return {s.record, s.page, s.trace, s.record_scopes, s.door.has_value()};
  }
  void open_door(controller_type& c, [[maybe_unused]] observed_run<controller_type>& look) {
    if (!program.settings.door) return;
    if constexpr (HasDoor<controller_type>)
      opened.emplace(c, program.control, look.recorder(), program.settings, program.offers, called,
                     [this, &c](std::int64_t overruns) { return figures_of(c, overruns); });
    else throw refused(called + ": this program has no door: see docs/door.md");
  }
  // With --paused the robot idles until it is told to go on. False: it was told to end.
  bool begins(controller_type& c, const interruption& interrupted) {
    begun_anew& anew = program.control.anew;
    if (!program.settings.paused) return c.start(), true;
    program.control.pause();
    if (!program.others.open) anew.is_at(begun_anew::place::waiting);
    tell("waits to be told to go on: type g, or say so through its door");
    bool is_told = false;
    const bool is_started = begins_after_rest(
        c, program.control,
        [&](controller_type& rests) {
          return goes_on_at_rest(rests, interrupted) && !(is_told = !program.control.is_pause_wanted());
        },
        [this](controller_type& rests) { program.rests(rests); });
    if (is_told) c.start();
    return is_started || is_told;
  }
  void tell_held(const controller_type& c, const interruption& interrupted) {
    if (interrupted) return;
    for (const std::string& cause : causes_of(c)) tell(cause);
    is_fault_told = true;
    tell("holds after the fault: resume it or start it anew; a signal ends it");
  }
  bool goes_on_at_rest(controller_type& c, const interruption& interrupted) {
    return !interrupted && !(opened && !opened->look_at_rest(c));
  }
  // After a fault, or a pause in which somebody has started it anew.
  bool begins_anew(controller_type& c, std::int64_t first) {
    is_fault_told = false;
    if (program.control.anew.is_wanted_to_start()) program.started(c);
    return beats_left(c, first) > 0;
  }
  std::int64_t beats_left(const controller_type& c, std::int64_t first) const {
    const auto& seconds = program.settings.seconds;
    if (!seconds) return std::numeric_limits<std::int64_t>::max();
    const double period = static_cast<double>(controller_type::period());
    return std::max<std::int64_t>(1, std::llround(*seconds * 1e9 / period)) - (c.beat_index() - first);
  }

  // A signal also ends a run that waits for other processes to begin. Where there is a door, each environment
  // looks through it after its beats.
  using door_type = typename door_of<controller_type>::type;
  template <class AfterBeat>
  struct until_signal {
    const AfterBeat& after_beat_of_program;
    const interruption& signals;
    run_control& controlled;
    door_type* door;
    bool operator()(controller_type& c) const {
      const bool goes_on = after_beat_of_program(c);
      return (!door || door->look(c)) && goes_on;
    }
    template <int Environment>
    void after_beat(controller_type& c) const
      requires requires(door_type& of) { of.template after_beat<Environment>(c); }
    {
      if (door) door->template after_beat<Environment>(c);
    }
    bool is_over() const { return signals.is_over(); }
    run_control& control() const { return controlled; }
    bool while_paused(controller_type& c) const {
      return (!door || door->look_while_paused(c)) && !signals && !controlled.anew.is_wanted_to_start();
    }
    void run_ended(controller_type& c) const {
      if (door) door->run_ended(c);
    }
  };

  // `first`: the first beat of the program.
  void run(controller_type& c, const interruption& interrupted, std::int64_t first) {
    const run_settings& s = program.settings;
    const for_some_beats length{beats_left(c, first)};
    if (!program.others.open) program.control.anew.begins(c.beat_index());
    bool goes_on = true;
    const auto after_beat = [&](controller_type& running) {
      if constexpr (!is_deployed)
        if (s.speed) beats.end(), beats.lost_periods.store(running.lost_periods(), std::memory_order_relaxed);
      return goes_on = program.between(running) && !interrupted;
    };
    const until_signal<decltype(after_beat)> between{after_beat, interrupted, program.control,
                                                     opened ? &*opened : nullptr};
    std::optional<told_meanwhile> told;
    if constexpr (is_deployed) tell_faults_of(c, interrupted, told);
    if constexpr (!is_deployed) c.run(length, counted_pace(s.speed, beats), between);
    else if (s.speed) c.run(length, at_speed(*s.speed), between);
    else c.run(length, as_fast_as_possible(), between);
    has_faulted = has_faulted || c.state() == state::faulted;
    if (goes_on && !interrupted && !(opened && opened->ends_run()) && c.state() != state::faulted &&
        !program.control.anew.is_wanted_to_start() && beats_left(c, first) > 0)
      ended_by_others = "another process has ended the run " + at(c);
  }

  // A fault is told while other environments hold the run up, too. From then on the robot is being stopped.
  void tell_faults_of(const controller_type& c,
                      const interruption& interrupted,
                      std::optional<told_meanwhile>& told) {
    unconfirmed = left("its robot has been stopping since its fault, but whether it has was not said");
    told.emplace(
        [&c] {
          const unreturned_fault now = c.fault_before_return();
          return told_of_fault(controller_type::period(), {now.beat, now.path, now.reason, now.cause},
                               now.waits_for);
        },
        [this, &interrupted](const std::string& fault) {
          interrupted.leaves_behind(unconfirmed.c_str());
          tell(fault);
        });
  }

  // Only the process of the first environment can pause the run.
  bool gives_beat() const {
    if constexpr (is_deployed) return program.runs(name_of_environment<typename Program::architecture>(0));
    else return true;
  }

  void stop(controller_type& c) {
    if (!std::exchange(is_to_stop, false)) return;
    stopping_goes_on();
    program.stop(c);
    stopping_goes_on();
  }

  // For a second SIGINT.
  std::string left(const std::string& what) const {
    return left_behind(called, program.settings, static_cast<bool>(program.others.open), what);
  }
  void tell(const std::string& what) const { tell_as(called, what); }
  static std::string at(const controller_type& c) {
    return text_of_time(c.beat_index() * controller_type::period());
  }

  std::vector<environment_figures> figures_of(const controller_type& c) {
    return figures_of(c, c.overruns());
  }
  std::vector<environment_figures> figures_of(const controller_type& c,
                                              [[maybe_unused]] std::int64_t overruns) {
    if constexpr (is_deployed) {
      return c.figures();
    } else {
      environment_figures one = beats.figures;
      one.name = called;
      one.overruns = overruns;
      one.lost_periods = beats.lost_periods.load(std::memory_order_relaxed);
      return {one};
    }
  }

  Program& program;
  std::string called, ended_by_others{}, unconfirmed{};
  bool is_to_stop = false, has_faulted = false, is_fault_told = false;
  counted_beats beats{};
  std::optional<door_type> opened{};
  std::optional<run_commands> typed{};  // its thread ends when all is written: a robot does not wait for it
};

}  // namespace cca::detail

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/robot_run_functions.hpp>
#endif
