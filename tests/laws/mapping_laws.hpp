// The laws of mappings, each stated once and run for every model.
//
// A model has two mappings, `Forward` and `Inverse`; `Model::random(source)`, a point where both are defined;
// and `Model::close(a, b)` for vectors of the input space of Forward.
#pragma once

#include <cca/cca.hpp>
#include <cca/mapping/mapping_chain.hpp>

#include "space_laws.hpp"

namespace laws {

std::size_t allocations();  // the number so far, by new and delete (allocations.cpp)

// Calls a mapping directly; returns the outputs as a tuple.
template <class Mapping, class Vector>
auto map_all(Mapping& m, const Vector& v) {
  return cca::detail::call_mapping(m, cca::sample<cca::input_space<Mapping>>(v), cca::beat{0, 1'000'000, 1});
}
template <class Mapping, class Vector>
auto map(Mapping& m, const Vector& v) {
  return cca::detail::output_in(map_all(m, v)).vector();
}

// Each mapping undoes the other; a mapping gives the same answer twice; neither allocates.
template <class Model>
void inverse() {
  source random{std::mt19937_64{11}};
  typename Model::forward there;
  typename Model::inverse back;
  static_assert(cca::Mapping<typename Model::forward> && cca::Mapping<typename Model::inverse>);
  static_assert(
      cca::SameSpace<cca::output_space<typename Model::forward>, cca::input_space<typename Model::inverse>>);
  static_assert(
      cca::SameSpace<cca::input_space<typename Model::forward>, cca::output_space<typename Model::inverse>>);
  for (int i = 0; i < rounds; ++i) {
    const auto x = Model::random(random);
    const std::size_t before = allocations();
    const auto y = map(there, x);
    const auto again = map(back, y);
    const std::size_t allocated = allocations() - before;  // read before the checks, which allocate
    CHECK_MESSAGE(allocated == 0, "nothing allocates");
    CHECK_MESSAGE(Model::close(again, x), "the inverse undoes the mapping: ", x.transpose(), " became ",
                  again.transpose());
    CHECK_MESSAGE((map(there, again) - y).norm() < 1e-9, "and the mapping gives the same point again");
    CHECK_MESSAGE(map(there, x) == y, "the same answer twice");
  }
}

}  // namespace laws
