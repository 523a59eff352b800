// The rules of sets of modes, and the one of graphs that holds for a set, too.
#pragma once

#include <cca/graph/diagnosis/rules/components/part_unknown_path.hpp>
#include <cca/graph/modes/rules/modes_bad_mode.hpp>
#include <cca/graph/modes/rules/modes_command_jumps.hpp>
#include <cca/graph/modes/rules/modes_missing_robot.hpp>
#include <cca/graph/modes/rules/modes_two_rates.hpp>
#include <cca/graph/modes/rules/modes_two_types.hpp>
#include <cca/graph/modes/rules/modes_unknown_mode.hpp>

namespace cca::detail {

// clang-format off
struct rules_of_modes {
  using type = list<
      part_unknown_path,
      modes_bad_mode,
      modes_two_rates,
      modes_two_types,
      modes_missing_robot,
      modes_unknown_mode,
      modes_command_jumps
  >;
};
// clang-format on

}  // namespace cca::detail
