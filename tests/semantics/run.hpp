// Runs an architecture on the library, to compare what its components record with what the interpreter does.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include <cca/cca.hpp>

#include "outcome.hpp"
#include "probe.hpp"

namespace semantics {

// What somebody does before and after each beat. Here: nothing.
struct in_the_loop {
  static constexpr bool gives_orders = false;  // also by live_access
  template <class Controller>
  static void before(Controller&, int, bool = false) {}
  template <class Controller>
  static void settle(Controller&) {}
};

// Each port that the graphs of `c` observe is a firing.
template <class Played>
void look_if_it_is_time(Played& c, int k, std::span<const int> looks) {
  if (c.state() == cca::state::faulted || !std::binary_search(looks.begin(), looks.end(), k)) return;
  log seen;
  c.observed([&](const cca::observation& one) {
    firing f;
    f.id = looker;
    f.which = function::look;
    f.beat = k;
    add_input(f, one.path, one.values.data(), static_cast<int>(one.values.size()), one.origin, one.fresh,
              true);
    seen.push_back(f);
  });
  for (const firing& f : in_order_of_content(seen)) record(f);
}

// In processes each one asks: a process refuses it for components of another one, which does it.
inline bool is_alone = true;
inline int own_environment = 0;
inline bool is_here(int environment) { return is_alone || environment == own_environment; }
template <class F>
void where_it_is(F change) {
  if (is_alone) return change();
  try {
    change();
  } catch (const cca::refused&) {}
}

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
