// The drives on a bus and their rate, checked while compiling.
//
//   struct left : cca::hardware::can_bus_plan<"left", cca::hardware::bit_rates{1'000'000}, cca::rate<400>,
//                                             left_hip, left_knee> {};
//   cca::hardware::socket_can bus("can0", {.replies = left::replies, .ours = left::requests});
//
// `left::load` is the part of the time in which the bus is in use. Each frame of each drive counts with its
// longest form (bus/frame_bits.hpp); frames that end a cycle (SYNC) count once.
// Errors: bus.overloaded, above 90 % (the rest is for repeated frames and for other traffic); it says the
// figures and the rate that is possible. drive.duplicate_id, where two drives listen to, send or occupy one
// id. Drives whose replies name their sender in the first byte (`reply_mark`) may share the id of their
// replies. The buses of a whole robot are planned from its joints: robot/robot_buses.hpp.
// Cost: constants. Example: tests/runtime/hardware/bus_load.cpp; docs/can_bus.md.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/hardware/bus/bus_load.hpp>
#include <cca/hardware/drives/drive.hpp>
#include <cca/space/space.hpp>

namespace cca::hardware {
namespace detail {

template <fixed_string Name, bit_rates Rates, class Rate, Drive... Drives>
struct plan_check {
  static constexpr std::array<drive_facts, sizeof...(Drives)> drives{facts_of<Drives>()...};
  static constexpr bus_figures figures{drives, Rates, Rate::hz};
  static constexpr bool sound = figures.sound();
  static constexpr void tell(cca::detail::text& m) { tell_of_bus(m, Name.view(), drives, figures); }
};

}  // namespace detail

template <fixed_string Name, bit_rates Rates, class Rate, Drive... Drives>
struct can_bus_plan {
  using check = detail::plan_check<Name, Rates, Rate, Drives...>;
  using sound = decltype(detail::check_plan<check>());

  static constexpr std::string_view name = Name.view();
  static constexpr bit_rates rates = Rates;
  static constexpr double load = check::figures.load();
  static constexpr std::int64_t cycle =
      check::figures.use.cycle;  // ns that the frames of one cycle take at most
  static constexpr auto requests = [] {
    detail::filter_list<(0 + ... + (std::size(Drives::requests) + broadcasts_of<Drives>.size()))> all;
    for (const auto& d : check::drives)
      for (const auto& those : {d.requests, d.broadcasts})
        for (const can_filter& f : those) all.add(f);
    return all;
  }();
  static constexpr auto replies = [] {
    detail::filter_list<(0 + ... + std::size(Drives::replies))> all;
    for (const auto& d : check::drives)
      for (const can_filter& f : d.replies) all.add(f);
    return all;
  }();
};

}  // namespace cca::hardware
