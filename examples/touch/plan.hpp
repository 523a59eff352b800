#pragma once
// The order of the skills. Steps wait for a status of another part; only the wiping at the end has a time.
//
// A condition stands with the step that it starts.
#include <cca/adaptive/component_status.hpp>
#include <cca/adaptive/sequence.hpp>
#include <cca/robot/compliance/contact_reaction.hpp>

#include "spaces.hpp"

namespace touch {

struct arrived : cca::is<"path.status", way::arrived> {};
struct reached : cca::is<"repeat.status.component", cca::component_status::reached> {};
struct pushed : cca::is<"watch.status", cca::contact::reacting> {};
struct at_table : cca::is<"feel.status", feeling::table> {};

// [plan]
struct plan
    : cca::steps<
          cca::step<"guided">,
          cca::step<"learn", cca::is<"recorder.status", recording::complete>>,
          cca::step<"go back", cca::is<"repeat.status.module", cca::learning::trained>>,
          cca::step<"repeat", arrived>,
          cca::step<"go back again", reached, cca::held_for<300>, cca::or_after<12000, "above the table">>,
          cca::step<"repeat elsewhere", arrived>,
          cca::step<"above the table", reached, cca::held_for<300>, cca::or_after<12000, "above the table">>,
          cca::step<"search", arrived>,
          cca::step<"wipe", at_table, cca::or_after<8000, "lift">>,
          cca::step<"yield", pushed, cca::or_after<14000, "lift">>,
          cca::step<"return", cca::no<pushed>, cca::or_after<8000, "lift">>,
          cca::step<"wipe on", arrived, cca::or_after<8000, "lift">>,
          cca::step<"lift", cca::after<5000>>,
          cca::step<"rest", arrived>> {};
// [plan end]

constexpr bool wipes(int step) {
  return step == plan::at<"wipe"> || step == plan::at<"return"> || step == plan::at<"wipe on">;
}
// The hand presses on the table.
constexpr bool presses(int step) { return wipes(step) || step == plan::at<"yield">; }
constexpr bool repeats(int step) {
  return step == plan::at<"repeat"> || step == plan::at<"repeat elsewhere">;
}

}  // namespace touch
