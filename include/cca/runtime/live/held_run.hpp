// What a program does where there are no beats for a while: before the first one with --paused, after a fault
// with --on-fault hold, and where a run begins anew (docs/door.md).
//
//   begins_after_rest(c, control, goes_on, rested)
//                         true: c is started, and a run is to follow; false: `goes_on(c)` has ended it. Once
//                         a period the robot idles, and then `rested(c)` is called
//   run_and_rest(c, control, held_run{...})
//                         a run, and others after it where somebody asks for them while it rests
//
// `c` is faulted, loaded, or started; a started one is stopped first. Test:
// tests/runtime/door/held_fault.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include <cca/base/monotonic_clock.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/runtime/observers/begun_anew.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca::detail {

// False: nothing is wanted, or it was refused.
template <class Controller>
bool did_begin(Controller& c, run_control& control) {
  switch (control.anew.taken()) {
    case begun_anew::wish::nothing:
      return false;
    case begun_anew::wish::resume:
      if (c.state() == state::faulted) return c.resume(), true;
      control.anew.refuse("resume: nothing has faulted");
      return false;
    case begun_anew::wish::start:
      try {
        if (c.state() == state::faulted) c.stop();
        c.start();
        control.go_on();
        return true;
      } catch (const refused& why) {
        control.anew.is_at(begun_anew::place::stopped);
        control.anew.refuse(why.what());
        return false;
      }
  }
  return false;
}

template <class Controller, class GoesOn, class Rested>
bool begins_after_rest(Controller& c, run_control& control, GoesOn goes_on, Rested rested) {
  constexpr std::int64_t shortest_nap = 1'000'000;  // ns
  if (c.state() == state::started) c.stop();        // a step would be a beat
  while (goes_on(c)) {
    if (did_begin(c, control)) return true;
    c.step();  // the robot idles
    rested(c);
    monotonic_clock::sleep_until(monotonic_clock::now() + std::max(Controller::period(), shortest_nap));
  }
  return false;
}

// A program that is held. Each function gets the controller.
template <class Run, class Held, class GoesOn, class Rested, class Begins>
struct held_run {
  bool holds;      // a fault is held; else it ends the program
  Run run;         // makes beats until something ends them
  Held held;       // a fault is held from now on
  GoesOn goes_on;  // at rest: false ends the program
  Rested rested;
  Begins begins;  // it is started: whether another run is to follow
};

template <class Controller, class... Functions>
void run_and_rest(Controller& c, run_control& control, const held_run<Functions...>& of) {
  begun_anew& anew = control.anew;
  do {
    of.run(c);
    if (c.state() == state::faulted) {
      anew.faults(c.beat_index(), c.fault_path(), std::string(c.fault().reason()),
                  of.holds ? begun_anew::place::faulted : begun_anew::place::elsewhere);
      if (!of.holds) return;
      of.held(c);
    } else if (!anew.is_wanted_to_start()) {
      return;
    }
    if (!begins_after_rest(c, control, of.goes_on, of.rested)) return;
    control.hold_for_next_run();
  } while (of.begins(c));
}

}  // namespace cca::detail
