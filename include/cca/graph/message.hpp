// What a refused graph is told: the rule's id, what is wrong and where, with both ends, why, and what to do.
#pragma once

#include <cca/graph/message_clocks.hpp>
#include <cca/graph/message_components.hpp>
#include <cca/graph/message_wires.hpp>

namespace cca::detail {

struct respelling {
  std::string_view from, to;
};

// Types as they were written rather than as the compilers spell them: in<angles, leg_angles>& and
// std::string.
template <class Text>
constexpr Text as_written(const Text& whole) {
  Text t;
  std::string_view spelled = whole.view();
  constexpr std::string_view names[] = {"cca::fixed_string<", "fixed_string<"};
  constexpr respelling others[] = {{"std::__cxx11::basic_string<char>", "std::string"},
                                   {"std::basic_string<char>", "std::string"},
                                   {"(anonymous namespace)::", ""},
                                   {"{anonymous}::", ""},
                                   {" *", "*"},
                                   {" &", "&"},
                                   {" >", ">"}};
  while (!spelled.empty()) {
    std::size_t used = 0;
    for (const auto name : names)
      if (used == 0 && spelled.starts_with(name)) {
        const auto from = spelled.find('"') + 1, to = spelled.find('"', from);
        t << spelled.substr(from, to - from);
        used = to + 1;
        while (used < spelled.size() && spelled[used] == '}') ++used;
      }
    for (const auto& [from, to] : others)
      if (used == 0 && spelled.starts_with(from)) {
        t << to;
        used = from.size();
      }
    if (used == 0) t << spelled.substr(0, used = 1);
    spelled.remove_prefix(used);
  }
  return t;
}

constexpr void tell(auto& t) {
  const auto broken = t.found().broken;
  if (broken == rule::none) return;
  t.say() << rule_ids[static_cast<std::size_t>(broken)] << ": ";
  switch (broken) {
    case rule::graph_unknown_item:
      return tell_unknown_item(t);
    case rule::node_bad_name:
      return tell_bad_name(t);
    case rule::strategy_no_fires:
      return tell_no_fires(t);
    case rule::wire_bad_option:
      return tell_bad_option(t);
    case rule::node_duplicate_name:
      return tell_duplicate_name(t);
    case rule::skeleton_arity:
      return tell_arity(t);
    case rule::component_no_process:
      return tell_no_process(t);
    case rule::component_bad_parameter:
      return tell_bad_signature(t, true);
    case rule::component_bad_result:
      return tell_bad_signature(t, false);
    case rule::component_hook_signature:
      return tell_hook(t);
    case rule::parameters_unsupported_type:
      return tell_parameters(t);
    case rule::space_duplicate_axis:
      return tell_duplicate_axis(t);
    case rule::strategy_unknown_port:
      return tell_unknown_trigger(t);
    case rule::strategy_misplaced:
      return tell_misplaced(t);
    case rule::wire_unknown_port:
      return tell_unknown_port(t);
    case rule::wire_direction:
      return tell_direction(t);
    case rule::wire_two_writers:
      return tell_two_writers(t);
    case rule::wire_bad_initial:
      return tell_bad_initial(t);
    case rule::space_mismatch:
      return tell_mismatch(t);
    case rule::wire_unconnected_input:
      return tell_unconnected(t);
    case rule::rate_missing:
      return tell_rate_missing(t);
    case rule::strategy_never_fires:
      return tell_never_fires(t);
    case rule::graph_algebraic_loop:
      return tell_loop(t);
    case rule::rate_mismatch:
      return tell_rate_mismatch(t);
    case rule::rate_unstated:
      return tell_rate_unstated(t);
    case rule::queue_overflow:
      return tell_overflow(t);
    case rule::strategy_coordination:
      return tell_coordination(t);
    case rule::space_missing_limits:
      return tell_missing_limits(t);
    case rule::robot_unlimited_command:
      return tell_unlimited(t);
    case rule::latency_exceeded:
      return tell_latency(t);
    case rule::none:
    case rule::count:
      break;
  }
}

}  // namespace cca::detail
