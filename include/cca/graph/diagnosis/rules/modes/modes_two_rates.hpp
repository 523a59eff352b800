// modes.two_rates: a beat is as long in every mode.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct modes_two_rates {
  static constexpr std::string_view id = "modes.two_rates";

  static constexpr bool is_broken(when::known_rate_of_mode, const flat_view& g, const finding& f) {
    return g.modes->modes[f.in_mode].plan->period != g.modes->modes[f.other_mode].plan->period;
  }

  static constexpr void tell(auto& m) {
    m.where << m.g.modes->name;
    m.mode(m.found().in_mode);
    m.say() << " of " << m.g.modes->name << " runs at " << m.rate_of(m.found().in_mode) << " Hz but ";
    m.mode(m.found().other_mode);
    m.say()
        << " at " << m.rate_of(m.found().other_mode)
        << " Hz: all modes share the beat, so give both graphs the same cca::rate<...>, and what is slower "
           "a cca::timed<N>";
  }
};

}  // namespace cca::detail
