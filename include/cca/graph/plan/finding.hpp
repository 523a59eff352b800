// The first broken rule of a graph, with the facts that its message needs.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/compiler.hpp>

namespace cca::detail {

struct item_info;
struct function_info;
struct message_writer;

struct finding {
  std::string_view rule{};                                   // its id; empty: no rule is broken
  const item_info* item = nullptr;                           // the item at fault
  int scope = 0;                                             // the graph in which the item stands
  int call = -1, input = -1, other_input = -1, output = -1;  // numbers in the flat graph
  int axis = -1;
  int component = -1;                       // the number of a node
  std::array<int, 3> numbers{-1, -1, -1};   // more, for the rules of a wing, which has names for them
  std::string_view name{};                  // of a port
  std::string_view why{};                   // what a wing says in place of the rule
  void (*tell)(message_writer&) = nullptr;  // the whole message, of a type that refuses to be an inner graph
  const function_info* function = nullptr;  // of the item's component
  bool at_reader = false;                   // the end of a wire: its reader or its writer
  bool is_opposite = false;                 // this end of a wire is a port of the opposite direction
  bool is_reversed = false;                 // and the other end too
  bool is_told = false;                     // an error of the type itself says it

  constexpr bool is_broken() const { return !rule.empty(); }
};

}  // namespace cca::detail
