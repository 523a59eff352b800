// latency.exceeded: no sample is older than a `require` allows.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/plan/latency.hpp>

namespace cca::detail {

struct latency_exceeded {
  static constexpr std::string_view id = "latency.exceeded";

  static constexpr bool is_broken(when::stated_latency, const flat_view& g, const finding& f) {
    const auto age = greatest_age(g, f.output, f.input);
    return age.unbounded || age.beats > f.item->number;
  }

  static constexpr void tell(auto& m) {
    const auto age = greatest_age(m.g, m.found().output, m.found().input);
    m.at_wire();
    m.say() << "a sample of `" << m.item().from << "` can be ";
    if (age.unbounded) m.say() << "of any age";
    else m.say() << age.beats << (age.beats == 1 ? " beat old" : " beats old");
    m.say() << " when `" << m.item().to << "` is read, but " << m.graph().name << " requires at most "
            << m.item().number << ": "
            << (age.unbounded
                    ? "a clock on the way is known only at run time; make those components cca::timed"
                    : "shorten a delay or a queue on the way, or run the components on it more often");
  }
};

}  // namespace cca::detail
