// Whether the gains of a contract name the axes of a robot, each of them once: mapping.policy_numbers.
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include <cca/mapping/imported/contract_check.hpp>

namespace cca::detail {

// As a term of the contract, so that names are found as everywhere.
template <class Contract, fixed_string Domain = "joint_angles">
struct gains_of {
  static constexpr std::string_view name = "gains", is = Domain.view();
  static constexpr auto numbers = [] {
    std::array<policy_number, Contract::gains.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i].name = Contract::gains[i].name;
    return all;
  }();
};

// `Driven`: the space of the joints that the gains drive. `Others` must be over the same list of axes.
template <class Contract, class Driven, class... Others>
struct policy_gains_check {
  static constexpr void tell(text& m) {
    if constexpr (std::is_same_v<typename Driven::domain, joint_torques>)
      compare_port<Contract, gains_of<Contract, "joint_torques">, Driven>(m, "drives");
    else compare_port<Contract, gains_of<Contract>, Driven>(m, "drives");
    if (m.size == 0 && !(std::is_same_v<typename Driven::axes, typename Others::axes> && ...))
      m << "mapping.policy_numbers: the spaces of targets, angles, velocities and torques below the policy `"
        << Contract::name << "` are over other axes: give them one list of axes";
  }
  static constexpr bool holds = [] {
    text m;
    tell(m);
    return m.size == 0;
  }();
};

}  // namespace cca::detail
