// Spaces that the ready components make from the user's: named, so that messages stay short.
#pragma once

#include <cca/space/domain.hpp>
#include <cca/space/space.hpp>

namespace cca {

// A domain type over axes of the user's, at whatever rate.
template <class Domain, class... Axes>
struct over : space<Domain, axes<Axes...>> {};

namespace detail {

template <class Domain>
struct rate_domain {
  using type = number;  // in the domain's unit per s
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

// How fast a sample of Whole changes, along the same axes.
template <class Whole>
struct velocity_of : space<typename detail::rate_domain<typename Whole::domain>::type, typename Whole::axes> {
};

struct duration_axis : dimension<"duration"> {};
struct movement_duration : space<number, axes<duration_axis>> {};  // s

struct restart_axis : dimension<"restart"> {};
struct restart_signal : space<number, axes<restart_axis>> {};  // whatever arrives restarts

struct progress_axis : dimension<"progress"> {};
struct movement_progress : space<number, axes<progress_axis>> {};  // the canonical variable: from 1 down to 0

namespace detail {

// Real numbers along each axis, which can be added: what a component that computes on bare vectors can work
// in.
template <class Type> concept LinearSpace = Space<Type> && Type::size == Type::axes::count;

}  // namespace detail
}  // namespace cca
