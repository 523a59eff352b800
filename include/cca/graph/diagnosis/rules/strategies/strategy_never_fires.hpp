// strategy.never_fires: a strategy can fire: its numbers make sense, an input that it waits for is wired, and
// clocks under all_of have a beat in common.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/plan/arrivals.hpp>

namespace cca::detail {

struct strategy_never_fires {
  static constexpr std::string_view id = "strategy.never_fires";

  static constexpr bool is_broken(when::connected_call, const flat_view& g, const finding& f) {
    const auto& strategy = strategy_of_call(g, g.calls[f.call]);
    return part_with_mistake(strategy) || waits_in_vain(g, g.calls[f.call]) ||
           part_that_excludes_itself(strategy);
  }

  static constexpr void tell(auto& m) {
    const auto& call = m.g.calls[m.found().call];
    const auto& strategy = strategy_of_call(m.g, call);
    m.at_node();
    m.node();
    if (const auto part = part_with_mistake(strategy)) {
      m.say() << " " << part->mistake;
    } else if (waits_in_vain(m.g, call)) {
      m.say() << " fires only when a sample arrives, but no input that it waits for is wired: wire one, or "
                 "make it "
                 "cca::timed";
    } else {
      tell_excluded(m, strategy);
    }
  }

private:
  // A strategy without parts is a user's own, whose reasons are its own, too.
  static constexpr void tell_excluded(auto& m, const strategy_info& strategy) {
    const ref<strategy_info> excluded = part_that_excludes_itself(strategy);
    const bool by_clocks = excluded->part_count > 0;
    if (strategy.excludes_itself && by_clocks) {
      m.say()
          << " never fires: the clocks under its cca::all_of have no beat in common; change a period or a "
             "phase";
      return;
    }
    m.say() << (strategy.excludes_itself ? " never fires: no beat can satisfy " : " has ");
    excluded->add_name(m.say());
    if (strategy.excludes_itself) m.say() << "; choose another strategy";
    else if (by_clocks)
      m.say()
          << " in its strategy, which never fires: its clocks have no beat in common; change a period or a "
             "phase, or remove it";
    else m.say() << " in its strategy, which no beat can satisfy: remove it";
  }
  static constexpr ref<strategy_info> part_with_mistake(const strategy_info& strategy) {
    return find_part(strategy, [](const strategy_info& s) { return !s.mistake.empty(); });
  }
  static constexpr ref<strategy_info> part_that_excludes_itself(const strategy_info& strategy) {
    return find_part(strategy, [](const strategy_info& s) { return s.excludes_itself; });
  }
};

}  // namespace cca::detail
