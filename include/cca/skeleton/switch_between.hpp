// A switch: passes on one of its sources, and hands over to another without a bump.
//
//   cca::node<"mode", cca::switch_between<"angles", leg_angles, "stand", "trot", "reach">>
//   in  "stand", "trot", "reach"   Space: its sources
//   in  "choice"                   a status over x: the number of a source, counted from 0
//   out "angles"                   Space, with the oldest origin of the sources that contribute
//   out "settled"                  a status over x: 1 if only the chosen source contributes, else 0
//
// A hand-over takes `duration` seconds. Both sources keep contributing; the weights move from where they are
// to the chosen source alone along s(u) = u^3 (10 - 15 u + 6 u^2), which begins and ends with velocity and
// acceleration zero (minimum jerk: Flash and Hogan 1985). Samples are mixed by the domain's own
// interpolation. Another choice during a hand-over begins a new one from the current weights. A choice that
// names no source is ignored; the choice of a source that has not published yet takes effect once it does.
// Put a limiter after it. Parameters: `duration`; a change takes effect at the next hand-over. Errors:
// skeleton.arity. Cost: one interpolation per source but the first, only during a hand-over. Example:
// tests/runtime/skeleton/mixing.cpp; docs/skeletons.md.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include <cca/base/array_size.hpp>
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
    const bool has_published[] = {sources.origin() != never...};
    const double number = wanted.vector().coeff(0);
    int next = number >= 0 && number < count ? static_cast<int>(number) : chosen;
    if (next < 0 || !has_published[next]) next = chosen;
    if (next != chosen) {
      begin = weights;
      passed = 0;
      span = chosen < 0 ? 0 : double(p.duration);  // the first choice needs no hand-over
      chosen = next;
    }
    const bool settled = move(now.dt());
    const auto mean = settled ? one_of<Space>(chosen, sources...) : mixed_of<Space>(weights, sources...);
    return {out<Output, Space>(mean).with_origin(mean.origin()), out<"settled", flag>(settled ? 1 : 0)};
  }

  // The next choice takes effect without a hand-over.
  void on_start() {
    chosen = -1;
    weights = {1};
  }

private:
  static constexpr int count = sizeof...(Sources);

  // Moves the weights; true once only the chosen source contributes.
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
    span = 0;  // stay settled
    return true;
  }

  std::array<double, array_size(count)> weights{1}, begin{1};
  double passed = 0, span = 0;  // of the current hand-over, in s
  int chosen = -1;
};

}  // namespace detail

template <fixed_string Output, class Space, fixed_string... Sources>
struct switch_between
    : std::conditional_t<(sizeof...(Sources) >= 2),
                         detail::switch_of<Output, Space, Sources...>,
                         detail::bad_skeleton<detail::too_few_sources<sizeof...(Sources)>>> {};

}  // namespace cca
