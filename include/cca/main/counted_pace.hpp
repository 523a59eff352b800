// The pace of a controller in a program: its speed is known only at run time, and it keeps the figures that a
// deployment keeps of its environments.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include <cca/component/fault.hpp>
#include <cca/runtime/environments/figures.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::detail {

struct counted_beats {
  environment_figures figures{};
  std::atomic<std::int64_t> lost_periods{0};
  std::int64_t begun = 0;

  void begin(std::int64_t due) {
    begun = monotonic_clock::now();
    figures.wake_up.add(begun - due);
  }
  void end() { figures.beat.add(monotonic_clock::now() - begun); }
};

// Without a clock nothing is counted.
class counted_pace {
public:
  counted_pace(std::optional<double> speed, counted_beats& into) : beats(&into) {
    if (speed) clock.emplace(*speed);
  }

  void begin(std::int64_t period, std::int64_t last) {
    if (clock) clock->begin(period, last);
  }
  void wait(std::int64_t time) {
    if (!clock) return;
    clock->wait(time);
    if (!clock->fault()) beats->begin(clock->last_begun());
  }
  // False: without a clock there is no speed.
  bool set_speed(double factor) { return clock && clock->set_speed(factor); }
  bool dozes(std::int64_t period, std::int64_t nap) { return clock && clock->dozes(period, nap); }
  cca::fault fault() const { return clock ? clock->fault() : cca::fault(); }
  std::int64_t last_begun() const { return clock ? clock->last_begun() : at_speed::never_begun; }
  std::int64_t duration_of(std::int64_t time) const { return clock ? clock->duration_of(time) : 0; }
  std::int64_t overruns() const { return clock ? clock->overruns() : 0; }
  std::int64_t lost_periods() const { return clock ? clock->lost_periods() : 0; }

private:
  std::optional<at_speed> clock;
  counted_beats* beats;
};

}  // namespace cca::detail
