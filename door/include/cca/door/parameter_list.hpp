// The parameters of a controller as a door tells them: each with its value, unit, range or choices. Inner
// tables are taken apart, arrays of numbers are one.
#pragma once

#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/config/by_path.hpp>
#include <cca/door/controls.hpp>

namespace cca::detail {

std::vector<door_parameter> door_parameters(const std::vector<component_values>& all);

given_value given_value_of_door(const door_value& value);

}  // namespace cca::detail

#if !CCA_HAS_COMPILED_DOOR
#include <cca/door/parameter_list_functions.hpp>
#endif
