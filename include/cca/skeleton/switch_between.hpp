// A switch: one of its sources goes on, and another one takes over without a bump.
//
//   cca::node<"mode", cca::switch_between<"angles", leg_angles, "stand", "trot", "reach">>
//   in  "stand", "trot", "reach"   Space: its sources
//   in  "choice"                   a status over x: the number of a source, from 0 in the order of their
//   names out "angles"                   Space, which originates at the oldest of the sources that have a
//   part in it out "settled"                  a status over x: 1 once the chosen source is all that goes on,
//   0 during a hand-over
//
// A hand-over takes `duration` seconds. Both sources go on being heard; the weights move from what they are
// to the chosen source alone along s(u) = u^3 (10 - 15 u + 6 u^2), which begins and ends with velocity and
// acceleration zero (minimum jerk: Flash and Hogan 1985). Between them it's the domain's own interpolation.
// Another choice during a hand-over begins a new one from where it is. A choice that names no source, or one
// that has not published yet, is not followed until it does. Parameters: `duration`; what is set during a
// hand-over holds from the next one on. Errors: skeleton.arity. A limiter belongs behind it. Cost: an
// interpolation for each source but the first, and only during a hand-over. Example:
// tests/runtime/skeleton/mixing.cpp; docs/skeletons.md.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/skeleton/arity.hpp>
#include <cca/skeleton/mixed.hpp>
#include <cca/skeleton/signals.hpp>

namespace cca {

namespace detail {

template <fixed_string Output, class Space, fixed_string... Sources>
struct switch_of {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (bounded<double, 0, 3600>, duration));
  };
  parameters p{0.5};

  auto process(in<Sources, Space>... sources, in<"choice", choice> wanted, beat now)
      -> std::tuple<out<Output, Space>, out<"settled", flag>> {
    const bool spoken[] = {sources.origin() != never...};
    const double number = wanted.vector().coeff(0);
    int next = number >= 0 && number < count ? static_cast<int>(number) : chosen;
    if (next < 0 || !spoken[next]) next = chosen;
    if (next != chosen) {
      begin = weights;
      passed = 0;
      span = chosen < 0 ? 0 : double(p.duration);  // the first one takes over nothing
      chosen = next;
    }
    const bool settled = move(now.dt());
    const auto mean = settled ? one_of<Space>(chosen, sources...) : mixed_of<Space>(weights, sources...);
    return {out<Output, Space>(mean).with_origin(mean.origin()), out<"settled", flag>(settled ? 1 : 0)};
  }

  // The next choice is taken at once.
  void on_start() {
    chosen = -1;
    weights = {1};
  }

private:
  static constexpr int count = sizeof...(Sources);

  // True once only the chosen source is left.
  bool move(double dt) {
    if (chosen < 0) return false;
    const double u = passed + dt < span ? (passed += dt) / span : 1;
    const double s = u * u * u * (10 - 15 * u + 6 * u * u);
    if (u < 1) {
      for (std::size_t i = 0; i < count; ++i)
        weights[i] = begin[i] + s * ((static_cast<int>(i) == chosen) - begin[i]);
      return false;
    }
    weights = {};
    weights[static_cast<std::size_t>(chosen)] = 1;
    span = 0;  // so it stays
    return true;
  }

  std::array<double, count> weights{1}, begin{1};
  double passed = 0, span = 0;  // of a hand-over, s
  int chosen = -1;
};

}  // namespace detail

template <fixed_string Output, class Space, fixed_string... Sources>
struct switch_between : std::conditional_t<(sizeof...(Sources) >= 2),
                                           detail::switch_of<Output, Space, Sources...>,
                                           detail::uneven<detail::too_few_sources<sizeof...(Sources)>>> {};

}  // namespace cca
