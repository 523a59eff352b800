// What a program does where there are no beats for a while: before the first one with --paused, after a fault
// with --on-fault hold, and where a run begins anew (docs/door.md).
//
//   begins_after_rest(c, control, goes_on, rested)
//                         true: c is started, and a run is to follow; false: `goes_on(c)` has ended it. Once
//                         a period the robot idles, and then `rested(c)` is called
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

}  // namespace cca::detail
