#pragma once
// What each step asks of the skills.
//
//   in  "step"       step_port
//   in  "pose"       hand             measured
//   in  "first"      hand             where the shown movement began
//   in  "last"       hand             where it ended
//   out "goal"       hand             of the path
//   out "go"         restart_signal   the path begins
//   out "speed"      speed            of the path, at most
//   out "target"     hand             of the repeated movement
//   out "begin"      restart_signal   the repeated movement begins
//   out "centre"     hand             about which it wipes: where the table was found
//   out "amplitude"  over<amplitude, stroke>
//
// Parameters: `shift` of the goal of the second repetition, m; `above` the table, where the search begins,
// and how far `below` it ends at most, m.
#include <tuple>

#include <cca/adaptive/sequencer.hpp>
#include <cca/component/parameters.hpp>

#include "plan.hpp"

namespace touch {

struct orders {
  struct parameters {
    using point = Eigen::Vector3d;
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (point, shift),
                             (point, above),
                             (cca::bounded<double, 0, 1>, below),
                             (cca::bounded<double, 0.001, 10>, fastest),
                             (cca::bounded<double, 0.001, 10>, searching));
    parameters() : shift(0, 0.1, 0), above(0.5, 0, 0.36), below(0.12), fastest(0.25), searching(0.05) {}
  };
  parameters p{};

  auto process(cca::in<"step", cca::step_port> number,
               cca::in<"pose", hand> pose,
               cca::in<"first", hand> first,
               cca::in<"last", hand> last)
      -> std::tuple<cca::out<"goal", hand>,
                    cca::maybe<"go", cca::restart_signal>,
                    cca::out<"speed", speed>,
                    cca::out<"target", hand>,
                    cca::maybe<"begin", cca::restart_signal>,
                    cca::out<"centre", hand>,
                    cca::out<"amplitude", cca::over<cca::amplitude, stroke>>> {
    const int now = static_cast<int>(number[cca::step_axis{}]);
    const bool is_new = now != step;
    step = now;
    if (is_new) choose(pose.vector(), first.vector(), last.vector());
    cca::maybe<"go", cca::restart_signal> go;
    cca::maybe<"begin", cca::restart_signal> begin;
    if (is_new && !presses(step)) go = 1.0;
    if (is_new && step == plan::at<"return">) go = 1.0;
    if (is_new && repeats(step)) begin = 1.0;
    const bool strokes = step == plan::at<"wipe"> || step == plan::at<"wipe on">;
    return {goal,
            go,
            step == plan::at<"search"> ? p.searching.value() : p.fastest.value(),
            target,
            begin,
            centre,
            strokes ? 1.0 : -1.0};
  }

  void on_start() { step = -1; }

private:
  using vector = hand::vector_type;

  static vector looking_down(const Eigen::Vector3d& at) {
    vector v;
    v << at, 1, 0, 0, 0;  // half a turn about x
    return v;
  }

  void choose(const vector& here, const vector& first, const vector& last) {
    if (step <= 0) goal = target = centre = here;
    else if (step == plan::at<"go back"> || step == plan::at<"go back again">) goal = first;
    else if (step == plan::at<"repeat">) target = last;
    else if (step == plan::at<"repeat elsewhere">) target = last, target.head<3>() += p.shift;
    else if (step == plan::at<"above the table">) goal = looking_down(p.above);
    else if (step == plan::at<"search">) goal = looking_down(p.above - p.below * Eigen::Vector3d::UnitZ());
    else if (step == plan::at<"wipe">) centre = here;
    else if (step == plan::at<"return">) goal = centre;
    else if (step == plan::at<"lift">) goal = looking_down(p.above);
  }

  int step = -1;
  vector goal = cca::sample<hand>{}.vector(), target = goal, centre = goal;
};

}  // namespace touch
