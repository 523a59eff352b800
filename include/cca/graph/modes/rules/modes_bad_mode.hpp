// modes.bad_mode: a set of modes has two or more, each a graph with a name of its own.
#pragma once

#include <cca/graph/modes/events_of_modes.hpp>

namespace cca::detail {

struct modes_bad_mode {
  static constexpr std::string_view id = "modes.bad_mode";

  static constexpr bool is_broken(when::stated_modes, const flat_view& g, const finding&) {
    return modes_in_plan(g).count < 2 || modes_in_plan(g).count > most_modes;
  }
  static constexpr bool is_broken(when::stated_mode, const flat_view& g, const finding& f) {
    const auto& one = modes_in_plan(g).modes[in_mode(f)];
    return !one.is_mode || one.is_deployment || one.is_set || !is_name(one.name) ||
           modes_in_plan(g).number_of(one.name) != in_mode(f);
  }

  static constexpr void tell(auto& m) {
    const auto& all = modes_in_plan(m.g);
    m.where << all.name;
    if (in_mode(m.found()) < 0) {
      m.say() << all.name << " has " << all.count << (all.count == 1 ? " mode" : " modes");
      if (all.count < 2)
        m.say()
            << ", so there is nothing to switch to: write two or more, cca::mode<`name`, graph>, or run the "
               "graph by itself in a cca::controller";
      else m.say() << ", but it may have at most " << most_modes << ": make it smaller";
      return;
    }
    const auto& one = all.modes[in_mode(m.found())];
    if (!one.is_mode) {
      m.say() << "`" << one.type << "` in " << all.name
              << " is no mode, so it would be ignored: write cca::mode<`name`, graph>";
    } else if (one.is_deployment) {
      m.say() << "mode `" << one.name << "` of " << all.name
              << " is a deployment, whose environments would be ignored: give its architecture instead, "
              << one.type;
    } else if (one.is_set) {
      m.say() << "mode `" << one.name << "` of " << all.name << " is a set of modes, " << one.type
              << ", but one set holds all modes: list its modes in " << all.name << " instead of it";
    } else if (one.name.empty()) {
      m.say() << "a mode of " << all.name << " has no name, so nothing could switch to it: give it one";
    } else if (!is_name(one.name)) {
      m.say() << "a mode of " << all.name << " is named `" << one.name
              << "`, but dots join names to paths, and `*` stands for any name: use neither in a name";
    } else {
      m.say() << "two modes of " << all.name << " are named `" << one.name
              << "`, so to switch to it has two meanings: give one another name";
    }
  }
};

}  // namespace cca::detail
