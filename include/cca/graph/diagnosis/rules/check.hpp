// Asks the rules that look at an event, in the order of rules.hpp, and keeps the first that is broken.
//
// Cost: for each event one table of functions, and while compiling a graph only calls of those rules.
#pragma once

#include <array>

#include <cca/graph/diagnosis/rules/rules.hpp>

namespace cca::detail {

template <class Rule, class Event>
constexpr bool asks = requires(const flat_view& g, finding& facts) { Rule::is_broken(Event{}, g, facts); };

template <class Rule, class Event>
constexpr bool is_rule_broken(const flat_view& g, finding& facts) {
  if (!Rule::is_broken(Event{}, g, facts)) return false;
  facts.rule = Rule::id;
  return true;
}

struct rule_table {
  std::array<bool (*)(const flat_view&, finding&), 8> rules{};
  std::size_t count = 0;
};

template <class Event, class... Rules>
constexpr rule_table make_rule_table(list<Rules...>) {
  rule_table table;
  const auto add = [&]<class Rule>(list<Rule>) {
    if constexpr (asks<Rule, Event>) table.rules[table.count++] = &is_rule_broken<Rule, Event>;
  };
  (add(list<Rules>{}), ...);
  return table;
}

// An event of a wing says which list is asked: its own.
template <class Event>
constexpr rule_table ask_rules() {
  if constexpr (requires { typename Event::asked; })
    return make_rule_table<Event>(typename Event::asked::type{});
  else return make_rule_table<Event>(rules{});
}
template <class Event>
inline constexpr rule_table rules_for = ask_rules<Event>();

template <class Event>
constexpr void check(flat_view& g, const finding& facts) {
  if (g.found.is_broken()) return;
  for (std::size_t r = 0; r < rules_for<Event>.count; ++r) {
    finding f = facts;
    if (rules_for<Event>.rules[r](g, f)) {
      g.found = f;
      return;
    }
  }
}

// The rules that look at a call, for each call.
template <class Event>
constexpr void check_calls(flat_view& g) {
  for (int c = 0; c < g.call_count; ++c)
    check<Event>(g, {.item = &item_of_call(g, g.calls[c]), .scope = scope_of_call(g, g.calls[c]), .call = c});
}

// The number of the rule with this id in the list.
template <class... Rules>
constexpr std::size_t number_of_rule(std::string_view id, list<Rules...>) {
  const std::string_view ids[] = {Rules::id...};
  std::size_t n = 0;
  while (n + 1 < sizeof...(Rules) && ids[n] != id) ++n;
  return n;
}

}  // namespace cca::detail
