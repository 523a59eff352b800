// A door into a controller that runs: viewers of the Foxglove protocol, a browser, `cca-top` and `cca-call`
// look at it, tune it and steer it.
//
//   cca::controller<trot> c;                  // struct trot : cca::graph<...>, cca::recordable {};
//   c.load(); c.start();
//   cca::door door(c, {.port = 8765});        // says where it is, and the token
//   c.run(cca::for_<10>{}, cca::at_wall_clock(), door);
//
// It is made from the controller of a graph or of a set of modes, or from a cca::deployed, before the run,
// and given to the run as it is. The beat copies what is published into a ring, as for a recording; a thread
// makes messages of it, another one sends them. What comes in is checked in the thread of the door, and taken
// between two beats, all of one request in one beat. So the loop never waits and allocates nothing.
//
// Reading is free on this machine. Who changes anything needs the token, and
// the right to command, which one client has at a time (docs/door.md).
//
// Errors: cca::refused, if it can't listen there, and if the controller is recorded already: give the door
// the file instead, as `door.record("trot.mcap")`. Cost of a beat: docs/door.md. Tests: tests/runtime/door/.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/door/live_controls.hpp>
#include <cca/door/server.hpp>
#include <cca/door/settings.hpp>
#include <cca/runtime/live/held_run.hpp>
#include <cca/runtime/observers/run_command.hpp>
#include <cca/record/recorder.hpp>
#include <cca/runtime/live/live_access.hpp>

namespace cca {
namespace detail {

inline recording::settings recorded_for_a_door() { return {.looks_every = std::chrono::microseconds(500)}; }

// A door on a recorder, and what the loop does for it between two beats.
template <class Controller>
class door_on {
public:
  static constexpr bool is_of_environments =
      requires(live_access<Controller>& of, Controller& c) { of.goes_on(c); };

  door_on(const door_settings& s,
          Controller& c,
          run_control* run,
          recording::recorder<Controller>& recorder,
          std::vector<run_command<Controller>> offers,
          std::string program,
          double speed,
          typename live_controls<Controller>::figures_now figures)
      : live(c),
        recorded(recorder),
        controls(live,
                 run ? *run : live.control(),
                 recorder,
                 std::move(offers),
                 std::move(program),
                 speed,
                 std::move(figures)),
        server(s, controls) {
    if (s.on_lost == when_lost::hold && !live.gives_beat())
      throw refused(
          "cca::door: on_lost: hold is a pause, and another process runs the environment that gives the "
          "beat: open the door of that one so, or choose stop");
    recorded.add(server.sink());
  }
  door_on(const door_on&) = delete;
  door_on& operator=(const door_on&) = delete;
  ~door_on() { recorded.remove(server.sink()); }

  // False: the run is to end.
  bool look(Controller& c) { return !controls.is_wanted(controls.the_run) || look_now(c); }
  bool look_now(Controller& c) {
    (void)controls.is_wanted(controls.the_run);  // it looks
    controls.obey(c);
    if constexpr (requires { live(c); }) return live(c);
    else return live.goes_on(c);
  }
  template <int Environment>
  void after_beat(Controller& c)
    requires is_of_environments
  {
    if (controls.is_wanted(Environment)) live.template after_beat<Environment>(c);
  }
  // In a pause of one loop, what has stopped the robot is told. Other environments may be in a beat; they
  // take their shares themselves.
  bool look_while_paused(Controller& c) {
    if constexpr (is_of_environments) live.template after_beat<0>(c);
    else controls.tell_causes(c);
    return look_now(c);
  }
  // Where no loop runs.
  bool look_at_rest(Controller& c) {
    controls.tell_causes(c);
    if constexpr (is_of_environments)
      c.for_each_tap([&]<int Environment>(auto&) { live.template after_beat<Environment>(c); });
    return look_now(c);
  }
  void run_ended(Controller& c) {
    if constexpr (requires { live.after_last_beat(c); }) live.after_last_beat(c);
    controls.end(c);
    controls.tell_causes(c);
    live.run_ended(c);
  }

  live_access<Controller> live;
  recording::recorder<Controller>& recorded;
  live_controls<Controller> controls;
  door_server server;
};

}  // namespace detail

template <class Controller>
class door {
  using on_door = detail::door_on<Controller>;

public:
  explicit door(Controller& c, const door_settings& s = {}, std::vector<run_command<Controller>> offers = {})
      : recorded(c, detail::recorded_for_a_door()),
        on(s,
           c,
           nullptr,
           recorded,
           std::move(offers),
           std::string(detail::type_name<typename detail::graph_of_controller<Controller>::type>()),
           1,
           figures_of(c)) {}

  std::uint16_t port() const { return on.server.port(); }
  std::string token() const { return on.server.token(); }
  // For a viewer that knows only a URL: valid once.
  std::string one_time_url() const { return on.server.one_time_url(); }

  // Into a file from now on; docs/recordings.md.
  void record(const std::string& file) { recorded.begin_file(file); }

  // Who has ended the run through this door, or whose lost connection has, in a sentence; empty: nobody.
  std::string ended_by() const { return on.controls.ended_by(); }

  // Runs `c` with this door, for a time, at a pace; and again, as long as time is left, where a client
  // resumes it after a fault, or starts it anew after a fault or in a pause. While a fault is held the robot
  // idles. The state at the end: `faulted` where the run was stopped while a fault was held.
  template <class Duration, class Pace = as_fast_as_possible>
  cca::state run(Controller& c, Duration duration, Pace pace = {}) {
    detail::run_control& all = control();
    const detail::at_the_end no_more{[&all] { all.anew.ends(); }};
    std::int64_t left = duration.beats(Controller::period());
    if (left > 0)
      detail::run_and_rest(
          c, all,
          detail::held_run{.holds = true,
                           .run =
                               [&](Controller& runs) {
                                 const std::int64_t first = runs.beat_index();
                                 all.anew.begins(first);
                                 runs.run(for_some_beats{left}, pace, *this);
                                 left -= runs.beat_index() - first;
                               },
                           .held = [](Controller&) {},
                           .goes_on = [this](Controller& rests) { return on.look_at_rest(rests); },
                           .rested = [](Controller&) {},
                           .begins = [&left](Controller&) { return left > 0; }});
    return c.state();
  }

  // ---- the loop's: give the door to `run` as it is ----

  bool operator()(Controller& c)
    requires(!on_door::is_of_environments)
  {
    return on.look(c);
  }
  bool goes_on(Controller& c)
    requires on_door::is_of_environments
  {
    return on.look(c);
  }
  template <int Environment>
  void after_beat(Controller& c)
    requires on_door::is_of_environments
  {
    on.template after_beat<Environment>(c);
  }
  detail::run_control& control() { return on.live.control(); }
  bool while_paused(Controller& c) { return on.look_while_paused(c) && !control().anew.is_wanted_to_start(); }
  void run_ended(Controller& c) { on.run_ended(c); }

private:
  static typename detail::live_controls<Controller>::figures_now figures_of(const Controller& c) {
    if constexpr (requires { c.figures(); }) return [&c] { return c.figures(); };
    else return {};
  }

  recording::recorder<Controller> recorded;
  on_door on;
};

// Of a controller that breaks a rule: the message is the controller's.
template <detail::Refused Controller>
class door<Controller> {
public:
  explicit door(Controller&, const door_settings& = {}, std::vector<run_command<Controller>> = {}) {}
  std::uint16_t port() const { return 0; }
  std::string token() const { return {}; }
  std::string one_time_url() const { return {}; }
  void record(const std::string&) {}
  std::string ended_by() const { return {}; }
};

template <class Controller>
door(Controller&) -> door<Controller>;
template <class Controller>
door(Controller&, const door_settings&) -> door<Controller>;
template <class Controller>
door(Controller&, const door_settings&, std::vector<run_command<Controller>>) -> door<Controller>;

}  // namespace cca
