// An arbiter: several writers for one input; each beat it passes on one of them (wire.two_writers offers it).
//
//   cca::node<"legs", cca::arbiter<"angles", leg_angles, cca::by_priority<"reflex", "gait">>>
//   in  "reflex", "gait"   Space: the writers
//   out "angles"           Space: the sample of the chosen writer, with its origin
//   out "writer"           a status over x: the number of the chosen writer, counted from 0
//
// by_priority: the first named of the writers with a new sample now or within the last `patience` seconds. A
// writer that does not want the output publishes nothing (`maybe`). If no writer has a new sample, the choice
// stays. by_freshness: the writer whose sample has the latest origin; of several, the first named. The output
// jumps from one writer to the next: put a limiter after it, or use a switch_between instead.
// Parameters: `patience`, of by_priority. Errors: skeleton.arity. Cost: one or two comparisons per writer.
// Example: tests/runtime/skeleton/arbiter.cpp; docs/skeletons.md.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/skeleton/arity.hpp>
#include <cca/skeleton/mixed.hpp>
#include <cca/skeleton/signals.hpp>

namespace cca {

template <fixed_string... Writers>
struct by_priority {};
template <fixed_string... Writers>
struct by_freshness {};

namespace detail {

template <fixed_string Output, class Space, class Policy>
struct arbiter_of;

template <fixed_string Output, class Space, fixed_string... Writers>
struct arbiter_of<Output, Space, by_priority<Writers...>> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (bounded<double, 0, 3600>, patience));
  };
  parameters p{0.0};

  auto process(in<Writers, Space>... writers, beat now)
      -> std::tuple<out<Output, Space>, out<"writer", choice>> {
    const auto patience = static_cast<std::int64_t>(p.patience * 1e9 + 0.5);
    int i = 0, first = -1;
    ((last_new[i] = writers.fresh() ? now.time() : last_new[i],
      first = first < 0 && now.time() - last_new[i] <= patience ? i : first, ++i),
     ...);
    if (first >= 0) chosen = first;
    const auto passed_on = one_of<Space>(chosen, writers...);
    return {out<Output, Space>(passed_on).with_origin(passed_on.origin()), out<"writer", choice>(chosen)};
  }

  void on_start() { *this = arbiter_of{.p = p}; }

  static constexpr std::int64_t long_ago = -(std::int64_t{1} << 62);  // before any patience
  std::int64_t last_new[sizeof...(Writers)] = {(void(Writers), long_ago)...};
  int chosen = 0;
};

template <fixed_string Output, class Space, fixed_string... Writers>
struct arbiter_of<Output, Space, by_freshness<Writers...>> {
  auto process(in<Writers, Space>... writers) -> std::tuple<out<Output, Space>, out<"writer", choice>> {
    int i = 0, chosen = 0;
    std::int64_t latest = never;
    ((chosen = writers.origin() > latest ? i : chosen,
      latest = writers.origin() > latest ? writers.origin() : latest, ++i),
     ...);
    const auto passed_on = one_of<Space>(chosen, writers...);
    return {out<Output, Space>(passed_on).with_origin(passed_on.origin()), out<"writer", choice>(chosen)};
  }
};

template <class Policy>
constexpr int writers_of = 0;
template <fixed_string... Writers>
constexpr int writers_of<by_priority<Writers...>> = sizeof...(Writers);
template <fixed_string... Writers>
constexpr int writers_of<by_freshness<Writers...>> = sizeof...(Writers);

}  // namespace detail

template <fixed_string Output, class Space, class Policy>
struct arbiter
    : std::conditional_t<(detail::writers_of<Policy> >= 2),
                         detail::arbiter_of<Output, Space, Policy>,
                         detail::bad_skeleton<detail::too_few_sources<detail::writers_of<Policy>>>> {};

}  // namespace cca
