// A twin of a robot that runs: the same controller on another machine is fed with what the robot's resource
// nodes sensed, goes through the same life-cycle with the same parameters and modes, and compares each sample
// that it computes with a hash of the robot's.
//
//   cca::recording::twin<trot> twin;
//   twin.take(bytes);                 // of the stream that a door sends, as they come (docs/door.md)
//   std::cout << twin.result();       // 160000 samples of 20000 beats, bit for bit as recorded
//   twin.result().component           // of the first difference; also port, beat; empty: there is none
//
// Both must be built to compute the same bits (docs/same_bits.md). The stream begins with the first beat of
// the run. The last beat that came is compared when the one after it comes.
//
// `Graph`: a graph, a set of modes or a deployment, which is computed in one loop. Its resource nodes neither
// sense nor act, and their hooks don't run. What a program gives to its components beside parameters it gives
// to `controller()` before the first bytes.
//
// Errors: `take` throws cca::refused if the stream is of another architecture, is damaged, or has parameters
// that a component can't have. Test: tests/runtime/record/twin.cpp.
#pragma once

#include <span>

#include <cca/graph/marks/unmarked.hpp>
#include <cca/record/replay/replay_run.hpp>
#include <cca/record/replay/result.hpp>
#include <cca/record/replay/twin_items.hpp>

namespace cca::recording {

template <class Graph>
class twin {
  static_assert(
      cca::detail::holds_or_tells<cca::detail::Recordable<Graph>,
                                  cca::detail::unmarked<Graph, cca::detail::observer::replay>>::value);

public:
  twin() = default;
  twin(const twin&) = delete;
  twin& operator=(const twin&) = delete;

  auto& controller() { return run.robot(); }
  const replay_result& take(std::span<const unsigned char> bytes) {
    run.source().add(bytes);
    return run.play_what_came();
  }
  const replay_result& result() { return run.play_what_came(); }

private:
  detail::replay_run<Graph, detail::twin_items<Graph>> run{"the robot"};
};

}  // namespace cca::recording
