// An arbiter: several writers for one input, of which in each beat one is heard (wire.two_writers offers it).
//
//   cca::node<"legs", cca::arbiter<"angles", leg_angles, cca::by_priority<"reflex", "gait">>>
//   in  "reflex", "gait"   Space: the writers
//   out "angles"           Space: what the one says that is heard, and its origin
//   out "writer"           a status over x: its number, from 0 in the order of their names
//
// by_priority: the first named of those that have something new, or had within the last `patience` seconds;
// so a writer that wants to be overruled stays silent (`maybe`). If none has, the one that was heard last
// stays. by_freshness: the one whose sample has the latest origin; of several the first named. It jumps from
// one writer to the next: a limiter belongs behind it, or a switch_between in its place. Parameters:
// `patience`, of by_priority. Errors: skeleton.arity. Cost: a comparison or two a writer. Example:
// tests/runtime/skeleton/arbiter.cpp; docs/skeletons.md.
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
    const auto waits = static_cast<std::int64_t>(p.patience * 1e9 + 0.5);
    int i = 0, first = -1;
    ((heard[i] = writers.fresh() ? now.time() : heard[i],
      first = first < 0 && now.time() - heard[i] <= waits ? i : first, ++i),
     ...);
    if (first >= 0) chosen = first;
    const auto said = one_of<Space>(chosen, writers...);
    return {out<Output, Space>(said).with_origin(said.origin()), out<"writer", choice>(chosen)};
  }

  void on_start() { *this = arbiter_of{.p = p}; }

  static constexpr std::int64_t long_ago = -(std::int64_t{1} << 62);  // farther back than any patience
  std::int64_t heard[sizeof...(Writers)] = {(void(Writers), long_ago)...};
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
    const auto said = one_of<Space>(chosen, writers...);
    return {out<Output, Space>(said).with_origin(said.origin()), out<"writer", choice>(chosen)};
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
struct arbiter : std::conditional_t<(detail::writers_of<Policy> >= 2),
                                    detail::arbiter_of<Output, Space, Policy>,
                                    detail::uneven<detail::too_few_sources<detail::writers_of<Policy>>>> {};

}  // namespace cca
