// The buses of a robot, planned at compile time from its joints and its sensor board.
//
//   using buses = cca::hardware::robot_buses<cca::rate<1000>, board, joints>;
//   buses::load<0>   // the part of the time in which bus 0 is in use
//   cca::hardware::socket_can can0("can0", {.replies = buses::replies<0>, .ours = buses::requests<0>});
//
// cca::hardware::robot and oncilla check their buses by it. Each bus is a plan as in bus_plan.hpp, at the bit
// rates of its joints; messages name the joint, and the number of the bus. Errors: bus.overloaded,
// drive.duplicate_id. Cost: constants. Example: tests/runtime/drive_chain/families.cpp; docs/can_bus.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/bus_plan.hpp>
#include <cca/hardware/drives/joint.hpp>

namespace cca::hardware {

namespace detail {

struct user_of_bus {
  std::size_t bus = 0;
  bit_rates rates{};
  drive_facts facts{};
};

template <std::size_t Count>
struct users_of_bus {
  std::array<drive_facts, Count> drives{};
  std::size_t count = 0;
  bit_rates rates{};
  int other = -1;  // the first that states other bit rates than the first of all; -1: there is none
  bit_rates other_rates{};
  constexpr std::span<const drive_facts> view() const { return {drives.data(), count}; }
};
template <std::size_t Count>
constexpr users_of_bus<Count> users_on(const std::array<user_of_bus, Count>& all, std::size_t bus) {
  users_of_bus<Count> on;
  for (const user_of_bus& u : all) {
    if (u.bus != bus || u.facts.traffic.empty()) continue;  // no_board has no traffic
    if (on.count == 0) on.rates = u.rates;
    else if (on.other < 0 && (on.rates.nominal != u.rates.nominal || on.rates.data != u.rates.data))
      on.other = static_cast<int>(on.count), on.other_rates = u.rates;
    on.drives[on.count++] = u.facts;
  }
  return on;
}

template <std::size_t Bus, class Rate, class Board, class Joints>
struct bus_check;
template <std::size_t Bus, class Rate, class Board, class... J>
struct bus_check<Bus, Rate, Board, joint_list<J...>> {
  static constexpr std::size_t most = sizeof...(J) + 1;
  static constexpr auto on =
      users_on<most>({{{J::bus, J::rates, facts_of<typename J::drive>(J::axis::name)}...,
                       {Board::bus, Board::rates, facts_of<Board>()}}},
                     Bus);
  struct two_rates {
    static constexpr void tell(cca::detail::text& m) {
      m << "cca::hardware::robot_buses: ";
      user(m, 0, on.rates);
      m << " and ";
      user(m, static_cast<std::size_t>(on.other), on.other_rates);
      m << " are on bus " << static_cast<std::int64_t>(Bus)
        << ", and a bus has one rate: state the same, or connect one of them to another bus";
    }

  private:
    static constexpr void user(cca::detail::text& m, std::size_t at, const bit_rates& rates) {
      m << "`" << on.drives[at].name << "` (" << static_cast<std::int64_t>(rates.nominal) << " and "
        << static_cast<std::int64_t>(rates.data) << " bit/s)";
    }
  };
  static_assert(cca::detail::holds_or_tells<(on.other < 0), two_rates>::value);
  static constexpr bus_figures figures{on.view(), on.rates, Rate::hz};
  static constexpr bool sound = figures.sound();
  static constexpr void tell(cca::detail::text& m) {
    cca::detail::text name;
    name << static_cast<std::int64_t>(Bus);
    tell_of_bus(m, name.view(), on.view(), figures);
  }
};

// A number is the place of a bus in `connect`.
template <class Board, class... J>
struct bus_without_users {
  static constexpr std::size_t last = std::max({Board::bus, J::bus...});
  static constexpr bool is_used(std::size_t bus) {
    return (bus == Board::bus && !Board::traffic.empty()) || ((bus == J::bus) || ...);
  }
  static constexpr std::size_t first = [] {
    std::size_t bus = 0;
    while (is_used(bus)) ++bus;
    return bus;
  }();
  static constexpr bool none = first > last;
  static constexpr void tell(cca::detail::text& m) {
    m << "robot.drives: nothing of this robot is on bus " << static_cast<std::int64_t>(first) << ", but ";
    if (Board::bus == last && !Board::traffic.empty()) m << "its board";
    else (void)((J::bus == last && (m << "`" << J::axis::name << "`", true)) || ...);
    m << " is on bus " << static_cast<std::int64_t>(last)
      << ": the number of a bus is its place in `connect(bus0, bus1, ...)`, so count them from 0 without a "
         "gap";
  }
};

template <class Buses, std::size_t... Bus>
constexpr auto check_plans(std::index_sequence<Bus...>) {
  return std::bool_constant<(decltype(check_plan<typename Buses::template check<Bus>>())::value && ...)>();
}

}  // namespace detail

template <class Rate, class Board, class Joints>
struct robot_buses;

template <class Rate, class Board, class... J>
struct robot_buses<Rate, Board, joint_list<J...>> {
  static constexpr std::size_t count = 1 + std::max({Board::bus, J::bus...});
  template <std::size_t Bus>
  using check = detail::bus_check<Bus, Rate, Board, joint_list<J...>>;

  static_assert(cca::detail::holds_or_tells<detail::bus_without_users<Board, J...>::none,
                                            detail::bus_without_users<Board, J...>>::value);
  using sound = decltype(detail::check_plans<robot_buses>(std::make_index_sequence<count>()));

  template <std::size_t Bus>
  static constexpr double load = check<Bus>::figures.load();
  // The ids that the controller sends on a bus, and those that it receives.
  template <std::size_t Bus>
  static constexpr auto requests = [] {
    detail::filter_list<Board::requests.size() +
                        (0 + ... + (J::drive::requests.size() + broadcasts_of<typename J::drive>.size()))>
        all;
    for (const auto& d : check<Bus>::on.view())
      for (const auto& those : {d.requests, d.broadcasts})
        for (const can_filter& f : those) all.add(f);
    return all;
  }();
  template <std::size_t Bus>
  static constexpr auto replies = [] {
    detail::filter_list<Board::replies.size() + (0 + ... + J::drive::replies.size())> all;
    for (const auto& d : check<Bus>::on.view())
      for (const can_filter& f : d.replies) all.add(f);
    return all;
  }();
};

}  // namespace cca::hardware
