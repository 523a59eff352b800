// How long and how fast a controller runs. The results never depend on it: time in a beat is virtual.
// Errors: run.no_duration, run.no_pace.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/monotonic_clock.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/lifecycle.hpp>

namespace cca {

// Seconds of virtual time: `for_<10>`, `for_<0.5>`.
template <auto Seconds>
struct for_ {
  static constexpr std::int64_t beats(std::int64_t period) {
    return static_cast<std::int64_t>(static_cast<double>(Seconds) * 1e9 / static_cast<double>(period) + 0.5);
  }
};

template <std::int64_t Count>
struct for_beats {
  static constexpr std::int64_t beats(std::int64_t) { return Count; }
};

// Beats known only at run time.
struct for_some_beats {
  std::int64_t count;
  constexpr std::int64_t beats(std::int64_t) const { return count; }
};

// Until `between` returns false, or a fault.
struct without_end {
  static constexpr std::int64_t beats(std::int64_t) { return std::numeric_limits<std::int64_t>::max(); }
};

struct as_fast_as_possible {
  constexpr void begin() {}
  constexpr void wait(std::int64_t) {}
};

namespace detail {

// Beats in step with a clock. A beat that is still running when the next should begin is an overrun. It is
// counted, and the next beat begins at the next whole period: beats are never caught up, so no time of a beat
// is shorter than it should be, and a limiter never counts more time than has passed.
template <class Clock>
class clocked_pace {
public:
  explicit clocked_pace(double factor, Clock c = {}) : clock(c), speed(factor) {
    if (!(factor > 0))
      throw refused("cca::at_speed: " + std::to_string(factor) + " is no pace, expected a number above 0");
  }

  // From the next beat on. False if it is no speed: then nothing changes.
  bool set_speed(double factor) {
    if (!(factor > 0)) return false;
    speed = factor;
    return true;
  }

  // More than n - 1 overruns in a row are a fault of the controller.
  clocked_pace& fault_after(std::int64_t n) {
    if (n < 1)
      throw refused("cca::at_wall_clock().fault_after: " + std::to_string(n) +
                    " is no number of overruns, expected 1 or more");
    most_in_a_row = n;
    return *this;
  }

  void begin() { begin(0, never_begun); }
  // `last`: when a run before this one began its last beat, which must have its whole period too.
  void begin(std::int64_t virtual_period, std::int64_t last) {
    start = clock.now();
    if (last != never_begun)
      start = std::max(start, later(std::min(last, start), duration_of(virtual_period)));
    before = 0;
    begun = never_begun;
    count = lost = in_a_row = 0;
  }

  // Waits until the beat at this virtual time begins, whole periods later after an overrun.
  void wait(std::int64_t virtual_nanoseconds) {
    const std::int64_t period = std::max<std::int64_t>(1, duration_of(virtual_nanoseconds - before));
    before = virtual_nanoseconds;
    std::int64_t due = later(start, duration_of(virtual_nanoseconds));
    const std::int64_t late = clock.now() - due;
    if (late > 0 && virtual_nanoseconds > 0) {
      const std::int64_t periods = (late + period - 1) / period;
      start = later(start, periods * period);
      due = later(due, periods * period);
      lost += periods;
      ++count;
      ++in_a_row;
      if (fault()) return;
    } else {
      in_a_row = 0;
    }
    clock.sleep_until(due);
    begun = due;
  }

  // Sleeps a while if the next beat is farther off than that. False: it is not, and this returns at once. So
  // a run whose beats are far apart can be ended in between, and its speed be changed.
  bool dozes(std::int64_t virtual_period, std::int64_t nap) {
    const std::int64_t now = clock.now();
    const std::int64_t due = begun == never_begun ? start : later(begun, duration_of(virtual_period));
    if (due - now <= nap) return false;
    clock.sleep_until(now + nap);
    return true;
  }

  // Beats that were still running when the next should begin, and the periods in which no beat began. Of this
  // run; a controller adds them up.
  std::int64_t overruns() const { return count; }
  std::int64_t lost_periods() const { return lost; }
  cca::fault fault() const {
    return in_a_row >= most_in_a_row
               ? cca::fault("overruns in a row: the beats take longer than their period")
               : cca::fault();
  }
  std::int64_t last_begun() const { return begun; }
  // How long a virtual time lasts.
  std::int64_t duration_of(std::int64_t virtual_nanoseconds) const {
    return static_cast<std::int64_t>(
        std::min(static_cast<double>(virtual_nanoseconds) / speed, static_cast<double>(longest)));
  }

  static constexpr std::int64_t never_begun = std::numeric_limits<std::int64_t>::lowest();

private:
  static constexpr std::int64_t longest = 9'000'000'000'000'000'000;
  static std::int64_t later(std::int64_t time, std::int64_t by) {
    return time > longest - by ? longest : time + by;
  }

  [[no_unique_address]] Clock clock;
  double speed;
  std::int64_t most_in_a_row = std::numeric_limits<std::int64_t>::max();
  std::int64_t start = 0, before = 0, begun = never_begun;
  std::int64_t count = 0, lost = 0, in_a_row = 0;
};

}  // namespace detail

// A wall-clock run. Virtual time passes `factor` times as fast as the wall clock: 1 real time, 0.1 ten times
// slower, 2 twice as fast. Wakes at absolute times, so a beat that begins a little late does not shift those
// after it.
class at_speed : public detail::clocked_pace<detail::monotonic_clock> {
public:
  explicit at_speed(double factor) : clocked_pace(factor) {}
  at_speed& fault_after(std::int64_t n) {
    clocked_pace::fault_after(n);
    return *this;
  }
};

inline at_speed at_wall_clock() { return at_speed(1); }

// The same on a clock of yours, for tests and simulators: `now()` and `sleep_until(time)`, in nanoseconds.
template <class Clock>
using clocked_pace = detail::clocked_pace<Clock>;

namespace detail {

template <class T> concept Duration = requires(std::remove_cvref_t<T>& duration) {
  { duration.beats(std::int64_t{}) } -> std::convertible_to<std::int64_t>;
};

template <class T> concept Pace = requires(std::remove_cvref_t<T>& pace) { pace.wait(std::int64_t{}); };

template <class...>
inline constexpr bool has_duration = false;
template <class First, class... Others>
inline constexpr bool has_duration<First, Others...> = Duration<First>;

template <class...>
inline constexpr bool has_pace = true;  // the default
template <class First, class Second, class... Others>
inline constexpr bool has_pace<First, Second, Others...> = Pace<Second>;

template <class... Arguments> concept RunArguments = has_duration<Arguments...> && has_pace<Arguments...>;

// What run() is given otherwise.
template <class Argument>
constexpr std::string_view argument_in_words() {
  constexpr auto name = type_name<std::remove_cvref_t<Argument>>();
  return name.find("lambda") != name.npos ? "a function" : name;
}
template <class... Arguments>
struct no_duration {
  static constexpr void tell(text& m) {
    m << "run.no_duration: the first argument of run() is no duration";
    first<Arguments...>(m);
    m << ": write cca::for_<10>{} for seconds, cca::for_beats<200>{}, cca::for_some_beats{n} for a number "
         "that is known at run time, or cca::without_end{}";
  }

private:
  template <class... None>
    requires(sizeof...(None) == 0)
  static constexpr void first(text& m) {
    m << ", for there is none";
  }
  template <class First, class... Others>
  static constexpr void first(text& m) {
    m << " but `" << argument_in_words<First>() << "`";
  }
};
template <class...>
struct no_pace;
template <class First, class Second, class... Others>
struct no_pace<First, Second, Others...> {
  static constexpr void tell(text& m) {
    m << "run.no_pace: the second argument of run() is no pace but `" << argument_in_words<Second>()
      << "`: write cca::as_fast_as_possible{} or cca::at_wall_clock() after the duration, and third what is "
         "called between two beats, a function or a cca::live_access";
  }
};

// Only the first mistake is told: who leaves out the duration may mean the right pace.
template <class... Arguments>
consteval state refuse_run() {
  static_assert(holds_or_tells<has_duration<Arguments...>, no_duration<Arguments...>>::value);
  static_assert(
      holds_or_tells<(!has_duration<Arguments...> || has_pace<Arguments...>), no_pace<Arguments...>>::value);
  return {};
}

}  // namespace detail
}  // namespace cca
