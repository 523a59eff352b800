// The first broken rule of a set of modes: that of its first broken mode, or one of the set itself.
#pragma once

#include <cca/graph/verdict/diagnosis.hpp>
#include <cca/graph/modes/layout_of_modes.hpp>

namespace cca::detail {

template <Modes M>
inline constexpr bool has_plan<M> = true;

// The graph of the first mode that is broken or no graph; else the set itself.
template <class M, class Items>
struct first_broken {
  using type = M;
};
template <class M, class Item, class... More>
struct first_broken<M, list<Item, More...>> : first_broken<M, list<More...>> {};
template <class M, fixed_string Name, class G, class... More>
  requires(!broken_by<G>().empty())
struct first_broken<M, list<mode<Name, G>, More...>> {
  using type = G;
};

template <Modes M>
struct told_of<M> {
  using rules = rules_of_modes::type;
  using writer = writer_of_modes;
};

template <Modes M>
struct diagnosed<M> : first_broken<M, typename M::cca_modes> {};

}  // namespace cca::detail
