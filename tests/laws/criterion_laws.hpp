// The laws of a Criterion, stated once: those of every criterion, and those of criteria that measure a
// distance.
//
// A case of any criterion has `Case::made()`, a criterion with a hold time of 10 beats of 1 ms, and
// `Case::feel(criterion, what, k)`, its state in beat k. A case of a distance has `Case::criterion` and
// `Case::at(error)`, target and feedback at that distance.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include <cca/adaptive/criterion.hpp>

#include "ode_laws.hpp"

namespace laws {

enum class circumstance { nothing, as_wanted, not_yet, no_number };

template <class Case>
void any_criterion() {
  using enum cca::criterion_state;
  using enum circumstance;
  auto one = Case::made();
  static_assert(cca::Criterion<decltype(one)>);
  std::int64_t k = 0;
  const auto feel = [&](circumstance what, int beats = 1) {
    auto state = open;
    for (int i = 0; i < beats; ++i) state = Case::feel(one, what, k++);
    return state;
  };
  CHECK_MESSAGE(feel(nothing, 50) == open, "before any sample it is open");
  feel(as_wanted);  // the first sample, for criteria that use a speed
  feel(not_yet);
  CHECK_MESSAGE(feel(as_wanted, 9) != fulfilled, "not fulfilled before the hold time");
  feel(not_yet);
  CHECK_MESSAGE(feel(as_wanted, 9) != fulfilled, "it must hold without a break");
  CHECK_MESSAGE(feel(as_wanted, 2) == fulfilled, "fulfilled after the hold time");
  CHECK_MESSAGE(feel(not_yet) != fulfilled, "no longer fulfilled once the condition fails");
  feel(as_wanted, 20);
  CHECK_MESSAGE(feel(no_number) != fulfilled, "NaN does not fulfil it");
  CHECK_MESSAGE(feel(as_wanted, 20) == fulfilled, "it recovers once finite samples come");
  one.on_start();
  CHECK_MESSAGE(feel(as_wanted) == open, "a start resets it");
  const std::size_t before = allocations();
  feel(as_wanted, 30), feel(not_yet, 30), feel(no_number, 30);
  CHECK_MESSAGE(allocations() == before, "nothing allocates");
}

// Adapts a criterion of a distance to the laws of any criterion.
template <class Case>
struct by_distance {
  static auto made() {
    typename Case::criterion c;
    c.p.limits = {0.1, 0.2, 0.5, 0.01};
    return c;
  }
  static cca::criterion_state feel(typename Case::criterion& c, circumstance what, std::int64_t k) {
    using in_target = cca::in<"target", typename Case::space>;
    using in_feedback = cca::in<"feedback", typename Case::space>;
    const auto [target, feedback] = Case::at(what == circumstance::as_wanted ? 0.05
                                             : what == circumstance::not_yet ? 0.3
                                                                             : std::nan(""));
    const auto [e, s] = what == circumstance::nothing
                            ? c.process(in_target(), in_feedback(), cca::beat(k, 1'000'000, 1))
                            : c.process(in_target(target, k, true), in_feedback(feedback, k, true),
                                        cca::beat(k, 1'000'000, 1));
    return static_cast<cca::criterion_state>(s.vector()[0]);
  }
};

template <class Case>
class criterion_rig {
public:
  using criterion = typename Case::criterion;
  criterion c = by_distance<Case>::made();

  // The state after `beats` beats of 1 ms at this distance.
  cca::criterion_state feel(double error, int beats = 1) {
    double state = 0;
    for (int i = 0; i < beats; ++i, ++k) {
      const auto [target, feedback] = Case::at(error);
      using in_target = cca::in<"target", typename Case::space>;
      using in_feedback = cca::in<"feedback", typename Case::space>;
      const auto [e, s] =
          c.process(in_target(target, k, true), in_feedback(feedback, k, true), cca::beat(k, 1'000'000, 1));
      if (std::isfinite(error))
        CHECK_MESSAGE(std::abs(e.vector()[0] - error) < 1e-9, "its error is the distance");
      state = s.vector()[0];
    }
    return static_cast<cca::criterion_state>(state);
  }

private:
  std::int64_t k = 0;
};

template <class Case>
void judges_by_distance() {
  static_assert(cca::Criterion<typename Case::criterion>);
  using enum cca::criterion_state;
  {
    criterion_rig<Case> one;
    const cca::in<"feedback", typename Case::space> come(Case::at(0.05).second, 0, true);
    for (int k = 0; k < 50; ++k) {
      const auto [e, s] = one.c.process({}, come, cca::beat(k, 1'000'000, 1));
      CHECK_MESSAGE(s.vector()[0] == cca::status_of(open), "before both inputs have a sample it is open");
      CHECK_MESSAGE(e.vector()[0] == 0, "and its error is 0");
    }
  }
  criterion_rig<Case> one;
  CHECK_MESSAGE(one.feel(0.05, 9) == open, "not fulfilled before the hold time");
  CHECK_MESSAGE(one.feel(0.05) == fulfilled, "then it is fulfilled");
  CHECK_MESSAGE(one.feel(0.15, 50) == fulfilled, "between `within` and `until` it stays so");
  CHECK_MESSAGE(one.feel(0.25) == open, "beyond `until` it is open, at once");
  CHECK_MESSAGE(one.feel(0.15, 50) == open, "between `until` and `within` it stays so");
  CHECK_MESSAGE(one.feel(0.05, 9) == open, "the hold time counts again");
  CHECK_MESSAGE(one.feel(0.15) == open, "a break resets the hold time");
  CHECK_MESSAGE(one.feel(0.05, 9) == open, "a break resets the hold time");
  CHECK_MESSAGE(one.feel(0.05) == fulfilled, "then it is fulfilled");
  CHECK_MESSAGE(one.feel(0.6, 9) == open, "above `lost`, but not for long");
  CHECK_MESSAGE(one.feel(0.6) == lost, "above `lost` for the hold time: lost");
  CHECK_MESSAGE(one.feel(0.3, 50) == lost, "between `lost` and `until` it stays so");
  CHECK_MESSAGE(one.feel(0.15) == open, "below `until` it is open again");
  CHECK_MESSAGE(one.feel(0.6, 9) == open, "the time to be lost counts again");
  one.feel(0.15);
  CHECK_MESSAGE(one.feel(std::numeric_limits<double>::quiet_NaN()) == lost, "NaN is lost at once");
  for (const double error : {0.05, 0.05, 0.6, 0.6}) {
    one.c.on_start();
    CHECK_MESSAGE(one.feel(error, 9) == open, "after a start the hold time counts again");
  }
}

template <class Case>
void criterion() {
  law("judges as every criterion does", any_criterion<by_distance<Case>>);
  law("judges by the distance", judges_by_distance<Case>);
}

}  // namespace laws
