// What the Open Dynamics Engine does about its own errors: it ends the process. Here it ends the step.
//
// In a step, an assertion or error of the engine is thrown as `engine_alarm` and caught by the step
// (engine.hpp), whose world is then not used any more. A world that is looked at before and after each step
// (robot/model/plausible.hpp) doesn't get there: this is the last resort. Elsewhere the text is printed, and
// the engine ends the process, because a program that hands it nonsense outside of a step is wrong.
#pragma once

#include <array>
#include <cstdarg>
#include <cstdio>

#include <ode/ode.h>

namespace cca::sim {

struct engine_alarm {
  std::array<char, 200> text{};
};

namespace detail {

inline thread_local bool in_engine_step = false;

// The engine ends the process when this returns.
inline void on_engine_alarm(int, const char* format, va_list values) {
  engine_alarm alarm;
  std::vsnprintf(alarm.text.data(), alarm.text.size(), format, values);
  if (in_engine_step) throw alarm;
  std::fprintf(stderr, "the Open Dynamics Engine refuses a call: %s\n", alarm.text.data());
}

// The engine goes on when this returns. It says so if it can't solve all contacts of a step exactly; what
// follows from it is judged by where the bodies are.
inline void on_engine_message(int, const char*, va_list) {}

}  // namespace detail

// Once per process, for all threads.
inline void listen_to_engine() {
  dSetErrorHandler(&detail::on_engine_alarm);
  dSetDebugHandler(&detail::on_engine_alarm);
  dSetMessageHandler(&detail::on_engine_message);
}

}  // namespace cca::sim
