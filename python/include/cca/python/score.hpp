// What a training is told besides the observations: a reward, and whether the episode is over.
//
//   cca::node<"score", cca::python::score>
//   cca::wire<"judge.reward", "score.reward">, cca::wire<"judge.done", "score.done">
//
//   in  "reward"   reward: each sample counts; a step returns their sum
//   in  "done"     done, optional: a sample that is not 0 ends the episode, as a fall does
//
// Both may come at any rate. Cost: an addition. NaN passes to Python, which sees it.
#pragma once

#include <cca/component/port.hpp>
#include <cca/space/domain.hpp>

namespace cca::python {

struct reward_axis : dimension<"reward"> {};
struct done_axis : dimension<"done"> {};
struct reward : space<number, axes<reward_axis>> {};
struct done : space<number, axes<done_axis>> {};

struct score {
  void process(in<"reward", reward> now, optional_in<"done", done> over) {
    if (now.fresh()) sum += now[reward_axis{}];
    if (over && over.fresh() && over[done_axis{}] != 0) is_over = true;
  }

  double sum = 0;
  bool is_over = false;
};

}  // namespace cca::python
