// EXPECT no_number: cca::sim::rollouts: a run takes its number, and returns what is to be kept of it: a value that can be moved
// EXPECT by_reference: cca::sim::rollouts: a run takes its number, and returns what is to be kept of it: a value that can be moved
// EXPECT says_nothing: cca::sim::rollouts: what a run returns looks like a run in steps, but is none: one has `bool step\(\)`, `result\(\)`, and `world\(\)`, which returns a reference that is not const
// EXPECT no_world: cca::sim::rollouts: what a run returns looks like a run in steps, but is none
// EXPECT copied_world: cca::sim::rollouts: what a run returns looks like a run in steps, but is none
// EXPECT const_world: cca::sim::rollouts: what a run returns looks like a run in steps, but is none
// EXPECT no_result: cca::sim::rollouts: what a run returns looks like a run in steps, but is none
// EXPECT fixed_result: cca::sim::rollouts: the `result\(\)` of a run in steps returns what is to be kept of it: a value that can be moved
// EXPECT copied_result: cca::sim::rollouts: the `result\(\)` of a run in steps returns what is to be kept of it: a value that can be moved
// EXPECT nothing_kept: cca::sim::rollouts: the `result\(\)` of a run in steps returns what is to be kept of it: a value that can be moved
// LINES: 25
// Which runs cca::sim::rollouts takes, and its messages for others.
#include <cstddef>
#include <memory>

#include <cca/sim/rollouts.hpp>

namespace broken {

struct place {};
struct whole {
  place w;
  bool step() { return false; }
  place& world() { return w; }
  int result() { return 1; }
};
struct fixed {
  fixed() = default;
  fixed(const fixed&) = delete;
};

struct no_number {
  int operator()() const { return 1; }
};
struct by_reference {
  int* kept = nullptr;
  int& operator()(std::size_t) const { return *kept; }
};
template <class Run>
struct returns {
  Run operator()(std::size_t) const { return {}; }
};
struct without_yes : whole {
  void step() {}
};
struct without_world {
  bool step() { return false; }
  int result() { return 1; }
};
struct with_copy : whole {
  place world() { return w; }
};
struct with_const : whole {
  const place& world() const { return w; }
};
struct without_result {
  place w;
  bool step() { return false; }
  place& world() { return w; }
};
struct with_fixed : whole {
  fixed result() { return {}; }
};
struct with_reference : whole {
  std::unique_ptr<int> kept;
  std::unique_ptr<int>& result() { return kept; }
};
struct with_nothing : whole {
  void result() {}
};

using says_nothing = returns<without_yes>;
using no_world = returns<without_world>;
using copied_world = returns<with_copy>;
using const_world = returns<with_const>;
using no_result = returns<without_result>;
using fixed_result = returns<with_fixed>;
using copied_result = returns<with_reference>;
using nothing_kept = returns<with_nothing>;
using none = returns<whole>;

}  // namespace broken

#ifndef CCA_REJECT
#define CCA_REJECT none
#endif
void make() { cca::sim::rollouts(4, broken::CCA_REJECT{}); }
