// The joints of an Oncilla, each with a drive of a number on a bus.
#pragma once

#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/oncilla.hpp>

namespace hw = cca::hardware;
namespace sim = cca::sim;

template <class Axis, std::uint32_t Number, std::size_t Bus>
using joint =
    hw::joint<Axis, hw::mit_drive<hw::ak60_6, Number>, hw::mounting{}, hw::joint_servo{.stiffness = 30}, Bus>;
struct board : hw::sensor_board<0x40, 4> {};
