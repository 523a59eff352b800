// The joints and the board among what a robot is made of: `cca::hardware::robot<R, Bus, joint, ..., board>`.
#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

#include <cca/hardware/drives/joint.hpp>

namespace cca::hardware::detail {

template <class Drives, class Index>
struct joints_of;
template <class Drives, std::size_t... I>
struct joints_of<Drives, std::index_sequence<I...>> {
  using type = joint_list<std::tuple_element_t<I, Drives>...>;
};

template <std::size_t Count, class... Drives>
using first_joints = typename joints_of<std::tuple<Drives...>, std::make_index_sequence<Count>>::type;

}  // namespace cca::hardware::detail
