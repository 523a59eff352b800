// The parts of the robots whose descriptions are spoiled here: an arm of one joint, or of two.
#pragma once

#include <cca/robots/description.hpp>

template <cca::fixed_string Name>
struct joint : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::velocity{-2, 2}, cca::torque{-9, 9}};
};
struct swing : joint<"swing"> {};
struct bend : joint<"bend"> {};
struct wave : joint<"wave"> {};
struct mount : cca::frame<"mount"> {};
struct hand : cca::frame<"hand"> {};

constexpr cca::link_inertia rod{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}};

struct weightless_chain : cca::serial_chain<mount, hand, cca::axes<swing>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};
struct chain_of_one : weightless_chain {
  static constexpr std::array links{rod};
};
struct chain_of_two : cca::serial_chain<mount, hand, cca::axes<swing, bend>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0.3, 0, 0))};
  static constexpr auto tip = cca::at(0.3, 0, 0);
  static constexpr std::array links{rod, rod};
};

template <class Chain, std::size_t Joints>
struct uncommanded {
  struct body : cca::body<mount, cca::part<"arm", Chain>> {};
  using rate = cca::rate<1000>;
  static constexpr std::array<cca::robots::joint_drive, Joints> drives{};
};
template <class Chain = chain_of_one, std::size_t Joints = 1>
struct described : uncommanded<Chain, Joints> {
  using commands = cca::robots::commands<cca::robots::torque_command>;
};

template <class... Axes>
struct torques_of : cca::space<cca::joint_torques, cca::axes<Axes...>, cca::rate<1000>> {};
