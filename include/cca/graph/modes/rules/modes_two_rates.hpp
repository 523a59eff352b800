// modes.two_rates: a beat is as long in every mode.
#pragma once

#include <cca/graph/modes/events_of_modes.hpp>

namespace cca::detail {

struct modes_two_rates {
  static constexpr std::string_view id = "modes.two_rates";

  static constexpr bool is_broken(when::known_rate_of_mode, const flat_view& g, const finding& f) {
    return modes_in_plan(g).modes[in_mode(f)].plan->period !=
           modes_in_plan(g).modes[other_mode(f)].plan->period;
  }

  static constexpr void tell(auto& m) {
    m.where << modes_in_plan(m.g).name;
    m.mode(in_mode(m.found()));
    m.say() << " of " << modes_in_plan(m.g).name << " runs at " << m.rate_of(in_mode(m.found()))
            << " Hz but ";
    m.mode(other_mode(m.found()));
    m.say()
        << " at " << m.rate_of(other_mode(m.found()))
        << " Hz: all modes share the beat, so give both graphs the same cca::rate<...>, and what is slower "
           "a cca::timed<N>";
  }
};

}  // namespace cca::detail
