// The first broken rule of a graph, with the facts that its message needs.
#pragma once

#include <string_view>

#include <cca/base/compiler.hpp>

namespace cca::detail {

struct item_info;
struct function_info;

struct finding {
  std::string_view rule{};                                   // its id; empty: no rule is broken
  const item_info* item = nullptr;                           // the item at fault
  int scope = 0;                                             // the graph in which the item stands
  int call = -1, input = -1, other_input = -1, output = -1;  // numbers in the flat graph
  int axis = -1;
  int component = -1, environment = -1;                  // of a deployment
  int in_mode = -1, other_mode = -1, other_output = -1;  // of a set of modes
  std::string_view name{};                               // of a port
  const function_info* function = nullptr;               // of the item's component
  bool at_reader = false;                                // the end of a wire: its reader or its writer
  bool is_opposite = false;  // this end of a wire is a port of the opposite direction
  bool is_reversed = false;  // and the other end too

  constexpr bool is_broken() const { return !rule.empty(); }
};

}  // namespace cca::detail
