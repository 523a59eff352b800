// Runs that go in steps, and how a thread makes several of them at once.
//
//   struct my_run {
//     controller<beside> c;                       // its robot: cca::sim::robot<R, side_by_side<compiled>>
//     std::size_t left = 5000;
//     auto& world() { return c.get<"robot.simulator">().world(); }
//     bool step() { return left-- > 0 && !world().trouble() && c.step(); }
//     double result() { return world().end("arm").velocity.norm(); }
//   };
//
// `step()` makes a beat of the controller, looks first at what the last one has brought, and says whether the
// run goes on; its world waits. When all runs of a thread have made their step, their worlds advance together
// (cca/sim/compiled/together/side_by_side.hpp). Once a step has said no, `result()` is taken; a beat that its
// world still waits for is made before.
//
// A world of another kind advances within the step, and a thread makes such runs one after the other.
// `made(run)` makes one alone.
// Test: tests/runtime/compiled_world/rollouts_in_steps.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace cca::sim {

// `world()` returns a reference.
template <class Run> concept RunInSteps = requires(Run& run) {
  { run.step() } -> std::same_as<bool>;
  requires std::is_lvalue_reference_v<decltype(run.world())>;
  requires !std::is_const_v<std::remove_reference_t<decltype(run.world())>>;
  run.result();
};

namespace detail {

// The beat that its world still waits for, if it does.
template <class Run>
void advance_alone(Run& run) {
  if constexpr (requires { run.world().waits(); }) run.world().advance_alone();
}

}  // namespace detail

// A whole run, for a caller that has only this one.
template <RunInSteps Run>
auto made(Run& run) {
  while (run.step()) detail::advance_alone(run);
  detail::advance_alone(run);
  return run.result();
}

namespace detail {

// Meant as a run in steps: no result has these names together.
template <class Run> concept LooksLikeRunInSteps =
    requires(Run& run) { run.step(), run.world(); } || requires(Run& run) { run.step(), run.result(); };

// What stands at i.
template <class Run>
struct result_of_run {
  using type = Run;
};
template <RunInSteps Run>
struct result_of_run<Run> {
  using type = std::remove_cvref_t<decltype(std::declval<Run&>().result())>;
};
// A result that is returned by a reference is copied.
template <class Run>
inline constexpr bool keeps_result = std::move_constructible<Run>;
template <RunInSteps Run>
inline constexpr bool keeps_result<Run> =
    std::move_constructible<typename result_of_run<Run>::type> &&
    std::constructible_from<typename result_of_run<Run>::type, decltype(std::declval<Run&>().result())>;

template <class Run>
using world_of_run = std::remove_reference_t<decltype(std::declval<Run&>().world())>;
template <class Run>
inline constexpr std::size_t runs_at_once = 1;
template <RunInSteps Run>
  requires requires { world_of_run<Run>::at_once; }
inline constexpr std::size_t runs_at_once<Run> = world_of_run<Run>::at_once;

// How many of `count` runs each of `threads` makes at once: none takes what another one could begin now.
template <class Run>
std::size_t places_of_thread(std::size_t count, std::size_t threads) {
  const std::size_t share = count / threads + (count % threads > 0 ? 1 : 0);
  return std::clamp<std::size_t>(share, 1, runs_at_once<Run>);
}

// Runs in steps, up to `at_once` of them side by side.
template <class Run, class Begin, class Next, class Keep, class Failed>
class runs_side_by_side {
  static constexpr bool goes_beside = runs_at_once<Run> > 1;
  using world = world_of_run<Run>;

public:
  runs_side_by_side(std::size_t at_once, Begin& b, Next& n, Keep& k, Failed& f)
      : count(std::min(at_once, places.size())), begin(b), next(n), keep(k), failed(f) {}

  void make() {
    while (step_all())
      if constexpr (goes_beside) advance_together(std::span<world* const>(worlds.data(), going));
  }

private:
  struct place {
    std::size_t number = 0;
    std::unique_ptr<Run> run{};
  };

  bool step_all() {
    going = 0;
    for (std::size_t k = 0; k < count; ++k)
      while (is_taken(k) && !goes_on(places[k])) {}
    return going > 0;
  }
  bool is_taken(std::size_t k) {
    if (places[k].run) return true;
    bool is_idle = going == 0;
    for (std::size_t later = k + 1; later < count; ++later) is_idle = is_idle && !places[later].run;
    const std::optional<std::size_t> number = next(is_idle);
    if (number) places[k].number = *number;
    return number.has_value();
  }
  // False: this run is over.
  bool goes_on(place& p) {
    try {
      if (!p.run) p.run.reset(new Run(begin(p.number)));
      if (p.run->step()) {
        if constexpr (goes_beside) worlds[going] = &p.run->world();
        ++going;
        return true;
      }
      advance_alone(*p.run);
      keep(p.number, p.run->result());
    } catch (...) { failed(p.number); }
    p.run.reset();
    return false;
  }

  std::array<place, runs_at_once<Run>> places;
  std::array<world*, runs_at_once<Run>> worlds{};
  std::size_t count, going = 0;
  Begin& begin;
  Next& next;
  Keep& keep;
  Failed& failed;
};

// On this thread, up to `at_once` at once: all runs that `next` gives. `next(is_idle)`: the number of a run
// to begin, or none; `is_idle`: no run is under way, so it may wait for one, and none ends this. It is asked
// in each beat while there is room. `keep(i, result)`; `failed(i)` is called where an exception is handled.
template <class Run, class Next, class Keep, class Failed>
void make_runs(Run& run, std::size_t at_once, Next next, Keep keep, Failed failed) {
  using returned = std::invoke_result_t<Run&, std::size_t>;
  if constexpr (RunInSteps<returned>) {
    runs_side_by_side<returned, Run, Next, Keep, Failed>(at_once, run, next, keep, failed).make();
  } else {
    while (const std::optional<std::size_t> i = next(true)) try {
        keep(*i, run(*i));
      } catch (...) { failed(*i); }
  }
}

}  // namespace detail
}  // namespace cca::sim
