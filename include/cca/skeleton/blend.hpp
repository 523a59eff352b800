// A blend: a weighted mean of its sources; another component gives the weights, for example the amplitude of
// an oscillator.
//
//   cca::node<"paw", cca::blend<"angles", leg_angles, cpg_amplitude, "reach", "trot">>
//   in  "reach", "trot"   Space: its sources
//   in  "weight"          Weight: one number per source, or for two sources the part of the second
//   out "angles"          Space, with the oldest origin of the sources that contribute
//
// One number: up to `none` the output is the first source, from `full` on the second, to the bit; between
// them in proportion. Several numbers: in proportion; a number that is not above zero counts as zero. If none
// is above zero, the output is the first source. It uses the domain's own interpolation: the shorter arc for
// a phase, slerp for an orientation. Put a limiter after it.
// Parameters: `none`, `full`, of one number. Errors: skeleton.arity. Cost: one interpolation per source but
// the first. Example: tests/runtime/skeleton/mixing.cpp; docs/skeletons.md.
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/skeleton/arity.hpp>
#include <cca/skeleton/mixed.hpp>

namespace cca {

namespace detail {

template <fixed_string Output, class Space, class Weight, fixed_string First, fixed_string Second>
struct blend_of_two {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, none), (double, full));
    constexpr parameters(double only_first = 0, double only_second = 1)
        : none(only_first), full(only_second) {}
    std::string_view check() const { return none < full ? "" : "`none` must be less than `full`"; }
  };
  parameters p{};

  auto process(in<First, Space> first, in<Second, Space> second, in<"weight", Weight> weight)
      -> out<Output, Space> {
    const auto mean = mixed<Space>(first, second, (weight.vector().coeff(0) - p.none) / (p.full - p.none));
    return out<Output, Space>(mean).with_origin(mean.origin());
  }
};

template <fixed_string Output, class Space, class Weight, fixed_string... Sources>
struct blend_of {
  auto process(in<Sources, Space>... sources, in<"weight", Weight> weight) -> out<Output, Space> {
    std::array<double, sizeof...(Sources)> weights;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double w = weight.vector().coeff(static_cast<int>(i));
      weights[i] = w > 0 ? w : 0;
    }
    const auto mean = mixed_of<Space>(weights, sources...);
    return out<Output, Space>(mean).with_origin(mean.origin());
  }
};

template <int Sources, int Weights>
struct wrong_weights {
  static constexpr text message() {
    text t;
    t << "blends " << Sources << " sources by " << Weights << (Weights == 1 ? " weight" : " weights")
      << ", but it takes one for each source, or of two sources one: give it a space of weights with "
      << Sources << " axes";
    if constexpr (Sources == 2) t << ", or with one";
    return t;
  }
};

template <fixed_string Output, class Space, class Weight, fixed_string... Sources>
constexpr auto blend_kind() {
  constexpr int count = sizeof...(Sources);
  if constexpr (count < 2) return std::type_identity<bad_skeleton<too_few_sources<count>>>();
  else if constexpr (count == 2 && Weight::size == 1)
    return std::type_identity<blend_of_two<Output, Space, Weight, Sources...>>();
  else if constexpr (Weight::size == count)
    return std::type_identity<blend_of<Output, Space, Weight, Sources...>>();
  else return std::type_identity<bad_skeleton<wrong_weights<count, Weight::size>>>();
}

}  // namespace detail

template <fixed_string Output, class Space, class Weight, fixed_string... Sources>
struct blend : decltype(detail::blend_kind<Output, Space, Weight, Sources...>())::type {};

}  // namespace cca
