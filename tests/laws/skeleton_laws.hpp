// The laws of a skeleton, stated once and run over every skeleton.
//
// A case is a graph of one skeleton between sources and a sink:
//   Case::graph                with a node "end" that records `values`, `beats` (of arrival) and `origins`
//   Case::value                the number that each source publishes along each axis, in every beat
//   Case::feed(controller)     changes the sources before a beat
//   Case::settle(controller)   optional: waits, outside of a beat, until all input is worked off
//   Case::oldest(beat)         the oldest origin, in beats, that a sample arriving in that beat may have
// `laws::allocations()` counts calls of malloc; the test program defines it.
#pragma once

#include <cstddef>
#include <vector>

#include <doctest/doctest.h>

#include <cca/cca.hpp>

#include "law.hpp"

namespace laws {

std::size_t allocations();

template <class Case>
auto begun() {
  cca::controller<typename Case::graph> c;
  c.load();
  c.start();
  return c;
}

template <class Case, class Controller>
void beats(Controller& c, int count) {
  for (int k = 0; k < count; ++k) {
    Case::feed(c);
    c.step();
    if constexpr (requires { Case::settle(c); }) Case::settle(c);
  }
}

// A beat allocates nothing.
template <class Case>
void allocates_nothing() {
  auto c = begun<Case>();
  c.template get<"end">().reserve(400);
  beats<Case>(c, 50);
  std::size_t allocated = 0;
  for (int k = 0; k < 200; ++k) {
    Case::feed(c);
    const std::size_t before = allocations();
    c.step();
    allocated += allocations() - before;
    if constexpr (requires { Case::settle(c); }) Case::settle(c);
  }
  CHECK_MESSAGE(allocated == 0, Case::name << ": a beat allocates nothing");
}

// No origin is later than the beat, older than the inputs allow, or earlier than that of the sample before.
template <class Case>
void keeps_origin_and_order() {
  auto c = begun<Case>();
  beats<Case>(c, 200);
  const auto& end = c.template get<"end">();
  REQUIRE_MESSAGE(end.origins.size() > 5, Case::name << ": something came out");
  for (std::size_t i = 0; i < end.origins.size(); ++i) {
    const auto origin = end.origins[i] / c.period();
    CHECK_MESSAGE(origin * c.period() == end.origins[i],
                  Case::name << ": an origin is that of a beat in which something was made");
    CHECK_MESSAGE(origin <= end.beats[i], Case::name << ": nothing comes from the future");
    CHECK_MESSAGE(origin >= Case::oldest(end.beats[i]),
                  Case::name << ": no older than its sources, in beat " << end.beats[i] << " of " << origin);
    if (i > 0) CHECK_MESSAGE(end.origins[i] >= end.origins[i - 1], Case::name << ": order is kept");
  }
}

// If all sources publish the same value, it comes out unchanged.
template <class Case>
void adds_nothing() {
  auto c = begun<Case>();
  beats<Case>(c, 200);
  const auto& end = c.template get<"end">();
  REQUIRE_MESSAGE(end.values.size() > 5, Case::name << ": something came out");
  for (std::size_t i = 0; i < end.values.size(); ++i)
    CHECK_MESSAGE((end.values[i].array() - Case::value).abs().maxCoeff() < 1e-12,
                  Case::name << ": what goes in is what comes out");
}

// Two runs, and a copy made in the middle, give the same, bit for bit.
template <class Case>
void is_deterministic() {
  auto a = begun<Case>(), b = begun<Case>();
  beats<Case>(a, 73);  // in the middle of any period
  beats<Case>(b, 73);
  auto copy = a;
  beats<Case>(a, 70);
  beats<Case>(b, 70);
  beats<Case>(copy, 70);
  const auto &x = a.template get<"end">(), &y = b.template get<"end">(), &z = copy.template get<"end">();
  CHECK_MESSAGE((x.values == y.values && x.beats == y.beats && x.origins == y.origins),
                Case::name << ": the same again");
  CHECK_MESSAGE((x.values == z.values && x.beats == z.beats && x.origins == z.origins),
                Case::name << ": a copy goes on alike");
}

// All laws.
template <class Case>
void skeleton() {
  static_assert(cca::well_formed<typename Case::graph>);
  law("allocates nothing", allocates_nothing<Case>);
  law("keeps origin and order", keeps_origin_and_order<Case>);
  law("adds nothing", adds_nothing<Case>);
  law("is deterministic", is_deterministic<Case>);
}

}  // namespace laws
