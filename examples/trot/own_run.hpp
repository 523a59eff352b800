#pragma once
// A run in steps that has its controller, for many at once (cca/sim/rollouts.hpp):
//
//   cores.rollouts(count, [&](std::size_t i) {
//     return trot::run_of(start, [&, i](auto& c) { return a run_in_steps of c; }, judge);
//   });
//
// `begin(controller)` puts the robot down and returns its run; `judge(recording, controller)` is the result.
// The robot is `trot::beside<World>`, so runs in compiled physics share the lanes of a vector.
#include <type_traits>
#include <utility>

#include <cca/sim/compiled/together/side_by_side.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "engines/any.hpp"

namespace trot {

namespace detail {
template <class World>
struct world_beside {
  using type = World;
};
template <>
struct world_beside<cca::sim::compiled_oncilla_world> {
  using type = cca::sim::side_by_side<cca::sim::compiled_oncilla_world>;
};
}  // namespace detail

// The world in which many runs are made: side by side, where it can be.
template <class World>
using beside = typename detail::world_beside<World>::type;

template <class Controller, class Begin, class Judge>
class own_run {
public:
  own_run(const Controller& start, Begin begin, Judge judge)
      : controller_(start), run_(begin(controller_)), judge_(std::move(judge)) {}
  own_run(const own_run&) = delete;  // the run points to the controller
  own_run& operator=(const own_run&) = delete;

  bool step() { return run_.step(); }
  auto& world() { return run_.world(); }
  auto result() { return judge_(run_.result(), controller_); }

private:
  Controller controller_;
  std::invoke_result_t<Begin&, Controller&> run_;
  Judge judge_;
};

// The controller is a copy of `start`, which is not started. It is loaded, or `begin` loads it.
template <class Controller, class Begin, class Judge>
auto run_of(const Controller& start, Begin begin, Judge judge) {
  return own_run<Controller, Begin, Judge>(start, std::move(begin), std::move(judge));
}

}  // namespace trot
