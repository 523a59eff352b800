// Runs an architecture on the library, to compare what its components record with what the interpreter does.
#pragma once

#include <memory>
#include <vector>

#include <cca/cca.hpp>

#include "outcome.hpp"
#include "probe.hpp"

namespace semantics {

// What happens before and after each beat. Here: nothing.
struct in_the_loop {
  template <class Controller>
  static void before(Controller&, int) {}
  template <class Controller>
  static void settle(Controller&) {}
};

template <class Graph, class Around = in_the_loop>
outcome run(int copy_at) {
  outcome o;
  log of_copy;
  std::size_t before_copy = 0;
  recording = &o.firings;
  auto c = std::make_unique<cca::controller<Graph>>();
  std::unique_ptr<cca::controller<Graph>> copy;
  const auto step = [](cca::controller<Graph>& which, int k) {
    Around::before(which, k);
    which.step();
    if (which.state() != cca::state::faulted) Around::settle(which);
  };
  c->load();
  c->start();
  for (int k = 0; k < beats; ++k) {
    if (k == copy_at) {
      copy = std::make_unique<cca::controller<Graph>>(*c);
      before_copy = o.firings.size();
    }
    step(*c, k);
  }
  recording = &of_copy;
  for (int k = copy_at; k < beats && copy->state() != cca::state::faulted; ++k) step(*copy, k);
  recording = nullptr;
  o.faulted = c->state() == cca::state::faulted;
  o.copy_agrees = agree(o.firings, before_copy, of_copy) && copy->state() == c->state();
  return o;
}

}  // namespace semantics
