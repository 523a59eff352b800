// Spaces that the components of this folder derive from the user's. They are named structs, so messages stay
// short.
#pragma once

#include <cca/space/domain.hpp>
#include <cca/space/space.hpp>

namespace cca {

// A domain type over the user's axes, without a rate.
template <class Domain, class... Axes>
struct over : space<Domain, axes<Axes...>> {};

namespace detail {

template <class Domain>
struct rate_domain {
  using type = number;  // unit: the domain's per s
};
template <>
struct rate_domain<joint_angles> {
  using type = joint_velocities;
};
template <>
struct rate_domain<joint_velocities> {
  using type = joint_accelerations;
};

}  // namespace detail

// The rate of change of samples of Whole, along the same axes.
template <class Whole>
struct velocity_of : space<typename detail::rate_domain<typename Whole::domain>::type, typename Whole::axes> {
};

struct duration_axis : dimension<"duration"> {};
struct movement_duration : space<number, axes<duration_axis>> {};  // s

struct restart_axis : dimension<"restart"> {};
struct restart_signal : space<number, axes<restart_axis>> {};  // any sample restarts

struct progress_axis : dimension<"progress"> {};
struct movement_progress : space<number, axes<progress_axis>> {};  // the canonical variable: from 1 down to 0

namespace detail {

// One number per axis, and vectors that can be added: what components that compute with plain vectors need.
template <class Type> concept LinearSpace = Space<Type> && Type::size == Type::axes::count;

}  // namespace detail
}  // namespace cca
