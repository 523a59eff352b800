// What run() of a controller and of a deployment may be given, and the sentence where it is given something
// else.
//
//   c.run(cca::for_<10>{}, cca::at_wall_clock(), between);
//
// Errors: run.no_duration, run.no_pace.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace cca::detail {

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

// Only the first mistake is told: who leaves out the duration may mean the right pace.
template <class... Arguments>
consteval void refuse_run() {
  static_assert(has_duration<Arguments...>,
                "run.no_duration: the first argument of run() is no duration: write cca::for_<10>{} for "
                "seconds, cca::for_beats<200>{}, cca::for_some_beats{n} for a number that is known at run "
                "time, or cca::without_end{}");
  static_assert(!has_duration<Arguments...> || has_pace<Arguments...>,
                "run.no_pace: the second argument of run() is no pace: write cca::as_fast_as_possible{} or "
                "cca::at_wall_clock() after the duration, and third what is called between two beats, a "
                "function or a cca::live_access");
}

}  // namespace cca::detail
