// rate.missing: a graph has a rate, a rate is above 0, and a beat lasts at least a nanosecond.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct rate_missing {
  static constexpr std::string_view id = "rate.missing";

  static constexpr bool is_broken(when::stated_rate, const flat_view&, const finding& f) {
    return !(f.item->hz > 0);
  }
  static constexpr bool is_broken(when::known_rate, const flat_view& g, const finding&) {
    return g.hz == 0 || g.hz > 1e9;
  }

  static constexpr void tell(auto& m) {
    m.where << m.graph().name;
    if (m.found().item)
      m.say() << "`cca::rate<" << m.item().hz << ">` in " << m.graph().name
              << " is no rate, which is a number of updates per second above 0, as `cca::rate<1000>`; where "
                 "none is meant, leave it out";
    else if (m.g.hz > 0)
      m.say() << m.graph().name << " or one of its spaces states " << m.g.hz
              << " Hz, and a beat is at least a nanosecond long: state at most 1,000,000,000 Hz";
    else
      m.say() << "neither " << m.graph().name
              << " nor any of its spaces states a rate, so a beat has no length: add cca::rate<1000> to the "
                 "graph";
  }
};

}  // namespace cca::detail
