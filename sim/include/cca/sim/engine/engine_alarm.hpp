// What the Open Dynamics Engine does about its own errors: it ends the process. Here it ends the beat.
//
// While an `engine_alarms_thrown` lives, an assertion or error of the engine is thrown as `engine_alarm`. In
// a beat the owner of the engine catches it (engine.hpp), and its world is then not used any more; while a
// world is made it becomes a std::invalid_argument (robot/world/world_in_engine.hpp). Numbers are judged when
// a world is made (checked_scene.hpp), and a world is looked at before and after each step
// (robot/model/plausible.hpp), so this is the last resort. Elsewhere the text is printed, and the engine ends
// the process.
#pragma once

#include <array>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include <ode/ode.h>

namespace cca::sim {

struct engine_alarm {
  std::array<char, 200> text{};
};

namespace detail {

inline thread_local bool engine_alarms_are_thrown = false;

// The engine ends the process when this returns.
inline void on_engine_alarm(int, const char* format, va_list values) {
  engine_alarm alarm;
  std::vsnprintf(alarm.text.data(), alarm.text.size(), format, values);
  if (engine_alarms_are_thrown) throw alarm;
  std::fprintf(stderr, "the Open Dynamics Engine refuses a call: %s\n", alarm.text.data());
}

// The engine goes on when this returns. It says so if it can't solve all contacts of a step exactly; what
// follows from it is judged by where the bodies are.
inline void on_engine_message(int, const char*, va_list) {}

}  // namespace detail

// Of this thread, while it lives.
class engine_alarms_thrown {
public:
  engine_alarms_thrown() = default;
  engine_alarms_thrown(const engine_alarms_thrown&) = delete;
  engine_alarms_thrown& operator=(const engine_alarms_thrown&) = delete;
  ~engine_alarms_thrown() { detail::engine_alarms_are_thrown = before_; }

private:
  bool before_ = std::exchange(detail::engine_alarms_are_thrown, true);
};

// Once per process, for all threads.
inline void listen_to_engine() {
  dSetErrorHandler(&detail::on_engine_alarm);
  dSetDebugHandler(&detail::on_engine_alarm);
  dSetMessageHandler(&detail::on_engine_message);
}

}  // namespace cca::sim
