// Runs that go in steps, and how a thread makes several of them at once.
//
//   struct my_run {
//     controller<beside> c;                       // its robot: cca::sim::robot<R, side_by_side<compiled>>
//     std::size_t left = 5000;
//     bool step() { return left-- > 0 && !world().trouble() && c.step(); }
//     auto& world() { return c.get<"robot.simulator">().world(); }
//     double result() { return world().end("arm").velocity.norm(); }
//   };
//
// `step()` makes a beat of the controller, looks first at what the last one has brought, and says whether the
// run goes on; its world waits. When all runs of a thread have made their step, their worlds advance together
// (cca/sim/compiled/lanes/side_by_side.hpp). Once a step has said no, `result()` is taken.
//
// A world of another kind advances within the step, and a thread makes such runs one after the other.
// `made(run)` makes one alone.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace cca::sim {

template <class Run> concept RunInSteps = requires(Run& run) {
  { run.step() } -> std::same_as<bool>;
  run.world();
  run.result();
};

// A whole run, for a caller that has only this one.
template <RunInSteps Run>
auto made(Run& run) {
  while (run.step())
    if constexpr (requires { run.world().waits(); }) advance_together(std::array{&run.world()});
  return run.result();
}

namespace detail {

// What stands at i.
template <class Run>
struct result_of_run {
  using type = Run;
};
template <RunInSteps Run>
struct result_of_run<Run> {
  using type = std::remove_cvref_t<decltype(std::declval<Run&>().result())>;
};

template <class Run>
using world_of_run = std::remove_cvref_t<decltype(std::declval<Run&>().world())>;
template <class Run>
inline constexpr std::size_t runs_at_once = [] {
  if constexpr (requires { world_of_run<Run>::at_once; }) return world_of_run<Run>::at_once;
  else return std::size_t{1};
}();

// Runs in steps, as many at once as go side by side. `next(is_idle)`: the number of a run to begin, or none;
// `is_idle`: no other run is under way.
template <class Run, class Begin, class Next, class Keep, class Failed>
class runs_side_by_side {
public:
  runs_side_by_side(Begin& b, Next& n, Keep& k, Failed& f) : begin(b), next(n), keep(k), failed(f) {}

  void make() {
    while (step_all())
      if constexpr (runs_at_once<Run> > 1) advance_together(std::span(worlds).first(going));
  }

private:
  struct place {
    std::size_t number = 0;
    std::unique_ptr<Run> run;
  };

  bool step_all() {
    going = 0;
    for (std::size_t k = 0; k < places.size(); ++k)
      while (is_taken(places[k], k))
        if (goes_on(places[k])) {
          if constexpr (runs_at_once<Run> > 1) worlds[going] = &places[k].run->world();
          ++going;
          break;
        }
    return going > 0;
  }
  bool is_taken(place& p, std::size_t at) {
    if (p.run) return true;
    bool is_idle = going == 0;
    for (std::size_t k = at + 1; k < places.size(); ++k) is_idle = is_idle && !places[k].run;
    const std::optional<std::size_t> number = next(is_idle);
    if (number) p.number = *number;
    return number.has_value();
  }
  // False: this run is over.
  bool goes_on(place& p) {
    try {
      if (!p.run) p.run.reset(new Run(begin(p.number)));
      if (p.run->step()) return true;
      keep(p.number, p.run->result());
    } catch (...) { failed(p.number); }
    p.run.reset();
    return false;
  }

  Begin& begin;
  Next& next;
  Keep& keep;
  Failed& failed;
  std::array<place, runs_at_once<Run>> places;
  std::array<world_of_run<Run>*, runs_at_once<Run>> worlds{};
  std::size_t going = 0;
};

// All that `next` gives, on this thread. `keep(i, result)`; `failed(i)` is called where an exception is
// handled.
template <class Run, class Next, class Keep, class Failed>
void make_runs(Run& run, Next next, Keep keep, Failed failed) {
  using returned = std::invoke_result_t<Run&, std::size_t>;
  if constexpr (RunInSteps<returned>) {
    runs_side_by_side<returned, Run, Next, Keep, Failed>(run, next, keep, failed).make();
  } else {
    while (const std::optional<std::size_t> i = next(true)) try {
        keep(*i, run(*i));
      } catch (...) { failed(*i); }
  }
}

}  // namespace detail
}  // namespace cca::sim
