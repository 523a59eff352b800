// Other threads look at a controller that runs, and ask it for changes. Neither side waits: a loop writes
// what it observes into rings, and takes at most one request between two beats.
//
//   cca::live_access live(c);                                    // before the run
//   std::thread window([&] {
//     const auto leg = live.newest("robot.angles");              // an output that the graph observes
//     if (!live.set("gait.frequency", 2.0)) { /* busy: later */ }
//   });
//   c.run(cca::for_<10>{}, cca::at_wall_clock(), live);          // as `between`
//
// It also pauses the run, makes single beats, changes the speed and saves parameters.
//
// It is made from the controller of a graph or of a set of modes, or from a cca::deployed. There each
// environment of this process shows its outputs and takes its part of a request between two of its own beats,
// in its own thread, at any pace. What no beat has taken is taken when the run ends.
//
// Any thread may call any member function but the call operator, after_beat, after_last_beat, goes_on and
// run_ended, which are the loops'. A request is checked in the thread that makes it. If it can't be done,
// `cca::refused` is thrown in that thread, with the message that the controller would give. `false`: an
// earlier request has not been taken yet. Parameters are those of the time when this was made, and what was
// set through it since then: while it is in use, set them through it alone. Cost: what is observed is copied
// once, and one atomic number is read. set and load of a path or file need <cca/config.hpp>. Example:
// tests/runtime/core/live.cpp; docs/controller.md, docs/environments.md.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/live/live_outputs.hpp>
#include <cca/runtime/live/live_requests.hpp>
#include <cca/runtime/live/no_live_access.hpp>

namespace cca {
namespace detail {

template <class Controller, class Graph>
class live_access_to : public live_outputs<Controller, Graph>, public live_requests<Controller, Graph> {
public:
  explicit live_access_to(const Controller& c)
      : live_outputs<Controller, Graph>(c),
        live_requests<Controller, Graph>(c),
        paces(live_components::gives_beat(c)) {
    look(c);
  }

  // As of the last beat, and of the end of a run; of a deployment, those of the first environment of this
  // process.
  cca::state state() const noexcept { return now.load(std::memory_order_acquire); }
  std::int64_t beat_index() const noexcept { return k.load(std::memory_order_acquire); }
  std::int64_t overruns() const noexcept { return late.load(std::memory_order_acquire); }
  cca::fault fault() const noexcept {
    const char* const why = reason.load(std::memory_order_acquire);
    return why ? cca::fault(why) : cca::fault();
  }
  // Of a set of modes: the active one.
  std::string_view mode() const noexcept
    requires Modes<Graph>
  {
    return live_components::mode_name<Controller>(active.load(std::memory_order_acquire));
  }

  // The run ends after its beat; so does each later one.
  void end_run() noexcept { ends.store(true, std::memory_order_release); }
  bool is_ending() const noexcept { return ends.load(std::memory_order_acquire); }

  // The loop pauses after its beat: resource nodes idle once a period, so that a robot goes on getting
  // frames, and requests are taken. `is_paused()` tells when it has. `step()` makes one beat in a pause,
  // `go_on()` ends it; nothing is caught up. Of a deployment all environments pause; ask the process of the
  // first one.
  void pause() { controlled().pause(); }
  void go_on() { controlled().go_on(); }
  void step() { controlled().step(); }
  bool is_paused() const noexcept { return commands.is_paused(); }
  // Whether this process runs the environment that gives the beat: only that one pauses the run.
  bool gives_beat() const noexcept { return paces; }
  // Of a wall-clock run, times the clock: 0.5 is half as fast. Refused: what is not above 0. A fast run has
  // no speed: then has_refused_speed() is true when the loop has looked.
  void set_speed(double factor) {
    if (!(factor > 0) || factor > std::numeric_limits<double>::max())
      throw refused("cca::live_access: set_speed: " + std::to_string(factor) +
                    " is no speed, expected a number above 0");
    controlled().set_speed(factor);
  }
  bool has_refused_speed() const noexcept { return commands.has_refused_speed(); }

  // The loop's.
  run_control& control() noexcept { return commands; }
  void run_ended(const Controller& c) noexcept {
    commands.end_run();
    look(c);
  }

protected:
  template <int Loop>
  void look_after(Controller& c) {
    live_outputs<Controller, Graph>::template look<Loop>(c);
    live_requests<Controller, Graph>::template take<Loop>(c);
  }
  // False: another thread has called `end_run()`.
  bool look(const Controller& c) noexcept {
    now.store(c.state(), std::memory_order_release);
    k.store(c.beat_index(), std::memory_order_release);
    late.store(c.overruns(), std::memory_order_release);
    const cca::fault why = c.fault();
    reason.store(why ? why.reason() : nullptr, std::memory_order_release);
    active.store(live_components::active_mode(c), std::memory_order_release);
    return !ends.load(std::memory_order_acquire);
  }

private:
  // Only the loop that gives the beat can pause.
  run_control& controlled() {
    if (!paces)
      throw refused(
          "cca::live_access: another process runs the environment that gives the beat, so only that "
          "one can pause the run or change its speed");
    return commands;
  }

  run_control commands;
  bool paces = true;
  std::atomic<cca::state> now{};
  std::atomic<std::int64_t> k{0}, late{0};
  std::atomic<const char*> reason{nullptr};
  std::atomic<int> active{0};
  std::atomic<bool> ends{false};
};

template <class Type>
struct not_live {
  static constexpr void tell(text& m) {
    m << "cca::live_access: it is made from a cca::controller or a cca::deployed, and `" << type_name<Type>()
      << "` is neither: give it the one that runs the graph";
  }
};

}  // namespace detail

template <class Controller>
class live_access {
  static_assert(detail::holds_or_tells<false, detail::not_live<Controller>>::value);

public:
  explicit live_access(const Controller&) {}
};

template <class Graph>
class live_access<controller<Graph>> : public detail::live_access_to<controller<Graph>, Graph> {
public:
  using detail::live_access_to<controller<Graph>, Graph>::live_access_to;

  // The loop's, between two beats.
  bool operator()(controller<Graph>& c) {
    this->template look_after<0>(c);
    return this->look(c);
  }
  bool while_paused(controller<Graph>& c) { return (*this)(c); }
  // What no beat has taken.
  void after_last_beat(controller<Graph>& c) { this->template look_after<0>(c); }
};

// Give it to `run` as it is: in a function of yours it would see one environment only, so it does not
// compile.
template <class D>
class live_access<deployed<D>> : public detail::live_access_to<deployed<D>, D> {
public:
  using detail::live_access_to<deployed<D>, D>::live_access_to;

  // The loops': of each environment in its thread, and after each beat of the first.
  template <int Environment>
  void after_beat(deployed<D>& d) {
    this->template look_after<Environment>(d);
  }
  bool goes_on(deployed<D>& d) { return this->look(d); }
  // The first environment's; the others look by themselves while they wait for its next beat.
  bool while_paused(deployed<D>& d) {
    this->template look_after<0>(d);
    return this->look(d);
  }
};

// Of a controller that breaks a rule: the message is the controller's.
template <class Graph>
  requires(!well_formed<Graph>)
class live_access<controller<Graph>> : public detail::no_live_access {
public:
  explicit live_access(const controller<Graph>&) {}
};
template <class D>
  requires(!well_formed<D>)
class live_access<deployed<D>> : public detail::no_live_access {
public:
  explicit live_access(const deployed<D>&) {}
};

template <class Controller>
live_access(const Controller&) -> live_access<Controller>;

}  // namespace cca
